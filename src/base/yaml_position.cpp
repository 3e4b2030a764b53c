#include "base/yaml_position.h"

#include <vector>

#include "base/field_path.h"
#include "base/setting.h"
#include "base/yaml_document.h"

namespace tread {
namespace {

// The child of a map or list with this key or index; nullptr when there is none.
const YamlNode* childOf(const YamlDocument& document, const YamlNode& parent, std::string_view name) {
    const std::vector<std::size_t>& children = parent.children;
    if (parent.kind == YamlNode::Kind::list) {
        const std::size_t index = detail::elementIndex(name, children.size());
        return index < children.size() ? &document.nodes[children[index]] : nullptr;
    }
    for (std::size_t i = 0; i + 1 < children.size(); i += 2) {
        if (document.nodes[children[i]].text == name) return &document.nodes[children[i + 1]];
    }
    return nullptr;
}

// The value of a path; nothing when the file does not say it.
std::optional<YamlNode> valueAt(const std::string& file, std::string_view path) {
    std::string fault;
    std::vector<Problem> problems;
    const auto text = readTextFile(file, fault);
    const auto document = text ? parseYaml(*text, file, problems) : std::nullopt;
    const YamlNode* node = document ? &document->root() : nullptr;
    while (node && !path.empty()) node = childOf(*document, *node, takeName(path));
    return node ? std::optional(*node) : std::nullopt;
}

}  // namespace

TextPosition positionOfValue(const std::string& file, std::string_view path) {
    const auto node = valueAt(file, path);
    return node ? TextPosition{node->line, node->column} : TextPosition{0, 0};
}

std::optional<std::string> writtenValue(const std::string& file, std::string_view path) {
    const auto node = valueAt(file, path);
    if (!node || node->kind != YamlNode::Kind::scalar) return {};
    return node->text;
}

}  // namespace tread
