// A YAML file as a tree in which every value knows where it stands, bounded in size and depth however hostile the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tread/problem.h"

namespace tread {

struct YamlNode {
    enum class Kind { nothing, scalar, list, map };
    Kind kind = Kind::nothing;
    std::string text;  // of a scalar
    bool quoted = false;
    int line = 0;
    int column = 0;
    // Elements of a list; key, value, key, value ... of a map. An alias is the index of the node that it stands for.
    std::vector<std::size_t> children;
};

struct YamlDocument {
    std::string file;
    std::vector<YamlNode> nodes;  // the first is the root

    const YamlNode& root() const { return nodes.front(); }
};

// The only document of a text. Nothing, and what is wrong with the text, when it is not one well-formed YAML document.
std::optional<YamlDocument> parseYaml(std::string_view text, const std::string& file, std::vector<Problem>& problems);

}  // namespace tread
