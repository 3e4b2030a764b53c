#include "base/yaml/position.h"

#include <vector>

#include "base/fields/field_path.h"
#include "base/yaml/document.h"
#include "base/yaml/setting.h"

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

constexpr int kLongestChain = 8;  // that name one another: a car, an axle, a tyre; ends a circle

std::optional<WrittenValue> written(const std::string& file, std::string_view path, int files_left) {
    std::string fault;
    std::vector<Problem> problems;
    const auto text = readTextFile(file, fault);
    const auto document = text ? parseYaml(*text, file, problems) : std::nullopt;
    const YamlNode* node = document ? &document->root() : nullptr;
    while (node && !path.empty()) {
        if (node->kind == YamlNode::Kind::scalar) {
            if (files_left == 0 || node->text.empty()) return {};
            const auto included = (std::filesystem::path(file).parent_path() / node->text).lexically_normal();
            return written(included.string(), path, files_left - 1);
        }
        node = childOf(*document, *node, takeName(path));
    }
    if (!node) return {};
    return WrittenValue{file, {node->line, node->column}, node->text};
}

}  // namespace

std::optional<WrittenValue> writtenValue(const std::string& file, std::string_view path) {
    return written(file, path, kLongestChain);
}

TextPosition positionOfValue(const std::string& file, std::string_view path) {
    constexpr int kThisFileOnly = 0;
    const auto value = written(file, path, kThisFileOnly);
    return value ? value->at : TextPosition{0, 0};
}

}  // namespace tread
