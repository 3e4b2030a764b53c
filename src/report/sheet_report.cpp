#include "report/sheet_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

using sheet::Sheet;
using sheet::SheetCurve;
using sheet::SheetRow;

constexpr int kDigits = 4;
constexpr int kSpokenDigits = 3;

std::string spoken(const SheetRow& row) {
    const int digits = std::abs(row.value) >= 1000 ? kDigits : kSpokenDigits;
    return fmt::format("{} {}", formatNumber(row.value, digits), row.unit);
}

std::vector<const SheetRow*> rowsToSay(const Sheet& sheet) {
    std::vector<const SheetRow*> rows;
    for (const SheetRow& row : sheet.rows)
        if (!row.say.empty() && !std::isnan(row.value)) rows.push_back(&row);
    return rows;
}

void addGroup(HtmlPage& page, const Sheet& sheet, std::string_view group) {
    std::vector<std::vector<Cell>> rows;
    for (const SheetRow& row : sheet.rows) {
        if (row.group != group) continue;
        const bool none = std::isnan(row.value);
        std::string explained(row.formula);
        if (!row.note.empty()) explained = row.note + "; " + explained;
        rows.push_back({{.text = std::string(row.label)},
                        {.text = formatNumber(row.value, kDigits), .number = true},
                        {.text = none ? "" : prettyUnit(row.unit)},
                        {.text = explained},
                        {.text = fmt::format("{}", fmt::join(row.sources, ", "))}});
    }
    page.section(group);
    page.table({"Number", "Value", "Unit", "Formula", "Comes from"}, rows, true);
}

Chart brakingFigure(const std::vector<SheetCurve>& curves) {
    Chart chart{.title = "Brake forces of the axles over the weight",
                .x = {"front brake force over weight", "-"},
                .y = {"rear brake force over weight", "-"},
                .series = {}};
    chart.note = "Above the ideal curve the rear axle locks first, below it the front axle.";
    for (const SheetCurve& curve : curves) chart.series.push_back({.name = curve.name, .x = curve.x, .y = curve.y});
    return chart;
}

}  // namespace

std::string sheetAnswer(const Sheet& sheet) {
    std::string words;
    for (const SheetRow* row : rowsToSay(sheet))
        words += (words.empty() ? "" : ", ") + fmt::format(fmt::runtime(row->say), spoken(*row));
    return fmt::format("{}: {}", sheet.name.empty() ? "Car" : sheet.name, words);
}

std::string sheetReport(const SheetReport& content) {
    const Sheet& sheet = content.sheet;
    HtmlPage page(fmt::format("Data sheet: {}", sheet.name.empty() ? content.file : sheet.name));
    page.answer(sheetAnswer(sheet));
    std::vector<Card> cards;
    for (const SheetRow* row : rowsToSay(sheet))
        cards.push_back({std::string(row->label), formatNumber(row->value, kDigits), std::string(row->unit)});
    page.cards(cards);
    std::vector<std::pair<std::string, std::string>> facts{{"Vehicle", content.file}};
    if (!content.settings.empty()) facts.push_back({"Changed", fmt::format("{}", fmt::join(content.settings, ", "))});
    facts.push_back({"Made by", "tread " + content.version});
    page.keyValues(facts);
    std::string_view group;
    for (const SheetRow& row : sheet.rows) {
        if (row.group == group) continue;
        addGroup(page, sheet, group = row.group);
        if (group == "Brakes") page.figures({brakingFigure(sheet.braking)});
    }
    page.section("Symbols");
    page.text(sheet::kSymbols);
    page.section("Inputs");
    page.collapsible("Resolved vehicle (YAML)", content.resolved_yaml);
    return page.finish();
}

}  // namespace tread
