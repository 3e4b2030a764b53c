// The keys of one map while its struct is being read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/yaml/reader.h"

namespace tread {

// The fault of whoever gives a renamed field by both of its names.
std::string sameFieldTwice(std::string_view old_name, std::string_view name);

class YamlFields {
public:
    YamlFields(const YamlReader& reader, YamlPlace place);

    // False when something else stands where the map should be.
    bool readable() const { return readable_; }

    // Marks the key of a field as known. `old_name` may stand in place of the name, not beside it.
    void know(std::string_view name, std::string_view old_name = {});

    // Complains about the keys that are not known. One that is the mistyped name of a field counts as that field from
    // here on: its value is looked at, and the field is not missed.
    void rejectUnknown();

    // The value of a field.
    YamlPlace find(std::string_view name) const;

    // Complains about a field, "bump" or "front.bump", where it stands.
    void complain(std::string_view field, std::string text) const;

private:
    void takeOldKey(std::string_view name, std::string_view old_name);

    const YamlReader& reader_;
    YamlPlace place_;
    bool readable_ = true;
    std::unordered_map<std::string_view, std::size_t> keys_;  // position among the children of the map
    std::vector<std::string_view> known_;
};

}  // namespace tread
