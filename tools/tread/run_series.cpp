#include "run_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accepting.h"
#include "answer.h"
#include "base/text/number_text.h"
#include "base/yaml/write.h"
#include "metrics/metrics.h"
#include "output.h"
#include "plausibility.h"
#include "report/series_report.h"
#include "report/text.h"
#include "series/series.h"

namespace tread::program {
namespace {

std::string folderOf(std::size_t run) {
    return fmt::format("{:02}", run + 1);
}

// "highest start.speed that passes: 62.4 km/h", "9 of 11 runs pass; the first that fails has ..."
std::string answerOf(const RunRecord& record, const SeriesResult& series) {
    const DisplayUnit shown = displayUnit(series.unit);
    const auto value = [&](double si) { return formatNumber(si * shown.scale, 4) + " " + prettyUnit(shown.unit); };
    std::string words;
    if (record.scenario.series.highest) {
        words = std::isnan(series.highest)
                    ? fmt::format("no run passes, not even with {} {}", series.number, value(series.runs.front().value))
                    : fmt::format("passes up to {} {}, by {} runs", series.number, value(series.highest),
                                  series.runs.size());
    } else {
        const auto passed =
            std::count_if(series.runs.begin(), series.runs.end(), [](const auto& r) { return r.passed; });
        const auto failed =
            std::find_if(series.runs.begin(), series.runs.end(), [](const auto& r) { return !r.passed; });
        words = fmt::format("{} of {} runs pass", passed, series.runs.size());
        if (failed != series.runs.end())
            words += fmt::format("; the first that fails has {} {}", series.number, value(failed->value));
    }
    return fmt::format("{}, {}: {}", record.scenario.title, record.vehicle.name, words);
}

// The metrics of the series. Failed runs have none, so the first run with metrics decides.
std::vector<Metric> columnsOf(const SeriesResult& series) {
    for (const SeriesRun& run : series.runs) {
        if (!run.metrics.empty()) return run.metrics;
    }
    return {};
}

std::string table(const SeriesResult& series) {
    const std::vector<Metric> columns = columnsOf(series);
    std::string out = fmt::format("{} [{}],passed [-]", series.number, series.unit);
    for (const Metric& column : columns) out += fmt::format(",{} [{}]", column.name, column.unit);
    for (const SeriesRun& run : series.runs) {
        out += "\n" + numberText(run.value) + (run.passed ? ",1" : ",0");
        for (std::size_t i = 0; i < columns.size(); ++i) {
            out += ",";
            appendNumber(out, run.metrics.empty() ? std::nan("") : run.metrics[i].value);
        }
    }
    return out + "\n";
}

nlohmann::json rows(const SeriesResult& series) {
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t i = 0; i < series.runs.size(); ++i) {
        const SeriesRun& run = series.runs[i];
        list.push_back({{"folder", folderOf(i)},
                        {"value", run.value},
                        {"passed", run.passed},
                        {"failure", run.failure},
                        {"metrics", tread::json(run.metrics)}});
    }
    return list;
}

// Conditions are on every run; in a search, whose runs beyond the highest value must fail, on that value.
std::vector<Verdict> verdictsOf(const Scenario& scenario, const SeriesResult& series,
                                const std::vector<Metric>& highest) {
    if (scenario.series.highest) return tread::judge(scenario.accept, highest);
    std::vector<Verdict> all;
    for (std::size_t i = 0; i < series.runs.size(); ++i) {
        for (Verdict& verdict : tread::judge(scenario.accept, series.runs[i].metrics, folderOf(i)))
            all.push_back(std::move(verdict));
    }
    return all;
}

// One run of the series; when it fails, its message names suspects.
Driven driveNaming(const std::vector<Problem>& implausible, const RunRecord& record, const Path& folder,
                   const Tell& tell) {
    try {
        return driveInto(record, folder, tell);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError& error) {
        throw SimulationError(withSuspects(error, implausible), error.time, error.suspect);
    }
}

}  // namespace

RunRecord tunedRecord(RunRecord record, const Stop& stop) {
    if (record.scenario.series.tune.empty() && record.scenario.series.scale.empty()) return record;
    record.scenario = tuned(record.scenario, [&](const Scenario& scenario) {
        return measureUnless(stop, record.vehicle, scenario, nullptr);
    });
    record.scenario.series.scale.clear();
    record.scenario.series.tune.clear();  // the values are found: the saved scenario repeats this run
    return record;
}

Driven driveSeries(const RunRecord& record, const Path& folder, const std::vector<Problem>& implausible,
                   const Tell& tell) {
    const OutputFolder output(folder);
    removeEarlierRun(output);
    writeFile(folder / "run.yaml", writeYaml(record));
    std::size_t count = 0;
    const SeriesResult found = series(
        record.scenario, [&](const Scenario& scenario) { return measure(record.vehicle, scenario); },
        [&](const Scenario& scenario) {
            RunRecord one = record;
            one.scenario = scenario;
            if (record.scenario.series.highest) one.scenario.accept = {};  // on the highest value, which no run knows
            const Driven driven = driveNaming(implausible, one, folder / folderOf(count++), tell);
            if (!driven.no_metrics.empty()) throw MetricError(driven.no_metrics);
            return driven.metrics;
        });

    Driven driven;
    driven.answer = answerOf(record, found);
    if (record.scenario.series.highest) driven.metrics = highestOf(record.scenario, found);
    driven.verdicts = verdictsOf(record.scenario, found, driven.metrics);
    driven.answer = withVerdict(driven.answer, driven.verdicts);
    driven.json = {{"answer", driven.answer},
                   {"tread_version", record.tread_version},
                   {"vehicle", record.vehicle.name},
                   {"scenario", record.scenario.title},
                   {"manoeuvre", record.scenario.manoeuvre},
                   {"number", found.number},
                   {"unit", found.unit},
                   {"metrics", tread::json(driven.metrics)},
                   {"verdicts", tread::json(driven.verdicts)},
                   {"warnings", driven.warnings},
                   {"runs", rows(found)}};
    writeFile(folder / "metrics.json", jsonText(driven.json));
    writeFile(folder / "series.csv", table(found));
    SeriesReport report{
        .title = record.scenario.title,
        .answer = driven.answer,
        .vehicle = record.vehicle.name,
        .scenario_description = record.scenario.description,
        .version = record.tread_version,
        .number = found.number,
        .unit = found.unit,
        .runs = {},
        .resolved_yaml = writeYaml(record),
        .verdicts = driven.verdicts,
        .highest = found.highest,
        .files = {{"series.csv", "series.csv"}, {"metrics.json", "metrics.json"}, {"run.yaml", "run.yaml"}}};
    for (std::size_t i = 0; i < found.runs.size(); ++i) {
        const SeriesRun& run = found.runs[i];
        report.runs.push_back(
            {run.value, run.passed, run.failure, run.metrics, run.failure.empty() ? folderOf(i) + "/report.html" : ""});
    }
    writeFile(folder / "report.html", seriesReport(report));
    return driven;
}

}  // namespace tread::program
