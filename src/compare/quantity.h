// A number whose unit may be written beside it: that in which the program holds what it is compared with is known
// later.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tread/describe.h"

namespace tread {

struct Quantity {
    double value = kRequired;
    std::string unit;  // empty: that of what it is compared with

    Quantity() = default;
    Quantity(double number, std::string its_unit = {}) : value(number), unit(std::move(its_unit)) {}
    bool operator==(const Quantity&) const = default;

    // Nothing, and what is wrong in `fault`, when the unit measures something else.
    std::optional<double> in(std::string_view wanted, std::string& fault) const;
};

// ---- What the visitors of descriptions do with it ----

class YamlReader;
struct YamlPlace;
struct YamlItem;

namespace detail {

class SchemaBuilder;
struct ReferenceRows;

template <class T>
void readValue(const YamlReader& reader, const YamlPlace& place, T& value, const About& about);
template <>
void readValue<Quantity>(const YamlReader& reader, const YamlPlace& place, Quantity& value, const About& about);

template <class T>
YamlItem itemOf(std::string_view name, const T& value, const About& about);
template <>
YamlItem itemOf<Quantity>(std::string_view name, const Quantity& value, const About& about);

template <class T>
bool needsValue(const T& value);
template <>
bool needsValue<Quantity>(const Quantity& value);

template <class T>
std::string schemaOf(SchemaBuilder& builder, const std::string& path, const T& value, const About& about);
template <>
std::string schemaOf<Quantity>(SchemaBuilder& builder, const std::string& path, const Quantity& value,
                               const About& about);

template <class T>
void addRows(ReferenceRows& table, const std::string& path, const T& value, const About& about);
template <>
void addRows<Quantity>(ReferenceRows& table, const std::string& path, const Quantity& value, const About& about);

}  // namespace detail
}  // namespace tread
