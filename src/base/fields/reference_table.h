// Every field of a described type, one row each: what `tread describe` and the documentation show.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <variant>
#include <vector>

#include "base/fields/field_path.h"
#include "base/fields/visitors.h"
#include "base/text/did_you_mean.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

struct ReferenceRow {
    std::string path;  // "front.damper.bump"; "gears.0" for the elements of a list
    std::string unit;
    std::string meaning;
    std::string limits;          // "at least 0"; the names of an enum; empty when every value is allowed
    std::string default_text;    // "required" when the file must say
    double tolerance = 0;        // as in About
    std::string plausible = {};  // "0.02 to 3"; empty when the description says none
};

namespace detail {

// The rows so far, and the types around the current field: a type that contains itself is not opened again.
struct ReferenceRows {
    std::vector<ReferenceRow> rows;
    std::vector<std::type_index> open_types;

    void add(const std::string& path, const About& about, std::string limits, std::string default_text);
    bool opens(std::type_index type);
};

// Defaults of leaves, and the limits of numbers, as text.
std::string defaultText(double value);
std::string defaultText(int value);
std::string defaultText(bool value);
std::string defaultText(const std::string& value);
std::string defaultText(const Curve& value);
std::string limitsOf(const About& about);

template <class T>
void FieldsOf<T>::addRows(ReferenceRows& table, const std::string& path, const T& object) {
    if (!table.opens(typeid(T))) return;
    T::describe(object, [&](std::string_view name, const auto& value, const About& about) {
        detail::addRows(table, joinPath(path, name), value, about);
    });
    table.open_types.pop_back();
}

template <class... T>
void addAlternativeRows(ReferenceRows& table, const std::string& path, const std::variant<T...>& variant,
                        const About& about) {
    constexpr std::array<std::string_view, sizeof...(T)> kNames{T::kName...};
    table.add(path, about, listed(kNames), std::string(kNames[variant.index()]));
    (FieldsOf<T>::addRows(table, joinPath(path, T::kName), T{}), ...);
}

template <class T>
void addRows(ReferenceRows& table, const std::string& path, const T& value, const About& about) {
    if constexpr (DescribedEnum<T>) {
        constexpr auto kNames = enumNames(T{});
        table.add(path, about, listed(kNames), std::string(kNames[static_cast<std::size_t>(value)]));
    } else if constexpr (IsVariant<T>::value) {
        addAlternativeRows(table, path, value, about);
    } else if constexpr (IsOptional<T>::value) {
        if constexpr (Described<typename T::value_type>) table.add(path, about, "", "absent");
        const std::size_t first = table.rows.size();
        addRows(table, path, typename T::value_type{}, about);
        if (!Described<typename T::value_type>) table.rows[first].default_text = "absent";
    } else if constexpr (IsVector<T>::value) {
        table.add(path, about, "a list", value.empty() ? "empty" : std::to_string(value.size()) + " elements");
        addRows(table, joinPath(path, "0"), typename T::value_type{}, about);
    } else if constexpr (Described<T>) {
        FieldsOf<T>::addRows(table, path, value);
    } else {
        table.add(path, about, limitsOf(about), defaultText(value));
    }
}

}  // namespace detail

// The fields of a type in the order of its description, with the defaults of a fresh object.
template <Described T>
std::vector<ReferenceRow> referenceTable() {
    detail::ReferenceRows table;
    detail::FieldsOf<T>::addRows(table, "", T{});
    return std::move(table.rows);
}

}  // namespace tread
