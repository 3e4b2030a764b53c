#include "base/yaml/reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/fields/possible.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "base/units/units.h"

namespace tread {
namespace {

constexpr int kMostFiles = 256;
constexpr std::size_t kLongestPath = 4096;

std::string found(const YamlPlace& place) {
    switch (place.node->kind) {
        case YamlNode::Kind::nothing:
            return "nothing";
        case YamlNode::Kind::scalar:
            return quote(place.node->text);
        case YamlNode::Kind::list:
            return "a list";
        case YamlNode::Kind::map:
            return "a map";
    }
    return "something else";
}

std::string unitName(std::string_view unit) {
    return unit.empty() || unit == "-" ? "a pure number" : "a number in " + std::string(unit);
}

// Complains about a number that no car can have.
bool canBe(const YamlReader& reader, const YamlPlace& place, double value, std::string_view unit, const Usual& usual) {
    if (isPossible(usual, value)) return true;
    const std::string_view written = place.node ? std::string_view(place.node->text) : std::string_view();
    reader.complain(place, impossibleText(value, written, unit, usual));
    return false;
}

}  // namespace

YamlPlace YamlReader::root(const std::string& path) const {
    if (document_.nodes.empty()) return {nullptr, 0, 0, path};
    const YamlNode& node = document_.root();
    return {&node, node.line, node.column, path};
}

void YamlReader::complain(const YamlPlace& place, std::string text) const {
    std::vector<Problem>& problems = session_.problems;
    if (problems.size() > kMostProblems) return;
    if (problems.size() == kMostProblems)
        text = "found more than 1000 faults, the rest is not listed; correct these first";
    problems.push_back({document_.file, place.line, place.column, place.path, std::move(text)});
}

void YamlReader::expected(const YamlPlace& place, std::string_view what, std::string_view advice) const {
    complain(place, "found " + found(place) + ", expected " + std::string(what) + "; " + std::string(advice));
}

bool YamlReader::isScalar(const YamlPlace& place, std::string_view what, std::string_view advice) const {
    if (place.node->kind == YamlNode::Kind::scalar) return true;
    expected(place, what, advice);
    return false;
}

YamlPlace YamlReader::child(const YamlPlace& parent, std::size_t index, std::string_view name) const {
    const YamlNode& node = document_.nodes[parent.node->children[index]];
    YamlPlace place{&node, node.line, node.column, joinPath(parent.path, name)};
    // An empty value has no place of its own: the key before it has.
    const bool is_value_of_key = parent.node->kind == YamlNode::Kind::map && index % 2 == 1;
    if (node.kind == YamlNode::Kind::nothing && is_value_of_key) {
        const YamlNode& key = document_.nodes[parent.node->children[index - 1]];
        place.line = key.line;
        place.column = key.column;
    }
    return place;
}

bool YamlReader::convert(const YamlPlace& place, std::string_view unit, const Limits& limits, double& value) const {
    if (!isScalar(place, unitName(unit), "write a decimal number, alone or followed by a unit")) return false;
    std::string fault;
    const auto converted = toSi(place.node->text, unit, fault);
    if (!converted) {
        complain(place, fault);
        return false;
    }
    if (!limits.allow(*converted)) {
        expected(place, unitName(unit) + " " + limitsText(limits), "correct the value");
        return false;
    }
    value = *converted;
    return true;
}

void YamlReader::number(const YamlPlace& place, const About& about, double& value) const {
    if (place.node) {
        double read = value;
        const bool is_fine = convert(place, about.unit, about.limits, read);
        if (is_fine && canBe(*this, place, read, about.unit, about.usual)) value = read;
    } else if (std::isnan(value)) {
        complain(place, "found no value, expected " + unitName(about.unit) + " (" + std::string(about.meaning) +
                            "); add \"" + lastName(place.path) + ": <number>\"");
    } else if (session_.check_absent && !about.limits.allow(value)) {
        complain(place, "found " + numberText(value) + ", expected " + unitName(about.unit) + " " +
                            limitsText(about.limits) + "; correct the value");
    } else if (session_.check_absent) {
        canBe(*this, place, value, about.unit, about.usual);
    }
}

void YamlReader::wholeNumber(const YamlPlace& place, const About& about, int& value) const {
    if (!place.node) {
        if (session_.check_absent && !about.limits.allow(value)) {
            complain(place, "found " + std::to_string(value) + ", expected a whole number " + limitsText(about.limits) +
                                "; correct the value");
        }
        return;
    }
    const std::string limits = limitsText(about.limits);
    const std::string what = limits.empty() ? "a whole number" : "a whole number " + limits;
    if (!isScalar(place, what, "write digits only")) return;
    const std::string& digits = place.node->text;
    int whole = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), whole);
    const bool all_digits = error == std::errc{} && end == digits.data() + digits.size();
    if (!all_digits) return expected(place, what, "write digits only");
    if (!about.limits.allow(whole)) return expected(place, what, "correct the value");
    if (canBe(*this, place, whole, about.unit, about.usual)) value = whole;
}

