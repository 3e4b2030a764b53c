#include "report/folders_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

std::string valueOf(const std::optional<double>& value) {
    return value ? formatNumber(*value, 6) : "undefined";
}

std::vector<Cell> rowOf(const ComparedRun& run) {
    std::string words;
    for (const std::string& difference : differences(run)) words += (words.empty() ? "" : " ") + difference;
    const bool same = run.same();
    return {{.text = run.name},
            {.text = same ? "same" : "different", .alarm = !same, .good_news = same},
            {.text = std::to_string(run.channels.channels.size()), .number = true},
            {.text = std::to_string(run.metrics.size()), .number = true},
            {.text = words}};
}

void addMetrics(HtmlPage& page, const std::vector<ComparedRun>& runs) {
    std::vector<std::vector<Cell>> rows;
    for (const ComparedRun& run : runs) {
        for (const MetricComparison& metric : run.metrics) {
            rows.push_back(
                {{.text = run.name},
                 {.text = metric.metric},
                 {.text = valueOf(metric.reference), .number = true},
                 {.text = valueOf(metric.candidate), .number = true},
                 {.text = formatNumber(metric.allowed, 4), .number = true},
                 {.text = prettyUnit(metric.unit)},
                 {.text = metric.same ? "same" : "different", .alarm = !metric.same, .good_news = metric.same}});
        }
    }
    if (rows.empty()) return;
    page.section("Metrics");
    page.table({"Run", "Metric", "Reference", "New", "Allowed", "Unit", "Verdict"}, rows);
}

void addChannels(HtmlPage& page, const std::vector<ComparedRun>& runs) {
    std::vector<std::vector<Cell>> rows;
    for (const ComparedRun& run : runs) {
        for (const ChannelComparison& channel : run.channels.channels) {
            if (channel.same) continue;
            rows.push_back({{.text = run.name},
                            {.text = channel.channel},
                            {.text = formatNumber(channel.largest, 4), .number = true},
                            {.text = formatNumber(channel.allowed, 4), .number = true},
                            {.text = formatNumber(channel.first->time, 5), .number = true},
                            {.text = prettyUnit(channel.unit)}});
        }
    }
    if (rows.empty()) return;
    page.section("Channels that differ");
    page.table({"Run", "Channel", "Largest difference", "Allowed", "First at [s]", "Unit"}, rows);
}

}  // namespace

bool ComparedRun::same() const {
    if (!compared()) return !failed;
    const bool metrics_same =
        std::all_of(metrics.begin(), metrics.end(), [](const MetricComparison& metric) { return metric.same; });
    return metrics_same && (!has_channels || channels.same);
}

std::vector<std::string> differences(const ComparedRun& run) {
    if (!run.compared()) return {run.problem};
    std::vector<std::string> out;
    for (const MetricComparison& metric : run.metrics) {
        if (!metric.same) out.push_back(text(metric) + ".");
    }
    if (run.has_channels && !run.channels.same) {
        const std::string words = text(run.channels, 0);
        out.push_back(words.substr(0, words.find('\n')) + ".");
    }
    return out;
}

std::string foldersReport(const FoldersReport& content) {
    HtmlPage page("Comparison of " + content.candidate + " with " + content.reference);
    page.answer(content.answer, content.ok ? "within tolerance" : "different", content.ok);
    page.keyValues(
        {{"Reference", content.reference}, {"New", content.candidate}, {"Made by", "tread " + content.version}});
    page.section("Runs");
    std::vector<std::vector<Cell>> rows;
    for (const ComparedRun& run : content.runs) rows.push_back(rowOf(run));
    page.table({"Run", "Verdict", "Channels", "Metrics", "What differs"}, rows, true);
    addMetrics(page, content.runs);
    addChannels(page, content.runs);
    return page.finish();
}

}  // namespace tread
