// What a YAML file is going to say, as a tree; and its text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

struct YamlItem {
    enum class Kind { scalar, list, map, remark };
    Kind kind = Kind::scalar;
    std::string name;     // key; empty for an element of a list and for the root
    std::string text;     // of a scalar or remark, as it stands in the file
    std::string comment;  // behind the value: its unit
    std::vector<YamlItem> children;

    bool hasValues() const;  // any child that is not a remark
};

// A number that is not finite cannot stand in a file: a remark takes its place.
YamlItem numberItem(std::string_view name, double value, const About& about);
YamlItem curveItem(std::string_view name, const Curve& curve, const About& about);
// In quotes when the text would not read back as the same string without.
YamlItem textItem(std::string_view name, std::string_view value);

// The text of a file whose top level is `root`.
std::string yamlText(const YamlItem& root);

}  // namespace tread
