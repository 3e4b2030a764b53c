#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "answer.h"
#include "base/write_yaml.h"
#include "commands.h"
#include "log/csv.h"
#include "metrics/metrics.h"
#include "output.h"
#include "progress.h"
#include "report/run_report.h"
#include "run/simulate.h"
#include "run_inputs.h"
#include "scenario/load.h"
#include "tyres_of.h"

namespace tread::program {
namespace {

constexpr int kSignalStatus = 128;  // what shells add to the signal that ended a program

volatile std::sig_atomic_t stopped_by = 0;

// The first Ctrl-C ends the run in order, the second ends the program.
extern "C" void stopRun(int signal) {
    stopped_by = signal;
    std::signal(signal, SIG_DFL);
}

void listenToSignals() {
    std::signal(SIGINT, stopRun);
    std::signal(SIGTERM, stopRun);
}

// A folder for the results, without those of an earlier run: what it holds at the end is of this run.
void prepareFolder(const Path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw FileError(
            fmt::format("cannot create the folder {}: {}; choose another with -o", folder.string(), error.message()));
    }
    for (const char* name : {"log.csv", "log.incomplete.csv", "run.yaml", "metrics.json", "report.html"}) {
        const Path file = folder / name;
        std::filesystem::remove(file, error);
        if (error) {
            throw FileError(
                fmt::format("cannot remove {}, which an earlier run has left: {}; choose another folder with -o",
                            file.string(), error.message()));
        }
    }
}

// Runs into the log file and into memory. A run that fails leaves a writer with the rows so far.
Log drive(const RunRecord& record, const Path& file, std::optional<LogWriter>& writer) {
    Log log;
    Progress progress(longestDuration(record.scenario));
    Recorder recorder;
    recorder.begin = [&](const std::vector<Column>& columns) {
        writer.emplace(file, columns);
        for (const Column& column : columns) log.channels.push_back({column.name, column.unit, {}});
    };
    recorder.row = [&](std::span<const double> row) {
        writer->write(row);
        for (std::size_t i = 0; i < row.size(); ++i) log.channels[i].values.push_back(row[i]);
        progress.at(row.front());
    };
    recorder.stop = [](double) { return stopped_by != 0; };
    simulate(record.vehicle, record.scenario, recorder);
    writer->finish();
    return log;
}

struct Findings {
    std::vector<Metric> metrics;
    std::vector<std::string> warnings;
};

Findings evaluate(const RunRecord& record, const Log& log) {
    Findings found;
    if (const std::string& manoeuvre = record.scenario.manoeuvre; !manoeuvre.empty()) {
        try {
            found.metrics = tread::metrics(log, manoeuvre, {record.vehicle.wheelbase, record.vehicle.steering.ratio});
        } catch (const MetricError& error) {
            found.warnings.push_back(fmt::format("no metrics of {}: {}", manoeuvre, error.what()));
        }
    }
    for (const auto& [path, tyre] : tyresOf(record.vehicle)) {
        for (const std::string& note : tyre->notes) {
            const auto& known = found.warnings;
            if (std::find(known.begin(), known.end(), note) == known.end()) found.warnings.push_back(note);
        }
    }
    return found;
}

void saveResults(const RunRecord& record, const Log& log, const RunOptions& options, const Path& folder) {
    const Findings found = evaluate(record, log);
    for (const std::string& warning : found.warnings) fmt::print(stderr, "warning: {}\n", warning);
    const std::string answer = runAnswer(record, log, found.metrics);
    const nlohmann::json json{{"answer", answer},
                              {"tread_version", record.tread_version},
                              {"vehicle", record.vehicle.name},
                              {"scenario", record.scenario.title},
                              {"manoeuvre", record.scenario.manoeuvre},
                              {"warnings", found.warnings},
                              {"metrics", tread::json(found.metrics)}};
    writeFile(folder / "metrics.json", jsonText(json));
    writeFile(folder / "report.html", runReport({.title = record.scenario.title,
                                                 .answer = answer,
                                                 .vehicle = record.vehicle.name,
                                                 .scenario = record.scenario.title,
                                                 .scenario_description = record.scenario.description,
                                                 .version = record.tread_version,
                                                 .log = log,
                                                 .metrics = found.metrics,
                                                 .resolved_yaml = writeYaml(record),
                                                 .warnings = found.warnings,
                                                 .record = &record}));
    if (options.json) {
        printJson(json);
        return;
    }
    std::string text = answer + "\n";
    for (const Metric& m : found.metrics) {
        const std::string value = std::isnan(m.value) ? "undefined" : fmt::format("{:.5g}", m.value);
        text += fmt::format("  {:<36} {:>12} {}\n", m.name, value, m.unit);
    }
    text += fmt::format("Report: {}\n", std::filesystem::absolute(folder / "report.html").lexically_normal().string());
    print(text);
}

}  // namespace

int run(const RunOptions& options) {
    const RunRecord record = readRunInputs(options);
    const Path folder = options.output.empty() ? Path("out") / Path(options.scenario).stem() : Path(options.output);
    listenToSignals();
    prepareFolder(folder);
    writeFile(folder / "run.yaml", writeYaml(record));
    std::optional<LogWriter> writer;
    try {
        saveResults(record, drive(record, folder / "log.csv", writer), options, folder);
    } catch (const SimulationError& error) {
        const std::string rows = writer ? "; " + writer->keepIncomplete() : "";
        fmt::print(stderr, "tread run: {}{}\n", error.what(), rows);
        return dynamic_cast<const Interrupted*>(&error) ? kSignalStatus + stopped_by : kRunFailed;
    }
    return kYes;
}

}  // namespace tread::program