void YamlReader::yesNo(const YamlPlace& place, bool& value) const {
    if (!place.node) return;
    const bool is_true = place.node->text == "true";
    const bool is_word = place.node->kind == YamlNode::Kind::scalar && !place.node->quoted;
    if (!is_word || (!is_true && place.node->text != "false")) {
        return expected(place, "true or false", "write one of these, without quotes");
    }
    value = is_true;
}

void YamlReader::text(const YamlPlace& place, std::string& value) const {
    if (place.node && isScalar(place, "a text", "write it on one line, in quotes when it has special characters")) {
        value = place.node->text;
    }
}

void YamlReader::curve(const YamlPlace& place, const About& about, Curve& value) const {
    if (!place.node) return;
    const std::string shape = "a list of points [x in " + std::string(about.argument.empty() ? "-" : about.argument) +
                              ", y in " + std::string(about.unit.empty() ? "-" : about.unit) + "]";
    if (place.node->kind != YamlNode::Kind::list) return expected(place, shape, "write [[x1, y1], [x2, y2]]");

    const std::size_t faults_before = faults();
    Curve curve;
    for (std::size_t i = 0; i < place.node->children.size(); ++i) {
        const YamlPlace point = child(place, i, std::to_string(i));
        if (point.node->kind != YamlNode::Kind::list || point.node->children.size() != 2) {
            expected(point, "a point [x, y] of two numbers", "write both numbers in brackets");
            continue;
        }
        Curve::Point xy{};
        const YamlPlace x = child(point, 0, "x");
        const YamlPlace y = child(point, 1, "y");
        const bool x_is_fine =
            convert(x, about.argument, kAny, xy.x) && canBe(*this, x, xy.x, about.argument, about.usual_argument);
        const bool y_is_fine =
            convert(y, about.unit, about.limits, xy.y) && canBe(*this, y, xy.y, about.unit, about.usual);
        if (!x_is_fine || !y_is_fine) continue;
        if (!curve.points.empty() && xy.x <= curve.points.back().x) {
            complain(x, "found x = " + numberText(xy.x) + " after " + numberText(curve.points.back().x) +
                            ", expected x to increase strictly; sort the points and remove repetitions");
        }
        curve.points.push_back(xy);
    }
    if (faults() == faults_before) value = std::move(curve);
}

std::optional<std::size_t> YamlReader::choice(const YamlPlace& place, std::span<const std::string_view> names) const {
    if (!place.node || !isScalar(place, listed(names), "write one of these")) return {};
    const auto name = std::find(names.begin(), names.end(), place.node->text);
    if (name != names.end()) return static_cast<std::size_t>(name - names.begin());
    const std::string suggestion = didYouMean(place.node->text, names);
    complain(place, "found " + found(place) + ", expected " + listed(names) +
                        (suggestion.empty() ? "; write one of these" : suggestion));
    return {};
}

