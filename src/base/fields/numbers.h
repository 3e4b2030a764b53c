// The numbers of a described object as a flat list of dotted paths: parameter paths for `--set` and sweeps, columns for
// logs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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
void collectNumbers(T& object, const std::string& prefix, std::vector<Number>& out) {
    T::describe(object, [&](std::string_view name, auto& value, const About& about) {
        using Value = std::remove_reference_t<decltype(value)>;
        std::string path = prefix.empty() ? std::string(name) : prefix + "." + std::string(name);
        if constexpr (std::is_same_v<Value, double>) {
            out.push_back({std::move(path), &value, about});
        } else if constexpr (Described<Value>) {
            collectNumbers(value, path, out);
        } else if constexpr (IsOptional<Value>::value) {
            if constexpr (Described<typename Value::value_type>) {
                if (value) collectNumbers(*value, path, out);
            } else if constexpr (std::is_same_v<typename Value::value_type, double>) {
                if (value) out.push_back({std::move(path), &*value, about});
            }
        } else if constexpr (IsVector<Value>::value) {
            for (std::size_t i = 0; i < value.size(); ++i) {
                if constexpr (NamedInPaths<typename Value::value_type>) {
                    collectNumbers(value[i], path + "." + std::string(value[i].pathName()), out);
                } else if constexpr (Described<typename Value::value_type>) {
                    collectNumbers(value[i], path + "." + std::to_string(i), out);
                } else if constexpr (std::is_same_v<typename Value::value_type, double>) {
                    out.push_back({path + "." + std::to_string(i), &value[i], about});
                }
            }
        } else if constexpr (IsVariant<Value>::value) {
            std::visit(
                [&](auto& alternative) {
                    using Alternative = std::remove_reference_t<decltype(alternative)>;
                    collectNumbers(alternative, path + "." + std::string(Alternative::kName), out);
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
    detail::collectNumbers(object, prefix, out);
    return out;
}

}  // namespace tread
