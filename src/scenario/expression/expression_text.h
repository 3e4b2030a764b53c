// An expression as a field of a file: its text, and where it stands.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/text/text_file.h"
#include "tread/describe.h"

namespace tread {

struct ExpressionText {
    std::string text;
    int line = 0;  // where it stands in its file; 0: in no file
    int column = 0;

    explicit operator bool() const { return !text.empty(); }
};

// Where a byte of the expression stands in the file that holds it, also when the text is quoted or folded.
TextPosition positionWithin(const std::string& file, const ExpressionText& expression, std::size_t byte);

// ---- An expression is no described struct: what the visitors of descriptions do with it ----

class YamlReader;
struct YamlPlace;
struct YamlItem;

namespace detail {

class SchemaBuilder;
struct ReferenceRows;

template <class T>
void readValue(const YamlReader& reader, const YamlPlace& place, T& value, const About& about);
template <>
void readValue<ExpressionText>(const YamlReader& reader, const YamlPlace& place, ExpressionText& value,
                               const About& about);

template <class T>
YamlItem itemOf(std::string_view name, const T& value, const About& about);
template <>
YamlItem itemOf<ExpressionText>(std::string_view name, const ExpressionText& value, const About& about);

template <class T>
std::string schemaOf(SchemaBuilder& builder, const std::string& path, const T& value, const About& about);
template <>
std::string schemaOf<ExpressionText>(SchemaBuilder& builder, const std::string& path, const ExpressionText& value,
                                     const About& about);

template <class T>
void addRows(ReferenceRows& table, const std::string& path, const T& value, const About& about);
template <>
void addRows<ExpressionText>(ReferenceRows& table, const std::string& path, const ExpressionText& value,
                             const About& about);

}  // namespace detail
}  // namespace tread
