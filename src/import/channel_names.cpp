#include "import/channel_names.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "base/fields/numbers.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "log/log_columns.h"

namespace tread {
namespace {

// Of these groups tread has a fixed set of channels; the others may hold channels of one's own beside tread's.
constexpr std::string_view kClosed[] = {"chassis", "driver"};

// Channels that are no columns of tread's own logs, but that it understands in those of others.
constexpr std::string_view kFurther[] = {"wheel.front_left.speed", "wheel.front_right.speed", "wheel.rear_left.speed",
                                         "wheel.rear_right.speed"};

using Words = std::vector<std::string_view>;

struct Split {
    std::string_view group, last;  // "wheel.front_left", "spin"; no group: the name is one word
};

Split split(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    return dot == std::string_view::npos ? Split{"", name} : Split{name.substr(0, dot), name.substr(dot + 1)};
}

const std::map<std::string, std::vector<std::string>>& groups() {
    static const auto all = [] {
        std::map<std::string, std::vector<std::string>> names;
        LogColumns columns;
        const auto add = [&](std::string_view path) {
            const Split part = split(path);
            names[std::string(part.group)].emplace_back(part.last);
        };
        for (const Number& number : numbers(columns)) add(number.path);
        for (const std::string_view further : kFurther) add(further);
        return names;
    }();
    return all;
}

bool isKnown(const Split& name) {
    const auto group = groups().find(std::string(name.group));
    return group != groups().end() &&
           std::find(group->second.begin(), group->second.end(), name.last) != group->second.end();
}

Words wordsOf(const std::vector<std::string>& names) {
    return {names.begin(), names.end()};
}

Words groupNames() {
    Words names;
    for (const auto& [group, members] : groups()) {
        if (!group.empty()) names.push_back(group);
    }
    return names;
}

bool isClosed(std::string_view group) {
    return group.starts_with("wheel.") || std::find(std::begin(kClosed), std::end(kClosed), group) != std::end(kClosed);
}

// The channel that the name nearly is, group and last word each by themselves; empty: none.
std::string nearest(const Split& name) {
    const Words names = groupNames();
    Words near;
    if (name.group.empty()) {
        near = {std::begin(kClosed), std::end(kClosed)};
    } else if (const auto group = closest(name.group, names)) {
        near.push_back(*group);
    }
    for (const std::string_view group : near) {
        const Words members = wordsOf(groups().at(std::string(group)));
        const bool exact = std::find(members.begin(), members.end(), name.last) != members.end();
        const auto last = exact ? std::optional(name.last) : closest(name.last, members);
        if (last) return std::string(group) + "." + std::string(*last);
    }
    return {};
}

}  // namespace

bool isChannelName(std::string_view name) {
    bool begins = true, of_source = false;
    for (const char c : name) {
        const bool letter = c >= 'a' && c <= 'z', digit = c >= '0' && c <= '9';
        const bool divides = !of_source && (c == '.' || c == '@');
        if (!letter && (begins || !(digit || c == '_' || divides))) return false;
        begins = divides;
        of_source = of_source || c == '@';
    }
    return !begins;
}

std::string misspelling(const std::string& name) {
    const Split part = split(quantityOf(name));
    if (!isChannelName(name) || isKnown(part)) return {};
    const std::string meant = nearest(part), found = "found " + quote(name) + ", which is not a channel of tread";
    if (!meant.empty()) {
        const std::string_view source = sourceOf(name);
        return found + "; did you mean " + quote(meant + (source.empty() ? "" : "@" + std::string(source))) +
               "? A channel of your own needs another name, like own." + std::string(part.last);
    }
    if (!isClosed(part.group)) return {};
    const auto group = groups().find(std::string(part.group));
    return found + ", expected " +
           (group == groups().end() ? "wheel.front_left, wheel.front_right, wheel.rear_left or wheel.rear_right"
                                    : "of " + std::string(part.group) + " one of " + listed(wordsOf(group->second))) +
           "; a channel of your own needs another group, like own." + std::string(part.last);
}

}  // namespace tread
