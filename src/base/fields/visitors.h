// For types that are no described structs and yet fields of one: a type declares beside itself, for each visitor of
// descriptions, the specialisation that its own source defines. The visitors themselves are declared here, without the
// headers that define them.
#pragma once

#include <string>
#include <string_view>

#include "tread/describe.h"

namespace tread {

class YamlReader;
struct YamlPlace;
struct YamlItem;

namespace detail {

class SchemaBuilder;
struct ReferenceRows;

template <class T>
void readValue(const YamlReader& reader, const YamlPlace& place, T& value, const About& about);
template <class T>
YamlItem itemOf(std::string_view name, const T& value, const About& about);
template <class T>
bool needsValue(const T& value);
template <class T>
std::string schemaOf(SchemaBuilder& builder, const std::string& path, const T& value, const About& about);
template <class T>
void addRows(ReferenceRows& table, const std::string& path, const T& value, const About& about);

}  // namespace detail
}  // namespace tread
