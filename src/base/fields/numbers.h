// The numbers of a described object as a flat list of dotted paths: parameter paths for `--set` and sweeps, columns for
// logs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/fields/visitors.h"
#include "tread/describe.h"

namespace tread {

struct Number {
    std::string path;  // "front.damper.bump"
    double* value;  // inside the object that was flattened; valid as long as that object is neither moved nor resized
    About about;
};

// Elements of a list that are addressed by a name in place of their index: "instruments.mountings.can.x".
template <class T>
concept NamedInPaths = requires(const T& element) {
    std::string_view(element.pathName());
};

namespace detail {

template <class T>
void FieldsOf<T>::addNumbers(T& object, const std::string& prefix, std::vector<Number>& numbers) {
    T::describe(object, [&](std::string_view name, auto& value, const About& about) {
        using Value = std::remove_reference_t<decltype(value)>;
        std::string path = prefix.empty() ? std::string(name) : prefix + "." + std::string(name);
        if constexpr (std::is_same_v<Value, double>) {
            numbers.push_back({std::move(path), &value, about});
        } else if constexpr (Described<Value>) {
            FieldsOf<Value>::addNumbers(value, path, numbers);
        } else if constexpr (IsOptional<Value>::value) {
            if constexpr (Described<typename Value::value_type>) {
                if (value) FieldsOf<typename Value::value_type>::addNumbers(*value, path, numbers);
            } else if constexpr (std::is_same_v<typename Value::value_type, double>) {
                if (value) numbers.push_back({std::move(path), &*value, about});
            }
        } else if constexpr (IsVector<Value>::value) {
            using Element = typename Value::value_type;
            for (std::size_t i = 0; i < value.size(); ++i) {
                if constexpr (NamedInPaths<Element>) {
                    FieldsOf<Element>::addNumbers(value[i], path + "." + std::string(value[i].pathName()), numbers);
                } else if constexpr (Described<Element>) {
                    FieldsOf<Element>::addNumbers(value[i], path + "." + std::to_string(i), numbers);
                } else if constexpr (std::is_same_v<Element, double>) {
                    numbers.push_back({path + "." + std::to_string(i), &value[i], about});
                }
            }
        } else if constexpr (IsVariant<Value>::value) {
            std::visit(
                [&](auto& alternative) {
                    using Alternative = std::remove_reference_t<decltype(alternative)>;
                    FieldsOf<Alternative>::addNumbers(alternative, path + "." + std::string(Alternative::kName),
                                                      numbers);
                },
                value);
        }
    });
}

}  // namespace detail

// Every double of a described object, in the order of its description.
template <Described T>
std::vector<Number> numbers(T& object, const std::string& prefix = {}) {
    std::vector<Number> out;
    detail::FieldsOf<T>::addNumbers(object, prefix, out);
    return out;
}

}  // namespace tread
