#include "base/yaml/fields.h"

#include <algorithm>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"

namespace tread {
namespace {

constexpr std::size_t kFewNames = 12;  // so many are listed when no name is near

}  // namespace

std::string sameFieldTwice(std::string_view old_name, std::string_view name) {
    return "found " + quote(old_name) + " beside " + quote(name) + ", which is the same field, expected one of them; " +
           "remove " + quote(old_name) + ", its old name";
}

YamlFields::YamlFields(const YamlReader& reader, YamlPlace place) : reader_(reader), place_(std::move(place)) {
    if (!place_.node) return;
    if (place_.node->kind != YamlNode::Kind::map) {
        reader_.expected(place_, "a map", "write \"key: value\" lines");
        readable_ = false;
        return;
    }
    const auto& children = place_.node->children;
    for (std::size_t i = 0; i < children.size(); i += 2) {
        const YamlNode& key = reader_.document_.nodes[children[i]];
        const YamlPlace place_of_key{&key, key.line, key.column, place_.path};
        if (!reader_.isScalar(place_of_key, "the name of a field", "write \"key: value\"")) continue;
        const auto [entry, is_new] = keys_.emplace(key.text, i);
        if (is_new) continue;
        const YamlNode& first = reader_.document_.nodes[children[entry->second]];
        reader_.complain(place_of_key, "found the key " + quote(key.text) +
                                           " a second time, expected it once (the first is in line " +
                                           std::to_string(first.line) + "); remove one of the two");
    }
}

YamlPlace YamlFields::find(std::string_view name) const {
    const auto key = keys_.find(name);
    if (key == keys_.end()) return {nullptr, place_.line, place_.column, joinPath(place_.path, name)};
    return reader_.child(place_, key->second + 1, name);
}

void YamlFields::know(std::string_view name, std::string_view old_name) {
    known_.push_back(name);
    if (!old_name.empty()) takeOldKey(name, old_name);
}

// From here on the old key counts as the new one.
void YamlFields::takeOldKey(std::string_view name, std::string_view old_name) {
    auto old_key = keys_.extract(old_name);
    if (old_key.empty()) return;
    const std::size_t old_index = old_key.mapped();
    old_key.key() = name;
    if (keys_.insert(std::move(old_key)).inserted) return;
    const YamlNode& key = reader_.document_.nodes[place_.node->children[old_index]];
    reader_.complain({&key, key.line, key.column, place_.path}, sameFieldTwice(old_name, name));
}

void YamlFields::rejectUnknown() {
    std::vector<std::pair<std::size_t, std::string_view>> unknown;  // in the order of the file
    for (const auto& [name, index] : keys_) {
        if (std::find(known_.begin(), known_.end(), name) == known_.end()) unknown.emplace_back(index, name);
    }
    std::sort(unknown.begin(), unknown.end());
    for (const auto& [index, name] : unknown) {
        if (reader_.faults() > kMostProblems) return;
        const YamlNode& key = reader_.document_.nodes[place_.node->children[index]];
        std::string advice = didYouMean(name, known_);
        if (name == "<<") advice = "; write the merged keys out";
        if (advice.empty())
            advice = known_.size() > kFewNames ? "; correct or remove it" : "; write one of " + listed(known_);
        reader_.complain({&key, key.line, key.column, place_.path},
                         "found the unknown key " + quote(name) + ", expected the name of a field" + advice);
        if (const auto meant = closest(name, known_)) keys_.emplace(*meant, index);
    }
}

void YamlFields::complain(std::string_view field, std::string text) const {
    const std::size_t dot = field.find('.');
    YamlPlace place = find(field.substr(0, dot));
    if (dot != std::string_view::npos && place.node && place.node->kind == YamlNode::Kind::map) {
        return YamlFields(reader_, place).complain(field.substr(dot + 1), std::move(text));
    }
    place.path = joinPath(place_.path, field);
    reader_.complain(place, std::move(text));
}

}  // namespace tread
