// Reads the tags of a page or picture, so that tests see it as a browser does: text in an attribute's value is only
// text.
#pragma once

#include <cctype>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tread {

inline std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

struct Tag {
    std::string name;  // lower case
    bool closes = false;
    bool closes_itself = false;
    std::map<std::string, std::string> attributes;
};

// The tag whose "<" is at `at`, which moves behind its ">"; nothing when it is not a tag with quoted attributes.
inline std::optional<Tag> readTag(std::string_view text, std::size_t& at) {
    const auto word = [&] {
        std::string out;
        while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '-')) {
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(text[at++])));
        }
        return out;
    };
    const auto take = [&](char c) { return at < text.size() && text[at] == c ? (++at, true) : false; };
    Tag tag;
    if (!take('<')) return std::nullopt;
    tag.closes = take('/');
    tag.name = word();
    if (tag.name.empty()) return std::nullopt;
    while (true) {
        while (take(' ')) {
        }
        if (take('/')) tag.closes_itself = true;
        if (take('>')) return tag;
        const std::string attribute = word();
        if (attribute.empty()) return std::nullopt;
        if (!take('=')) {
            tag.attributes[attribute];
            continue;
        }
        if (!take('"')) return std::nullopt;
        const auto end = text.find('"', at);
        if (end == std::string_view::npos) return std::nullopt;
        tag.attributes[attribute] = text.substr(at, end - at);
        at = end + 1;
    }
}

// All tags in order; nothing when a "<" does not begin a readable tag. A document type is skipped.
inline std::optional<std::vector<Tag>> readTags(std::string_view text) {
    std::vector<Tag> tags;
    for (auto at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
        if (text.substr(at, 2) == "<!") {
            at = text.find('>', at);
            continue;
        }
        const auto tag = readTag(text, at);
        if (!tag) return std::nullopt;
        tags.push_back(*tag);
    }
    return tags;
}

// The first tag that is closed but not open, or open but not closed; empty when all are nested well.
inline std::string unclosed(const std::vector<Tag>& tags) {
    std::vector<std::string> open;
    for (const Tag& tag : tags) {
        if (tag.closes_itself || tag.name == "meta" || tag.name == "br" || tag.name == "input") continue;
        if (!tag.closes) {
            open.push_back(tag.name);
        } else if (open.empty() || open.back() != tag.name) {
            return "/" + tag.name;
        } else {
            open.pop_back();
        }
    }
    return open.empty() ? "" : open.back();
}

}  // namespace tread
