// What visits the fields of described structs, declared without the headers that define it.
//
// A struct with many fields declares beside itself, or in a header of its folder,
//   extern template struct detail::FieldsOf<Car>;
// and one source instantiates it: its visitors take a compiler seconds each, in every source that uses them.
//
// A type that is no described struct and yet a field of one declares beside itself the specialisation of `readValue`,
// `itemOf`, `needsValue`, `schemaOf` and `addRows` that its own source defines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tread/describe.h"

namespace tread {

class YamlReader;
struct YamlPlace;
struct YamlItem;
struct Number;

namespace detail {

class SchemaBuilder;
class ReadSetting;
struct ReferenceRows;
struct Judge;
struct Way;

// The visitors of a described struct, a function for each purpose.
template <class T>
struct FieldsOf {
    static void read(const YamlReader& reader, const YamlPlace& place, T& object);                     // yaml/read.h
    static bool set(T& object, std::string_view path, const ReadSetting&, const std::string& walked);  // yaml/setting.h
    static YamlItem write(std::string_view name, const T& object);                                     // yaml/write.h
    static void addRows(ReferenceRows& table, const std::string& path, const T& object);  // fields/reference_table.h
    static void addNumbers(T& object, const std::string& prefix, std::vector<Number>& numbers);  // fields/numbers.h
    static void judge(Judge& judge, const T& object, const Way& way);                            // fields/implausible.h
};

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
