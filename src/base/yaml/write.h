// Writing described structs as YAML: every field, includes resolved, SI numbers with their unit in a comment. What is
// written reads back equal, bit for bit.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "base/fields/visitors.h"
#include "base/yaml/item.h"
#include "tread/describe.h"

namespace tread {
namespace detail {

template <class T>
YamlItem FieldsOf<T>::write(std::string_view name, const T& object) {
    YamlItem map{YamlItem::Kind::map, std::string(name), "", "", {}};
    T::describe(object, [&](std::string_view field, const auto& value, const About& about) {
        map.children.push_back(itemOf(field, value, about));
    });
    return map;
}

// `name: {keep: {...}}`, or the bare `name: keep` when the alternative has nothing to say.
template <class... T>
YamlItem alternativeOf(std::string_view name, const std::variant<T...>& variant) {
    return std::visit(
        [&](const auto& alternative) {
            using Alternative = std::decay_t<decltype(alternative)>;
            YamlItem inner = FieldsOf<Alternative>::write(Alternative::kName, alternative);
            if (!inner.hasValues()) return textItem(name, inner.name);
            return YamlItem{YamlItem::Kind::map, std::string(name), "", "", {std::move(inner)}};
        },
        variant);
}

template <class T>
YamlItem itemOf(std::string_view name, const T& value, const About& about) {
    if constexpr (std::is_same_v<T, double>) {
        return numberItem(name, value, about);
    } else if constexpr (std::is_same_v<T, int>) {
        return {YamlItem::Kind::scalar, std::string(name), std::to_string(value), "", {}};
    } else if constexpr (std::is_same_v<T, bool>) {
        return {YamlItem::Kind::scalar, std::string(name), value ? "true" : "false", "", {}};
    } else if constexpr (std::is_same_v<T, std::string>) {
        return textItem(name, value);
    } else if constexpr (std::is_same_v<T, Curve>) {
        return curveItem(name, value, about);
    } else if constexpr (DescribedEnum<T>) {
        return textItem(name, enumNames(T{})[static_cast<std::size_t>(value)]);
    } else if constexpr (IsVector<T>::value) {
        YamlItem list{YamlItem::Kind::list, std::string(name), "", "", {}};
        if constexpr (std::is_same_v<typename T::value_type, double>)
            list.comment = about.unit == "-" ? "" : about.unit;
        for (const auto& element : value) list.children.push_back(itemOf("", element, about));
        return list;
    } else if constexpr (IsVariant<T>::value) {
        return alternativeOf(name, value);
    } else if constexpr (IsOptional<T>::value) {
        if (value) return itemOf(name, *value, about);
        return {YamlItem::Kind::remark, std::string(name), "not given", "", {}};
    } else {
        static_assert(Described<T>, "a field of this type cannot be written");
        return FieldsOf<T>::write(name, value);
    }
}

}  // namespace detail

template <Described T>
std::string writeYaml(const T& object) {
    return yamlText(detail::FieldsOf<T>::write("", object));
}

}  // namespace tread
