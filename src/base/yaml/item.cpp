#include "base/yaml/item.h"

#include <algorithm>
#include <cmath>

#include "base/text/concat.h"
#include "base/text/json_string.h"
#include "base/text/number_text.h"

namespace tread {
namespace {

using Kind = YamlItem::Kind;
using Lines = std::vector<std::string>;

constexpr std::size_t kPointsInOneLine = 6;

Lines render(const YamlItem& item);

std::string flowText(const YamlItem& item) {
    if (item.kind == Kind::scalar) return item.text;
    std::string text = "[";
    for (const YamlItem& child : item.children) text += concat({text.size() > 1 ? ", " : "", flowText(child)});
    return text + "]";
}

// Numbers, words and short lists of them stand in one line; long lists of points and everything with names do not.
bool fitsOneLine(const YamlItem& item) {
    if (item.kind == Kind::scalar) return true;
    if (item.kind != Kind::list) return false;
    const bool has_lists = std::any_of(item.children.begin(), item.children.end(),
                                       [](const YamlItem& child) { return child.kind == Kind::list; });
    if (has_lists && item.children.size() > kPointsInOneLine) return false;
    return std::all_of(item.children.begin(), item.children.end(), fitsOneLine);
}

std::string keyed(const YamlItem& item, const std::string& value) {
    std::string line = item.name.empty() ? value : concat({item.name, value.empty() ? ":" : ": ", value});
    if (!item.comment.empty()) line += (line.empty() ? "# " : "  # ") + item.comment;
    return line;
}

void append(Lines& lines, const Lines& more, std::string_view first, std::string_view rest) {
    for (std::size_t i = 0; i < more.size(); ++i) lines.push_back(std::string(i == 0 ? first : rest) + more[i]);
}

Lines render(const YamlItem& item) {
    if (item.kind == Kind::remark) return {concat({"# ", item.name, ": ", item.text})};
    if (fitsOneLine(item)) return {keyed(item, flowText(item))};

    Lines lines;
    const bool is_list = item.kind == Kind::list;
    const bool empty = !item.hasValues();
    const bool needs_header = !item.name.empty() || empty || !item.comment.empty();
    if (needs_header) lines.push_back(keyed(item, empty ? (is_list ? "[]" : "{}") : ""));
    const std::string_view indent = item.name.empty() ? "" : "  ";
    for (const YamlItem& child : item.children) {
        append(lines, render(child), std::string(indent) + (is_list ? "- " : ""),
               std::string(indent) + (is_list ? "  " : ""));
    }
    return lines;
}

// Words that every YAML reader takes for what they are: they begin with a letter and hold nothing that has a meaning.
bool isPlainWord(std::string_view text) {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    constexpr std::string_view kOthers = "0123456789_-./";
    constexpr std::string_view kReserved[] = {"null", "true", "false", "yes", "no", "on", "off", "y", "n"};
    if (text.empty() || kLetters.find(text.front()) == std::string_view::npos) return false;
    for (const char c : text) {
        const bool harmless = kLetters.find(c) != std::string_view::npos || kOthers.find(c) != std::string_view::npos;
        if (!harmless) return false;
    }
    std::string small(text);
    for (char& c : small) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return std::find(std::begin(kReserved), std::end(kReserved), small) == std::end(kReserved);
}

}  // namespace

bool YamlItem::hasValues() const {
    return std::any_of(children.begin(), children.end(),
                       [](const YamlItem& child) { return child.kind != Kind::remark; });
}

YamlItem numberItem(std::string_view name, double value, const About& about) {
    const std::string unit(about.unit == "-" ? "" : about.unit);
    if (std::isnan(value))
        return {Kind::remark, std::string(name), "a number is required here, " + std::string(about.unit), "", {}};
    if (std::isinf(value))
        return {Kind::remark, std::string(name), value > 0 ? "unlimited" : "unlimited below", "", {}};
    return {Kind::scalar, std::string(name), numberText(value), unit, {}};
}

YamlItem curveItem(std::string_view name, const Curve& curve, const About& about) {
    const auto unit = [](std::string_view text) { return text.empty() ? "-" : text; };
    YamlItem item{
        Kind::list, std::string(name), "", concat({"[", unit(about.argument), ", ", unit(about.unit), "]"}), {}};
    for (const Curve::Point& point : curve.points) {
        YamlItem pair{Kind::list, "", "", "", {}};
        pair.children.push_back({Kind::scalar, "", numberText(point.x), "", {}});
        pair.children.push_back({Kind::scalar, "", numberText(point.y), "", {}});
        item.children.push_back(std::move(pair));
    }
    return item;
}

YamlItem textItem(std::string_view name, std::string_view value) {
    return {Kind::scalar, std::string(name), isPlainWord(value) ? std::string(value) : jsonString(value), "", {}};
}

std::string yamlText(const YamlItem& root) {
    std::string text;
    for (const std::string& line : render(root)) text += line + "\n";
    return text;
}

}  // namespace tread
