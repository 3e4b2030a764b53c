#include "kind_of_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/did_you_mean.h"
#include "base/number_text.h"

namespace tread::program {
namespace {

// Number of keys that the description has; a key that is only mistyped counts half.
std::size_t score(const Describable& kind, const std::vector<std::string>& keys) {
    const std::vector<TopField> top = kind.top();
    std::vector<std::string_view> names;
    for (const TopField& field : top) names.push_back(field.name);
    std::size_t points = 0;
    for (const std::string& key : keys) {
        const bool known = std::find(names.begin(), names.end(), key) != names.end();
        points += known ? 2 : closest(key, names) ? 1 : 0;
    }
    return points;
}

}  // namespace

std::vector<std::string> keysOf(const YamlDocument& document) {
    std::vector<std::string> keys;
    const std::vector<std::size_t>& children = document.root().children;
    if (document.root().kind != YamlNode::Kind::map) return keys;
    for (std::size_t i = 0; i < children.size(); i += 2) keys.push_back(document.nodes[children[i]].text);
    return keys;
}

const Describable* bestMatch(const std::vector<std::string>& keys) {
    const Describable* best = nullptr;
    std::size_t most = 0;
    // A scenario has conditions and metrics too, but never them alone.
    if (std::find(keys.begin(), keys.end(), "phases") == keys.end() &&
        std::find(keys.begin(), keys.end(), "title") == keys.end()) {
        const Describable& accept = describable("accept", true);
        if (!keys.empty() && score(accept, keys) == 2 * keys.size()) return &accept;
        const Describable& metrics = describable("own_metrics", true);
        if (!keys.empty() && score(metrics, keys) == 2 * keys.size()) return &metrics;
    }
    for (const Describable& kind : describables()) {
        if (!kind.isFile()) continue;
        const std::size_t points = score(kind, keys);
        if (points > most) {
            most = points;
            best = &kind;
        } else if (points == most) {
            best = nullptr;
        }
    }
    return best;
}

std::string foundKeys(const std::vector<std::string>& keys) {
    std::string found = keys.empty() ? "no \"key: value\" lines" : "";
    for (std::size_t i = 0; i < std::min<std::size_t>(keys.size(), 3); ++i)
        found += (i > 0 ? ", " : "") + quote(keys[i]);
    if (keys.size() > 3) found += fmt::format(" and {} more", keys.size() - 3);
    return found;
}

}  // namespace tread::program
