// How the reader keeps one mistake from becoming many faults: rules that a faulty field has broken, parts that are
// missing as a whole, files of another kind.

#include <algorithm>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/reader.h"

namespace tread {
namespace {

constexpr std::size_t kFewKeys = 3;  // so many strange keys tell a file of another kind

bool isPartOfName(char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Whether the word stands in the text, not as part of a longer one.
bool hasWord(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isPartOfName(text[at - 1])) && (end == text.size() || !isPartOfName(text[end]))) return true;
    }
    return false;
}

}  // namespace

bool namesAny(std::span<const std::string> names, std::string_view field, std::string_view text) {
    const std::string_view first = field.substr(0, field.find('.'));
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return name == first || hasWord(text, name); });
}

std::vector<std::string> YamlReader::faultyNames(std::size_t faults_before, std::string_view path) const {
    std::vector<std::string> names;
    for (std::size_t i = faults_before; i < faults(); ++i) {
        std::string_view rest = session_.problems[i].path;
        if (!rest.starts_with(path)) continue;
        rest.remove_prefix(path.size());
        if (rest.starts_with('.')) rest.remove_prefix(1);
        while (!rest.empty()) names.emplace_back(takeName(rest));
    }
    return names;
}

void YamlReader::gatherMissing(const YamlPlace& place, std::size_t faults_before) const {
    std::vector<Problem>& problems = session_.problems;
    if (session_.check_absent || place.path.empty() || faults() < faults_before + 2) return;
    std::vector<std::string> names;
    for (std::size_t i = faults_before; i < faults(); ++i) {
        std::string_view rest = problems[i].path;
        if (!rest.starts_with(place.path + ".")) return;
        rest.remove_prefix(place.path.size() + 1);
        const std::string name(takeName(rest));
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + quote(name);
    problems.resize(faults_before);
    complain(place, "found nothing, expected a map with at least " + text + "; add \"" + lastName(place.path) +
                        ":\" with these");
}

bool YamlReader::rejectsKind(const YamlPlace& place, const YamlDocument& document,
                             std::span<const std::string_view> names) const {
    // Whatever the file is, nothing of it is told: whoever reads the message may not be whoever may read the file.
    const auto reject = [&](const char* what) {
        complain(place, "found " + quote(place.node->text) + ", " + what + ", expected a file with " + listed(names) +
                            "; name another file");
        return true;
    };
    if (document.root().kind == YamlNode::Kind::nothing) return false;
    if (document.root().kind != YamlNode::Kind::map) return reject("which has no \"key: value\" lines");
    std::vector<std::string_view> strange;
    const std::vector<std::size_t>& children = document.root().children;
    for (std::size_t i = 0; i < children.size(); i += 2) {
        const std::string_view key = document.nodes[children[i]].text;
        if (std::find(names.begin(), names.end(), key) == names.end() && !closest(key, names)) strange.push_back(key);
    }
    const std::size_t keys = children.size() / 2;  // two nodes are a key and its value
    const bool is_other =
        keys > 0 && (strange.size() == keys || (strange.size() >= kFewKeys && 2 * strange.size() >= keys));
    return is_other && reject("a file of another kind");
}

}  // namespace tread
