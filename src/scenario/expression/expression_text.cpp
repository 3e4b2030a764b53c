#include "scenario/expression/expression_text.h"

#include <algorithm>
#include <cctype>

#include "base/fields/reference_table.h"
#include "base/yaml/read.h"
#include "base/yaml/schema.h"
#include "base/yaml/write.h"

namespace tread {
namespace {

bool isBlank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// Byte at which a line (from 1) begins.
std::size_t beginningOf(std::string_view text, int line) {
    std::size_t begin = 0;
    for (int i = 1; i < line && begin < text.size(); ++i) begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
    return begin;
}

}  // namespace

// The file may fold the expression over lines: the characters that are no blanks are counted off in both.
TextPosition positionWithin(const std::string& file, const ExpressionText& expression, std::size_t byte) {
    const TextPosition start{expression.line, expression.column};
    std::string fault;
    const auto text = expression.line > 0 ? readTextFile(file, fault) : std::nullopt;
    if (!text) return start;
    std::size_t at = beginningOf(*text, expression.line) + static_cast<std::size_t>(expression.column) - 1;
    if (at >= text->size()) return start;
    if ((*text)[at] == '"' || (*text)[at] == '\'') ++at;
    if ((*text)[at] == '>' || (*text)[at] == '|') at = std::min(text->find('\n', at), text->size());
    for (std::size_t i = 0; i < std::min(byte + 1, expression.text.size()); ++i) {
        if (isBlank(expression.text[i])) continue;
        while (at < text->size() && isBlank((*text)[at])) ++at;
        if (at >= text->size() || (*text)[at] != expression.text[i]) return start;
        if (i < byte) ++at;
    }
    return positionOf(*text, at);
}

namespace detail {

template <>
void readValue<ExpressionText>(const YamlReader& reader, const YamlPlace& place, ExpressionText& value, const About&) {
    if (!place.node) return;
    ExpressionText read{"", place.line, place.column};
    const std::size_t faults_before = reader.faults();
    reader.text(place, read.text);
    if (reader.faults() != faults_before) return;
    value = std::move(read);
}

template <>
YamlItem itemOf<ExpressionText>(std::string_view name, const ExpressionText& value, const About&) {
    if (!value) return {YamlItem::Kind::remark, std::string(name), "not given", "", {}};
    return textItem(name, value.text);
}

template <>
std::string schemaOf<ExpressionText>(SchemaBuilder& builder, const std::string&, const ExpressionText&,
                                     const About& about) {
    return builder.simple("string", about);
}

template <>
void addRows<ExpressionText>(ReferenceRows& table, const std::string& path, const ExpressionText&, const About& about) {
    table.add(path, about, "an expression", "absent");
}

}  // namespace detail
}  // namespace tread
