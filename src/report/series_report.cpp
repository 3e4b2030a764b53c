#include "report/series_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/html.h"
#include "report/text.h"
#include "report/verdict_table.h"

namespace tread {
namespace {

constexpr std::size_t kKeyMetrics = 4;  // of a scenario in the overview

std::string columnTitle(const std::string& name, const DisplayUnit& shown) {
    const std::string unit = prettyUnit(shown.unit);
    return unit.empty() || unit == "-" ? name : fmt::format("{} [{}]", name, unit);
}

std::string keyMetrics(const std::vector<Metric>& metrics) {
    std::string words;
    for (std::size_t i = 0; i < std::min(kKeyMetrics, metrics.size()); ++i) {
        const DisplayUnit shown = displayUnit(metrics[i].unit);
        words += fmt::format("{}{} {}", i == 0 ? "" : "; ", metrics[i].name,
                             formatNumber(metrics[i].value * shown.scale, 4));
        if (shown.unit != "-") words += " " + prettyUnit(shown.unit);
    }
    return words;
}

}  // namespace

std::string seriesReport(const SeriesReport& content) {
    HtmlPage page(content.title);
    answerWithVerdict(page, content.answer, content.verdicts);
    page.keyValues({{"Vehicle", content.vehicle},
                    {"What it is", content.scenario_description},
                    {"Varied", content.number},
                    {"Made by", "tread " + content.version}});
    addVerdicts(page, content.verdicts);
    page.section("Runs");
    const auto full =
        std::find_if(content.runs.begin(), content.runs.end(), [](const auto& r) { return !r.metrics.empty(); });
    const std::vector<Metric> columns = full == content.runs.end() ? std::vector<Metric>{} : full->metrics;
    const DisplayUnit varied = displayUnit(content.unit);
    std::vector<std::string> header{"Run", columnTitle(content.number, varied), "Passed"};
    for (const Metric& metric : columns) header.push_back(columnTitle(metric.name, displayUnit(metric.unit)));
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < content.runs.size(); ++i) {
        const SeriesReport::Run& run = content.runs[i];
        std::vector<Cell> row{{.text = fmt::format("{}", i + 1), .link = run.link},
                              {.text = formatNumber(run.value * varied.scale, 5), .number = true},
                              {.text = run.passed ? "yes" : "no", .alarm = !run.passed}};
        for (const Metric& metric : run.metrics) {
            row.push_back({.text = formatNumber(metric.value * displayUnit(metric.unit).scale, 4), .number = true});
        }
        if (!run.failure.empty()) row.push_back({.text = run.failure, .alarm = true});
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
    if (!columns.empty()) {
        page.section("Metrics");
        std::vector<std::vector<Cell>> definitions;
        for (const Metric& metric : columns)
            definitions.push_back({{.text = metric.name}, {.text = metric.definition}});
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
    answerWithVerdict(page, content.answer, verdicts);
    page.keyValues({{"Vehicle", content.vehicle}, {"Made by", "tread " + content.version}});
    page.section("Manoeuvres");
    std::vector<std::vector<Cell>> rows;
    for (const Overview::Entry& entry : content.entries) {
        // What the row and the page say already.
        const std::string begins = entry.title + ", " + content.vehicle + ": ";
        rows.push_back({{.text = entry.title.empty() ? entry.scenario : entry.title, .link = entry.link},
                        {.text = entry.answer.starts_with(begins) ? entry.answer.substr(begins.size()) : entry.answer,
                         .alarm = !entry.driven},
                        {.text = keyMetrics(entry.metrics)}});
        if (!verdicts.empty()) rows.back().insert(rows.back().begin() + 1, verdictCell(entry.verdicts));
    }
    std::vector<std::string> header{"Manoeuvre", "Answer", "Key metrics"};
    if (!verdicts.empty()) header.insert(header.begin() + 1, "Verdict");
    page.table(header, rows, true);
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
