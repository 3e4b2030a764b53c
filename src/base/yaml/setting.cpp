#include "base/yaml/setting.h"

#include <algorithm>
#include <charconv>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/trimmed.h"

namespace tread::detail {
namespace {

// What begins like a list or a map in a file is read as one; everything else is a word, whatever signs it holds.
bool isFlow(std::string_view text) {
    return text.starts_with('[') || text.starts_with('{');
}

}  // namespace

std::optional<Setting> parseSetting(std::string_view assignment, std::string_view what, PathListing listing,
                                    std::vector<Problem>& problems) {
    const std::size_t equals = assignment.find('=');
    const std::string path(trimmed(assignment.substr(0, equals)));
    if (equals == std::string_view::npos || path.empty() || path.ends_with('.')) {
        problems.push_back(
            {std::string(what), 0, 0, "", "found " + quote(assignment) + ", expected path=value; " + listing(path)});
        return {};
    }
    const std::string_view value = trimmed(assignment.substr(equals + 1));
    if (isFlow(value)) {
        auto document = parseYaml(value, std::string(what), problems);
        if (!document) {
            problems.back().path = path;
            return {};
        }
        return Setting{path, std::move(*document)};
    }
    const auto kind = value.empty() ? YamlNode::Kind::nothing : YamlNode::Kind::scalar;
    return Setting{path, {std::string(what), {{kind, std::string(value), false, 0, 0, {}}}}};
}

bool ReadSetting::isFirstOf(const std::string& path) const {
    const std::string& spelling = place_.path;
    const auto& [present, spelt] = *given_.emplace(path, spelling).first;
    if (spelt == spelling) return true;
    reader_.complain(place_, sameFieldTwice(spelt == present ? spelling : spelt, present));
    return false;
}

std::vector<std::string> lastNames(const std::vector<Problem>& problems) {
    std::vector<std::string> names;
    for (const Problem& problem : problems) {
        if (!problem.path.empty()) names.push_back(lastName(problem.path));
    }
    return names;
}

std::size_t elementIndex(std::string_view name, std::size_t size) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    const bool is_index = error == std::errc{} && end == name.data() + name.size();
    return is_index ? std::min(index, size) : size;
}

namespace {

bool isIndex(std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
}

// The path with 0 for every index; these go into `indices`.
std::string withoutIndices(std::string_view path, std::vector<std::string>& indices) {
    std::string out;
    while (!path.empty()) {
        const std::string_view name = takeName(path);
        if (isIndex(name)) indices.emplace_back(name);
        out = joinPath(out, isIndex(name) ? "0" : name);
    }
    return out;
}

// And back, as far as there are indices.
std::string withIndices(std::string_view path, const std::vector<std::string>& indices) {
    std::string out;
    for (std::size_t used = 0; !path.empty();) {
        const std::string_view name = takeName(path);
        out = joinPath(out, isIndex(name) && used < indices.size() ? indices[used++] : std::string(name));
    }
    return out;
}

}  // namespace

std::string unknownPathText(const std::string& path, const std::vector<ReferenceRow>& known, PathListing listing) {
    std::vector<std::string_view> paths;
    std::vector<std::string_view> endings;
    for (const ReferenceRow& row : known) {
        paths.push_back(row.path);
        if (row.path.ends_with("." + path)) endings.push_back(row.path);
    }
    // The table lists element 0 for every element, and all alternatives of a choice.
    std::vector<std::string> indices;
    const std::string general = withoutIndices(path, indices);
    if (std::find(paths.begin(), paths.end(), general) != paths.end()) {
        return "found the unknown path " + quote(path) +
               ", which belongs to an element that is not there or to another choice than the one made; set the whole "
               "of it, as {key: value}";
    }
    const std::string text = "found the unknown path " + quote(path) + ", expected the path of a field";
    if (!endings.empty()) {
        endings.resize(std::min<std::size_t>(endings.size(), 4));
        return text + "; did you mean " + listed(endings) + "? " + listing(endings.front());
    }
    const auto near = closest(general, paths);
    return text + (near ? "; did you mean " + quote(withIndices(*near, indices)) + "? " : "; ") +
           listing(near.value_or(path));
}

}  // namespace tread::detail
