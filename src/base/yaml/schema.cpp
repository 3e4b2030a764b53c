#include "base/yaml/schema.h"

#include <algorithm>
#include <cmath>

#include "base/fields/possible.h"
#include "base/text/concat.h"
#include "base/text/json_string.h"
#include "base/text/number_text.h"
#include "base/units/quantity_pattern.h"

namespace tread::detail {
namespace {

std::string jsonList(std::span<const std::string> items) {
    std::string text = "[";
    for (const std::string& item : items) text += (text.size() > 1 ? ", " : "") + item;
    return text + "]";
}

// "description": "damping in compression [N s/m], at least 0", with the comma behind it.
std::string description(const About& about) {
    if (about.meaning.empty()) return {};
    std::string text(about.meaning);
    if (!about.argument.empty()) {
        text += concat({" [", about.unit, "] over [", about.argument, "]"});
    } else if (!about.unit.empty()) {
        text += concat({" [", about.unit, "]"});
    }
    const std::string limits = limitsText(about.limits);
    if (!limits.empty()) text += concat({", ", limits});
    return concat({R"("description": )", jsonString(text), ", "});
}

std::string limitsSchema(const Limits& limits) {
    std::string text;
    if (std::isfinite(limits.lowest)) {
        text += limits.lowest_open ? R"(, "exclusiveMinimum": )" : R"(, "minimum": )";
        text += numberText(limits.lowest);
    }
    if (std::isfinite(limits.highest)) {
        text += limits.highest_open ? R"(, "exclusiveMaximum": )" : R"(, "maximum": )";
        text += numberText(limits.highest);
    }
    return text;
}

// A word for a definition: "_N_s_per_m".
std::string definitionName(std::string_view unit) {
    std::string name = "_";
    for (const char c : unit.empty() || unit == "-" ? std::string_view("number") : unit) {
        if (c == '/') {
            name += "_per_";
        } else {
            name += c == ' ' ? '_' : c;
        }
    }
    return name;
}

}  // namespace

// Texts with a unit are defined once for each unit, so that every field only refers to its kind.
std::string SchemaBuilder::numberOrQuantity(std::string_view unit, const Limits& limits) {
    const bool negative = !(limits.lowest >= 0);
    const std::string name = definitionName(unit) + (negative ? "" : "_not_negative");
    const auto is_same = [&](const auto& quantity) { return quantity.first == name; };
    if (std::none_of(quantities_.begin(), quantities_.end(), is_same)) {
        const std::string words = unit.empty() || unit == "-" ? "a number" : concat({"a number in ", unit});
        quantities_.emplace_back(
            name, concat({R"({"description": )", jsonString(words + ", or followed by its unit"),
                          R"(, "type": "string", "pattern": )", jsonString(quantityPattern(unit, limits)), "}"}));
    }
    return concat(
        {R"("anyOf": [{"type": "number")", limitsSchema(limits), R"(}, {"$ref": "#/definitions/)", name, "\"}]"});
}

std::string SchemaBuilder::number(const About& about) {
    return concat({"{", description(about), numberOrQuantity(about.unit, possibleLimits(about)), "}"});
}

std::string SchemaBuilder::wholeNumber(const About& about) const {
    return concat({"{", description(about), R"("type": "integer")", limitsSchema(possibleLimits(about)), "}"});
}

std::string SchemaBuilder::curve(const About& about) {
    const std::string x = numberOrQuantity(about.argument, kAny),
                      y = numberOrQuantity(about.unit, possibleLimits(about));
    return concat({"{", description(about),
                   R"("type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2, )", R"("items": [{)", x,
                   "}, {", y, "}]}}"});
}

std::string SchemaBuilder::simple(std::string_view type, const About& about) const {
    return concat({"{", description(about), R"("type": )", jsonString(type), "}"});
}

std::string SchemaBuilder::choice(std::span<const std::string_view> names, const About& about) const {
    std::vector<std::string> items;
    for (const std::string_view name : names) items.push_back(jsonString(name));
    return concat({"{", description(about), R"("enum": )", jsonList(items), "}"});
}

std::string SchemaBuilder::list(const std::string& element, const About& about) const {
    return concat({"{", description(about), R"("type": "array", "items": )", element, "}"});
}

std::string SchemaBuilder::oneOf(const std::vector<std::string>& schemas, const About& about) const {
    return concat({"{", description(about), R"("oneOf": )", jsonList(schemas), "}"});
}

std::string SchemaBuilder::object(const std::vector<SchemaProperty>& properties) const {
    std::string fields;
    std::vector<std::string> required;
    for (const SchemaProperty& property : properties) {
        fields += concat({fields.empty() ? "\n  " : ",\n  ", jsonString(property.name), ": ", property.schema});
        if (property.required) required.push_back(jsonString(property.name));
    }
    std::string text = R"({"type": "object", "additionalProperties": false)";
    if (!required.empty()) text += concat({R"(, "required": )", jsonList(required)});
    return concat({text, R"(, "properties": {)", fields, "}}"});
}

std::string SchemaBuilder::reference(const std::string& name, const About& about, bool includable) const {
    std::string target = concat({R"({"$ref": )", jsonString("#/definitions/" + name), "}"});
    if (includable) {
        const About file{"", "name of a file, relative to this one"};
        return oneOf({simple("string", file), target}, about);
    }
    if (about.meaning.empty()) return target;
    // Beside "$ref" a draft-7 reader ignores every other key, hence the list of one.
    return concat({"{", description(about), R"("allOf": [)", target, "]}"});
}

std::string SchemaBuilder::alternative(std::string_view name, const std::string& schema) const {
    return object({{std::string(name), schema, true}});
}

std::pair<std::string, bool> SchemaBuilder::definition(std::type_index type, const std::string& path) {
    // C++ does not tell the name of a type in a portable way; the path of its first use is as good.
    const auto [entry, is_new] = names_.emplace(type, path);
    return {entry->second, is_new};
}

std::string SchemaBuilder::document(std::string_view title, std::string_view id, const std::string& root) const {
    std::string text =
        concat({"{\n\"$schema\": \"http://json-schema.org/draft-07/schema#\",\n\"$id\": ", jsonString(id),
                ",\n\"title\": ", jsonString(title), ",\n\"definitions\": {"});
    for (const auto* definitions : {&quantities_, &definitions_}) {
        for (const auto& [name, schema] : *definitions) {
            text += concat({text.ends_with('{') ? "\n" : ",\n", jsonString(name), ": ", schema});
        }
    }
    return concat({text, "\n},\n", root.substr(1), "\n"});
}

}  // namespace tread::detail
