#include "report/series_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/changed.h"
#include "diagnose/answer/words.h"
#include "report/html.h"
#include "report/series_figures.h"
#include "report/shown_metric.h"
#include "report/text.h"
#include "report/verdict_table.h"

namespace tread {
namespace {

using diagnose::answer::capitalised;

constexpr std::size_t kKeyMetrics = 4;  // of a scenario in the overview

std::string columnTitle(const std::string& name, const DisplayUnit& shown) {
    const std::string unit = prettyUnit(shown.unit);
    return unit.empty() || unit == "-" ? name : fmt::format("{} [{}]", name, unit);
}

// The results that are said, by their titles; without any, the first metrics.
std::string keyMetrics(const std::vector<Metric>& all) {
    std::vector<Metric> metrics = resultsFirst(all);
    if (!metrics.empty() && metrics.front().say.rank > 0)
        std::erase_if(metrics, [](const Metric& metric) { return metric.say.rank == 0; });
    metrics.resize(std::min(kKeyMetrics, metrics.size()));
    std::string words;
    for (const Metric& metric : metrics) {
        words += fmt::format("{}{}: {}", words.empty() ? "" : " · ", titleOf(metric), shownValue(metric, 4));
        if (const std::string unit = prettyUnit(displayUnit(metric).unit); !unit.empty()) words += " " + unit;
    }
    return words;
}

// What became of a scenario, in words and colour.
Cell stateOf(const Overview::Entry& entry) {
    if (!entry.driven) return {.text = "✗ failed", .alarm = true};
    if (!allMet(entry.verdicts)) {
        Cell cell = verdictCell(entry.verdicts);
        cell.text = "✗ not accepted, " + cell.text;
        return cell;
    }
    if (!entry.verdicts.empty()) return {.text = "✓ accepted", .good_news = true};
    return {.text = entry.warnings.empty() ? "✓ driven" : "✓ driven, with warnings"};
}

std::size_t countOf(const Overview& content, bool (*counts)(const Overview::Entry&)) {
    return static_cast<std::size_t>(std::count_if(content.entries.begin(), content.entries.end(), counts));
}

void addSummary(HtmlPage& page, const Overview& content) {
    const std::size_t all = content.entries.size();
    const std::size_t driven = countOf(content, [](const auto& entry) { return entry.driven; });
    const std::size_t judged =
        countOf(content, [](const auto& entry) { return entry.driven && !entry.verdicts.empty(); });
    const std::size_t accepted = countOf(
        content, [](const auto& entry) { return entry.driven && !entry.verdicts.empty() && allMet(entry.verdicts); });
    const auto card = [](const char* label, std::size_t some, std::size_t of) {
        return Card{.label = label,
                    .value = fmt::format("{} of {}", some, of),
                    .unit = "",
                    .tone = some == of ? Tone::good : Tone::bad};
    };
    std::vector<Card> cards{card("Scenarios driven", driven, all)};
    if (judged > 0) cards.push_back(card("Accepted, of those with conditions", accepted, judged));
    page.cards(cards);
}

}  // namespace

std::string seriesReport(const SeriesReport& content) {
    HtmlPage page(content.title);
    answerWithVerdict(page, content.answer, content.verdicts);
    const ChangedName car = splitChanged(content.vehicle);
    page.keyValues({{"Vehicle", car.name},
                    {"Changed settings", car.changes},
                    {"Description", content.scenario_description},
                    {"Varied", content.number},
                    {"Made by", "tread " + content.version}});
    page.links("Files", content.files);
    if (const std::vector<Chart> charts = seriesFigures(content); !charts.empty()) {
        page.section(fmt::format("Results over {}", variedInWords(content.number)));
        page.figures(charts);
    }
    addVerdicts(page, content.verdicts);
    page.section("Runs");
    const auto full =
        std::find_if(content.runs.begin(), content.runs.end(), [](const auto& r) { return !r.metrics.empty(); });
    const std::vector<Metric> columns = full == content.runs.end() ? std::vector<Metric>{} : full->metrics;
    const DisplayUnit varied = displayUnit(content.unit);
    std::vector<std::string> header{"Run", columnTitle(capitalised(variedInWords(content.number)), varied), "Passed"};
    for (const Metric& metric : columns) header.push_back(columnTitle(titleOf(metric), displayUnit(metric)));
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < content.runs.size(); ++i) {
        const SeriesReport::Run& run = content.runs[i];
        std::vector<Cell> row{{.text = fmt::format("{}", i + 1), .link = run.link},
                              {.text = formatNumber(run.value * varied.scale, 5), .number = true},
                              {.text = run.passed ? "✓ yes" : "✗ no", .alarm = !run.passed, .good_news = run.passed}};
        for (const Metric& metric : run.metrics) {
            row.push_back({.text = formatNumber(metric.value * displayUnit(metric).scale, 4), .number = true});
        }
        if (!run.failure.empty()) row.push_back({.text = run.failure, .alarm = true});
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
    if (!columns.empty()) {
        page.section("Metrics");
        std::vector<std::vector<Cell>> definitions;
        for (const Metric& metric : columns)
            definitions.push_back({{.text = titleOf(metric), .note = metric.title.empty() ? "" : metric.name},
                                   {.text = metric.definition}});
        page.table({"Metric", "Definition"}, definitions, true);
    }
    page.section("Inputs");
    page.collapsible("Resolved vehicle and scenario (YAML)", content.resolved_yaml);
    return page.finish();
}

std::string overviewReport(const Overview& content) {
    HtmlPage page(content.title);
    std::vector<Verdict> verdicts;
    for (const Overview::Entry& entry : content.entries)
        verdicts.insert(verdicts.end(), entry.verdicts.begin(), entry.verdicts.end());
    const bool driven = countOf(content, [](const auto& entry) { return !entry.driven; }) == 0;
    const bool met = allMet(verdicts);
    page.answer(content.answer,
                !driven            ? "not all driven"
                : verdicts.empty() ? ""
                : met              ? "accepted"
                                   : "not accepted",
                driven && met);
    addSummary(page, content);
    const ChangedName car = splitChanged(content.vehicle);
    page.keyValues({{"Vehicle", car.name}, {"Changed settings", car.changes}, {"Made by", "tread " + content.version}});
    page.section("Manoeuvres");
    std::vector<std::vector<Cell>> rows;
    for (const Overview::Entry& entry : content.entries) {
        // What the row and the page say already.
        const std::string begins = entry.title + ", " + content.vehicle + ": ";
        rows.push_back({{.text = entry.title.empty() ? entry.scenario : entry.title, .link = entry.link},
                        stateOf(entry),
                        {.text = entry.answer.starts_with(begins) ? entry.answer.substr(begins.size()) : entry.answer,
                         .alarm = !entry.driven,
                         .note = keyMetrics(entry.metrics)}});
    }
    page.table({"Manoeuvre", "State", "Result"}, rows, true);
    std::vector<std::vector<Cell>> warnings;
    for (const Overview::Entry& entry : content.entries) {
        for (const std::string& warning : entry.warnings)
            warnings.push_back({{.text = entry.scenario}, {.text = warning}});
    }
    if (!warnings.empty()) {
        page.section("Warnings");
        page.table({"Scenario", "Warning"}, warnings, true);
    }
    return page.finish();
}

}  // namespace tread