std::optional<std::vector<YamlPlace>> YamlReader::elements(const YamlPlace& place) const {
    if (!place.node) return {};
    if (place.node->kind != YamlNode::Kind::list) {
        expected(place, "a list", "write [a, b] or one \"- \" line for each element");
        return {};
    }
    std::vector<YamlPlace> places;
    for (std::size_t i = 0; i < place.node->children.size(); ++i) places.push_back(child(place, i, std::to_string(i)));
    return places;
}

std::optional<std::vector<YamlReader::Entry>> YamlReader::entries(const YamlPlace& place) const {
    if (!place.node) return {};
    if (place.node->kind != YamlNode::Kind::map) {
        expected(place, "a map", "write {name: value} or one \"name: value\" line for each entry");
        return {};
    }
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < place.node->children.size(); i += 2) {
        const YamlNode& key = document_.nodes[place.node->children[i]];
        entries.push_back({{&key, key.line, key.column, place.path}, child(place, i + 1, key.text)});
    }
    return entries;
}

std::optional<YamlReader::Alternative> YamlReader::alternative(const YamlPlace& place,
                                                               std::span<const std::string_view> names) const {
    if (!place.node) return {};
    const YamlNode& node = *place.node;
    if (node.kind == YamlNode::Kind::scalar) {
        const auto index = choice(place, names);
        if (!index) return {};
        // The struct has its defaults; what it requires is missing here.
        return Alternative{*index, {nullptr, place.line, place.column, joinPath(place.path, names[*index])}};
    }
    if (node.kind != YamlNode::Kind::map || node.children.size() != 2) {
        const std::string count =
            node.kind == YamlNode::Kind::map ? " of " + std::to_string(node.children.size() / 2) + " keys" : "";
        complain(place, "found " + found(place) + count + ", expected one of " + listed(names) + "; write \"" +
                            std::string(names.front()) + ": {...}\"");
        return {};
    }
    const YamlNode& key = document_.nodes[node.children.front()];
    const auto index = choice({&key, key.line, key.column, place.path}, names);
    if (!index) return {};
    return Alternative{*index, child(place, 1, names[*index])};
}

std::optional<std::filesystem::path> YamlReader::include(const YamlPlace& place) const {
    const std::filesystem::path name = place.node->text;
    const std::filesystem::path file = (std::filesystem::path(document_.file).parent_path() / name).lexically_normal();
    std::error_code error;
    const bool exists =
        name.native().find('\0') == std::string::npos && !name.empty() && std::filesystem::exists(file, error);
    if (!exists) {
        complain(place, "found the file name " + quote(place.node->text) + ", which " + document_.file +
                            " includes, but nothing is there (tried " + quote(file.string(), kLongestPath) +
                            "); write a path relative to the including file");
        return {};
    }
    const auto canonical = std::filesystem::weakly_canonical(file, error);
    const auto& open = session_.open_files;
    if (std::find(open.begin(), open.end(), canonical) != open.end()) {
        complain(place,
                 "found " + quote(place.node->text) + ", which includes itself through this file; break the cycle");
        return {};
    }
    if (++session_.files_read > kMostFiles) {
        complain(place, "found more than 256 included files, expected a few; include fewer");
        return {};
    }
    return file;
}

std::optional<YamlDocument> openYaml(const YamlReader& reader, const YamlPlace& place,
                                     const std::filesystem::path& file) {
    std::string fault;
    const auto text = readTextFile(file, fault);
    if (text) return parseYaml(*text, file.string(), reader.session().problems);
    if (place.node) {
        reader.complain(place, "in the included file " + file.string() + ": " + fault);
    } else {
        reader.session().problems.push_back({file.string(), 0, 0, "", fault});
    }
    return {};
}

}  // namespace tread
