#include "scenario/accept.h"

#include <algorithm>

#include "base/fields/reference_table.h"
#include "base/text/number_text.h"
#include "base/yaml/read.h"
#include "base/yaml/schema.h"
#include "base/yaml/write.h"
#include "scenario/condition.h"

namespace tread {
namespace {

bool isGivenTwice(const Acceptance& acceptance, const std::string& metric) {
    return std::any_of(acceptance.lines.begin(), acceptance.lines.end(),
                       [&](const AcceptLine& line) { return line.metric == metric; });
}

}  // namespace

Acceptance merged(Acceptance base, const Acceptance& more) {
    for (const AcceptLine& line : more.lines) {
        const auto same = std::find_if(base.lines.begin(), base.lines.end(),
                                       [&](const AcceptLine& known) { return known.metric == line.metric; });
        if (same == base.lines.end()) {
            base.lines.push_back(line);
        } else {
            *same = line;
        }
    }
    return base;
}

namespace detail {

template <>
void readValue<Acceptance>(const YamlReader& reader, const YamlPlace& place, Acceptance& value, const About&) {
    const auto entries = reader.entries(place);
    if (!entries) return;
    Acceptance read;
    for (const YamlReader::Entry& entry : *entries) {
        AcceptLine line{entry.key.node->text, "", entry.value.line, entry.value.column};
        reader.text(entry.value, line.condition);
        if (entry.value.node->kind == YamlNode::Kind::scalar) {
            std::string fault;
            if (!parseCondition(line.condition, fault)) reader.complain(entry.value, fault);
        }
        if (isGivenTwice(read, line.metric))
            reader.complain(entry.key, "found " + quote(line.metric) + " twice, expected one condition for a metric");
        read.lines.push_back(std::move(line));
    }
    value = std::move(read);
}

template <>
YamlItem itemOf<Acceptance>(std::string_view name, const Acceptance& value, const About&) {
    YamlItem map{YamlItem::Kind::map, std::string(name), "", "", {}};
    for (const AcceptLine& line : value.lines) map.children.push_back(textItem(line.metric, line.condition));
    return map;
}

template <>
std::string schemaOf<Acceptance>(SchemaBuilder& builder, const std::string&, const Acceptance&, const About& about) {
    std::string schema = builder.simple("object", about);
    schema.pop_back();
    return schema + R"(, "additionalProperties": {"type": "string"}})";
}

template <>
void addRows<Acceptance>(ReferenceRows& table, const std::string& path, const Acceptance&, const About& about) {
    table.add(path, about, "a map", "empty");
}

}  // namespace detail
}  // namespace tread
