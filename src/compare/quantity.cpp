#include "compare/quantity.h"

#include <cmath>

#include "base/fields/reference_table.h"
#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "base/units/units.h"
#include "base/yaml/read.h"
#include "base/yaml/schema.h"
#include "base/yaml/write.h"

namespace tread {

std::optional<double> Quantity::in(std::string_view wanted, std::string& fault) const {
    if (unit.empty()) return value;
    return toSi(numberText(value) + " " + unit, wanted, fault);
}

namespace detail {

template <>
void readValue<Quantity>(const YamlReader& reader, const YamlPlace& place, Quantity& value, const About& about) {
    if (!place.node || place.node->kind != YamlNode::Kind::scalar) {
        reader.number(place, about, value.value);  // absent, or no number at all: says so
        return;
    }
    std::string_view rest = trimmed(place.node->text);
    const auto number = takeNumber(rest);
    const std::string unit(trimmed(rest));
    std::string fault;
    if (!number || !about.limits.allow(*number)) {
        reader.number(place, about, value.value);
    } else if (!parseUnit(unit, fault)) {
        reader.complain(place, fault);
    } else {
        value = {*number, unit};
    }
}

template <>
YamlItem itemOf<Quantity>(std::string_view name, const Quantity& value, const About& about) {
    if (value.unit.empty()) return numberItem(name, value.value, about);
    return textItem(name, numberText(value.value) + " " + value.unit);
}

template <>
bool needsValue<Quantity>(const Quantity& value) {
    return std::isnan(value.value);
}

template <>
std::string schemaOf<Quantity>(SchemaBuilder& builder, const std::string&, const Quantity&, const About& about) {
    const About words{about.unit, about.meaning, about.limits};
    return builder.oneOf({builder.simple("number", {}), builder.simple("string", {})}, words);
}

template <>
void addRows<Quantity>(ReferenceRows& table, const std::string& path, const Quantity& value, const About& about) {
    addRows(table, path, value.value, about);
}

}  // namespace detail
}  // namespace tread
