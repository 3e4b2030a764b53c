#include <fmt/format.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/setting.h"
#include "base/write_yaml.h"
#include "commands.h"
#include "log/csv.h"
#include "metrics/metrics.h"
#include "progress.h"
#include "report/run_report.h"
#include "run/run_record.h"
#include "run/simulate.h"
#include "scenario/load.h"
#include "tread/load.h"
#include "write_file.h"

namespace tread::program {
namespace {

constexpr int kInterrupted = 130;  // what shells expect after Ctrl-C

volatile std::sig_atomic_t interrupted = 0;
void onInterrupt(int) {
    interrupted = 1;
}

// Vehicle and scenario with all settings applied.
RunRecord resolve(const RunOptions& options) {
    RunRecord record;
    record.tread_version = TREAD_VERSION;
    record.vehicle = loadVehicle(options.vehicle);
    record.scenario = loadScenario(options.scenario);
    constexpr std::string_view kScenario = "scenario.";
    std::vector<std::string> for_vehicle, for_scenario;
    for (const std::string& setting : options.settings) {
        if (setting.starts_with(kScenario)) for_scenario.push_back(setting.substr(kScenario.size()));
        else for_vehicle.push_back(setting);
    }
    applySettings(record.vehicle, for_vehicle, "--set");
    applySettings(record.scenario, for_scenario, "--set scenario.");
    return record;
}

// Runs into the log file and into memory; a failed run leaves its rows in log.incomplete.csv.
Log drive(const RunRecord& record, const Path& folder) {
    Log log;
    std::optional<LogWriter> writer;
    Progress progress(longestDuration(record.scenario));
    Recorder recorder;
    recorder.begin = [&](const std::vector<Column>& columns) {
        writer.emplace(folder / "log.csv", columns);
        for (const Column& column : columns) log.channels.push_back({column.name, column.unit, {}});
    };
    recorder.row = [&](std::span<const double> row) {
        writer->write(row);
        for (std::size_t i = 0; i < row.size(); ++i) log.channels[i].values.push_back(row[i]);
        progress.at(row.front());
    };
    recorder.stop = [](double) { return interrupted != 0; };
    simulate(record.vehicle, record.scenario, recorder);
    writer->finish();
    return log;
}

std::string answerOf(const RunRecord& record, const Log& log, const std::vector<Metric>& metrics) {
    std::string answer = fmt::format("{}, {}: {:.4g} s driven", record.scenario.title, record.vehicle.name,
                                     log.channels.front().values.back());
    constexpr std::size_t kShown = 3;
    for (std::size_t i = 0; i < std::min(kShown, metrics.size()); ++i) {
        std::string name = metrics[i].name;
        std::replace(name.begin(), name.end(), '_', ' ');
        answer += fmt::format(", {} {:.3g} {}", name, metrics[i].value, metrics[i].unit == "-" ? "" : metrics[i].unit);
        while (answer.back() == ' ') answer.pop_back();
    }
    return answer + ".";
}

nlohmann::json metricsJson(const RunRecord& record, const std::string& answer, const std::vector<Metric>& metrics) {
    nlohmann::json json{{"answer", answer},
                        {"tread_version", record.tread_version},
                        {"vehicle", record.vehicle.name},
                        {"scenario", record.scenario.title},
                        {"manoeuvre", record.scenario.manoeuvre},
                        {"metrics", nlohmann::json::array()}};
    for (const Metric& m : metrics) {
        json["metrics"].push_back(
            {{"name", m.name}, {"value", m.value}, {"unit", m.unit}, {"definition", m.definition}});
    }
    return json;
}

void saveResults(const RunRecord& record, const Log& log, const RunOptions& options, const Path& folder) {
    // Metrics.
    std::vector<std::string> warnings;
    std::vector<Metric> found;
    if (!record.scenario.manoeuvre.empty()) {
        try {
            found = tread::metrics(log, record.scenario.manoeuvre,
                                   {record.vehicle.wheelbase, record.vehicle.steering.ratio});
        } catch (const MetricError& error) {
            warnings.push_back(fmt::format("no metrics of {}: {}", record.scenario.manoeuvre, error.what()));
        }
    }
    for (const TyreParams* tyre : {&record.vehicle.front.tyre, &record.vehicle.rear.tyre}) {
        warnings.insert(warnings.end(), tyre->notes.begin(), tyre->notes.end());
    }
    for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);

    // Files.
    const std::string answer = answerOf(record, log, found);
    const std::string resolved = writeYaml(record);
    const nlohmann::json json = metricsJson(record, answer, found);
    writeFile(folder / "run.yaml", resolved);
    writeFile(folder / "metrics.json", json.dump(2) + "\n");
    writeFile(folder / "report.html", runReport({.title = record.scenario.title,
                                                 .answer = answer,
                                                 .vehicle = record.vehicle.name,
                                                 .scenario = record.scenario.title,
                                                 .scenario_description = record.scenario.description,
                                                 .version = record.tread_version,
                                                 .log = log,
                                                 .metrics = found,
                                                 .resolved_yaml = resolved,
                                                 .warnings = warnings}));

    // Answer.
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
        return;
    }
    fmt::print("{}\n", answer);
    for (const Metric& m : found) fmt::print("  {:<36} {:>12.5g} {}\n", m.name, m.value, m.unit);
    fmt::print("Report: {}\n", std::filesystem::absolute(folder / "report.html").lexically_normal().string());
}

}  // namespace

int run(const RunOptions& options) {
    const RunRecord record = resolve(options);
    const Path folder = options.output.empty() ? Path("out") / Path(options.scenario).stem() : Path(options.output);
    makeFolder(folder);

    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
    try {
        const Log log = drive(record, folder);
        saveResults(record, log, options, folder);
    } catch (const SimulationError& error) {
        const Path rows = folder / "log.incomplete.csv";
        const bool kept = std::filesystem::exists(rows);
        fmt::print(stderr, "tread run: {}{}\n", error.what(),
                   kept ? fmt::format("; the log so far is in {}", rows.string()) : "");
        return dynamic_cast<const Interrupted*>(&error) ? kInterrupted : kRunFailed;
    }
    return kYes;
}

}  // namespace tread::program
