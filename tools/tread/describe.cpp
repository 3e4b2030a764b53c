#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <span>

#include "base/fields/field_path.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "commands.h"
#include "describable.h"
#include "describe_car.h"
#include "output.h"
#include "shipped_file.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

std::string_view groupOf(const ReferenceRow& row) {
    std::string_view path = row.path;
    return takeName(path);
}

// Cells of a row in reading order; the long description comes last, where it may wrap.
constexpr std::size_t kCells = 6;
std::array<std::string, kCells> cellsOf(const ReferenceRow& row) {
    std::string meaning = row.meaning;
    if (row.tolerance > 0) meaning += fmt::format(" (usually known to within {:.3g} %)", 100 * row.tolerance);
    return {row.path, row.unit, row.default_text, row.limits, row.plausible, meaning};
}

using Widths = std::array<std::size_t, kCells - 1>;
void widen(Widths& widths, std::span<const std::string> cells) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
}

// One line a field, in columns; the last wraps. Columns that are empty in the whole table are left out.
std::string line(const Widths& widths, std::span<const std::string> cells) {
    std::string out = " ";
    for (std::size_t i = 0; i < widths.size(); ++i) {
        if (widths[i] > 0) out += fmt::format(" {:<{}} ", cells[i], widths[i]);
    }
    out += " ";
    return out + wrapped(cells.back(), out.size(), lineWidth()) + "\n";
}

// The same where the columns leave too little room: path and unit, and below them all else.
std::string block(const std::array<std::string, kCells>& cells) {
    const auto& [path, unit, default_text, limits, plausible, meaning] = cells;
    const bool required = default_text == "required" || default_text.empty();
    std::string words = required ? default_text : default_text == "absent" ? "optional" : "default " + default_text;
    if (!limits.empty()) words += (words.empty() ? "" : ", ") + limits;
    if (!plausible.empty()) words += (words.empty() ? "plausible " : ", plausible ") + plausible;
    words += (words.empty() ? "" : ": ") + meaning;
    constexpr std::size_t kIndent = 6;
    return fmt::format("  {}{}{}\n{:{}}{}\n", path, unit.empty() ? "" : "  ", unit, "", kIndent,
                       wrapped(words, kIndent, lineWidth()));
}

std::string table(std::span<const ReferenceRow> rows) {
    static const std::array<std::string, kCells> kHead = {"field", "unit", "default", "limits", "plausible", "meaning"};
    constexpr std::size_t kRoom = 30;  // columns that the last cell needs
    Widths widths{};
    for (const ReferenceRow& row : rows) widen(widths, cellsOf(row));
    std::size_t before = 2;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        if (widths[i] == 0) continue;
        widths[i] = std::max(widths[i], kHead[i].size());
        before += widths[i] + 2;
    }
    const bool fits = before + kRoom <= lineWidth();
    std::string out = fits ? line(widths, kHead) : "";
    for (const ReferenceRow& row : rows) out += fits ? line(widths, cellsOf(row)) : block(cellsOf(row));
    return out;
}

// Of a path as typed: the rows of that field, of what it contains, or of an entry of its list ("phases.2").
std::vector<ReferenceRow> rowsAt(const Describable& what, const std::string& path) {
    const std::string pattern = std::regex_replace(path, std::regex(R"(\.[0-9]+(?=\.|$))"), ".0");
    std::vector<ReferenceRow> found;
    std::vector<std::string> paths;
    for (const ReferenceRow& row : what.rows()) {
        paths.push_back(row.path);
        if (row.path == pattern || row.path.starts_with(pattern + ".")) found.push_back(row);
    }
    if (!found.empty()) return found;
    const std::vector<std::string_view> known(paths.begin(), paths.end());
    throw LoadError({{"tread describe", 0, 0, "",
                      fmt::format("a {} has no field {}{}; `tread describe {}` lists all", what.name, quote(path),
                                  didYouMean(path, known), what.name)}});
}

// Single fields first, then a table for each field that contains others.
std::string text(const Describable& what) {
    const std::vector<ReferenceRow> rows = what.rows();
    const auto required =
        std::count_if(rows.begin(), rows.end(), [](const ReferenceRow& row) { return row.default_text == "required"; });
    std::string out = fmt::format("{}: {}, {} fields", what.name, what.meaning, rows.size());
    if (what.isFile()) out += fmt::format(", {} of them without a default (required)", required);
    out += "\n";

    std::vector<ReferenceRow> alone;
    std::string groups;
    for (const TopField& top : what.top()) {
        const auto begins = [&](const ReferenceRow& row) { return groupOf(row) == top.name; };
        const auto begin = std::find_if(rows.begin(), rows.end(), begins);
        const auto end = std::find_if_not(begin, rows.end(), begins);
        if (end - begin == 1 && begin->path == top.name) {
            alone.push_back(*begin);
        } else {
            const std::string head = fmt::format("{}: {}", top.name, top.meaning);
            groups += fmt::format("\n{}\n{}", wrapped(head, 0, lineWidth()), table({begin, end}));
        }
    }
    if (!alone.empty()) out += "\n" + table(alone);
    return out + groups;
}

nlohmann::json json(const Describable& what, const std::vector<ReferenceRow>& rows) {
    nlohmann::json fields = nlohmann::json::array();
    for (const ReferenceRow& row : rows) {
        fields.push_back({{"path", row.path},
                          {"unit", row.unit},
                          {"meaning", row.meaning},
                          {"limits", row.limits},
                          {"plausible", row.plausible},
                          {"default", row.default_text},
                          {"tolerance", row.tolerance > 0 ? nlohmann::json(row.tolerance) : nlohmann::json(nullptr)}});
    }
    nlohmann::json groups = nlohmann::json::object();
    for (const TopField& top : what.top()) groups[top.name] = top.meaning;
    return {{"what", what.name}, {"meaning", what.meaning}, {"groups", groups}, {"fields", fields}};
}

// A name that nobody knows may still be mistyped: what is meant as a file has an ending, a folder, or exists.
bool looksLikeFile(const std::string& what) {
    const Path path = what;
    return path.has_extension() || path.has_parent_path() || std::filesystem::exists(path);
}

[[noreturn]] void rejectForName(const DescribeOptions& options) {
    throw LoadError(
        {{options.report.empty() ? "--set" : "--report", 0, 0, "",
          fmt::format("found with the word {}, expected only with a vehicle file: it applies to the data sheet",
                      quote(options.what))}});
}

}  // namespace

int describe(const DescribeOptions& given) {
    const std::vector<std::string_view> names = describableNames(false);
    const bool named = std::find(names.begin(), names.end(), given.what) != names.end();
    DescribeOptions options = given;
    if (!named) options.what = shippedFile(given.what, "vehicles");
    if (!named && looksLikeFile(options.what)) {
        if (options.path.empty()) return describeCar(options);
        throw LoadError({{"tread describe", 0, 0, "",
                          fmt::format("found {} after a file, expected a path only after a name such as vehicle",
                                      quote(options.path))}});
    }
    if (!options.report.empty() || !options.settings.empty()) rejectForName(options);
    const Describable& what = describable(options.what, false);
    const std::vector<ReferenceRow> rows = options.path.empty() ? what.rows() : rowsAt(what, options.path);
    if (options.json) {
        printJson(json(what, rows));
    } else {
        print(options.path.empty() ? text(what) : table(rows));
    }
    return kYes;
}

}  // namespace tread::program
