#include <algorithm>
#include <nlohmann/json.hpp>

#include "import/import.h"

namespace tread {

// Channels of which the same is to be said share a line.
std::string text(const std::vector<Change>& changes) {
    std::string out;
    std::vector<bool> said(changes.size());
    for (std::size_t i = 0; i < changes.size(); ++i) {
        if (said[i]) continue;
        std::string names = changes[i].channel;
        for (std::size_t k = i + 1; k < changes.size() && !names.empty(); ++k) {
            if (changes[k].text != changes[i].text || changes[k].kind != changes[i].kind) continue;
            names += ", " + changes[k].channel;
            said[k] = true;
        }
        out += (names.empty() ? "" : names + ": ") + changes[i].text + "\n";
    }
    return out;
}

nlohmann::json json(const std::vector<Change>& changes) {
    nlohmann::json list = nlohmann::json::array();
    for (const Change& change : changes) {
        list.push_back(
            {{"kind", change.kind}, {"channel", change.channel}, {"count", change.count}, {"text", change.text}});
    }
    return list;
}

}  // namespace tread
