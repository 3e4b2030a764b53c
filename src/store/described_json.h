// Described structs as JSON, by the one list of their fields (tread/describe.h). For the laboratory only: what a game
// embeds has no JSON.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "tread/describe.h"

namespace tread {

// A value as JSON: a described struct as an object in the order of its description, an enumeration by its name, a
// number that is not finite as null.
template <class T>
nlohmann::ordered_json jsonOf(const T& value) {
    using Json = nlohmann::ordered_json;
    if constexpr (Described<T>) {
        Json object = Json::object();
        T::describe(value, [&](std::string_view name, const auto& field, const About&) {
            object[std::string(name)] = jsonOf(field);
        });
        return object;
    } else if constexpr (DescribedEnum<T>) {
        return std::string(enumNames(value)[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_floating_point_v<T>) {
        return std::isfinite(value) ? Json(value) : Json(nullptr);
    } else if constexpr (requires { typename T::mapped_type; }) {
        Json object = Json::object();
        for (const auto& [name, one] : value) object[name] = jsonOf(one);
        return object;
    } else if constexpr (detail::IsVector<T>::value) {
        Json list = Json::array();
        for (const auto& one : value) list.push_back(jsonOf(one));
        return list;
    } else {
        return value;
    }
}

// The value that jsonOf() made. Throws std::invalid_argument that names the field where the JSON holds something else
// or nothing.
template <class T>
void readJson(T& value, const nlohmann::ordered_json& json, const std::string& path = {}) {
    const auto expect = [&](bool fits, const char* what) {
        if (!fits) throw std::invalid_argument((path.empty() ? "" : path + ": ") + "expected " + what);
    };
    const auto below = [&](std::string_view name) {
        return path.empty() ? std::string(name) : path + "." + std::string(name);
    };
    if constexpr (Described<T>) {
        expect(json.is_object(), "an object");
        T::describe(value, [&](std::string_view name, auto& field, const About&) {
            const auto found = json.find(std::string(name));
            expect(found != json.end(), ("the field \"" + std::string(name) + "\"").c_str());
            readJson(field, *found, below(name));
        });
    } else if constexpr (DescribedEnum<T>) {
        const auto names = enumNames(value);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (!json.is_string() || json.template get<std::string>() != names[i]) continue;
            value = static_cast<T>(i);
            return;
        }
        expect(false, "a known name of this enumeration");
    } else if constexpr (std::is_same_v<T, bool>) {
        expect(json.is_boolean(), "true or false");
        value = json.template get<bool>();
    } else if constexpr (std::is_floating_point_v<T>) {
        expect(json.is_number() || json.is_null(), "a number");
        value = json.is_null() ? std::numeric_limits<T>::quiet_NaN() : json.template get<T>();
    } else if constexpr (std::is_integral_v<T>) {
        expect(json.is_number_integer(), "a whole number");
        const bool fits = json.is_number_unsigned() ? std::in_range<T>(json.template get<std::uint64_t>())
                                                    : std::in_range<T>(json.template get<std::int64_t>());
        expect(fits, "a whole number within the range of this field");
        value = json.template get<T>();
    } else if constexpr (requires { typename T::mapped_type; }) {
        expect(json.is_object(), "an object");
        value.clear();
        for (const auto& [name, one] : json.items()) readJson(value[name], one, below(name));
    } else if constexpr (detail::IsVector<T>::value) {
        expect(json.is_array(), "a list");
        value.assign(json.size(), {});
        for (std::size_t i = 0; i < json.size(); ++i) readJson(value[i], json[i], below(std::to_string(i)));
    } else {
        expect(json.is_string(), "a string");
        value = json.template get<std::string>();
    }
}

}  // namespace tread
