// A number whose unit may be written beside it: that in which the program holds what it is compared with is known
// later.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/fields/visitors.h"
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

namespace detail {

template <>
void readValue<Quantity>(const YamlReader& reader, const YamlPlace& place, Quantity& value, const About& about);
template <>
YamlItem itemOf<Quantity>(std::string_view name, const Quantity& value, const About& about);
template <>
bool needsValue<Quantity>(const Quantity& value);
template <>
std::string schemaOf<Quantity>(SchemaBuilder& builder, const std::string& path, const Quantity& value,
                               const About& about);
template <>
void addRows<Quantity>(ReferenceRows& table, const std::string& path, const Quantity& value, const About& about);

}  // namespace detail
}  // namespace tread
