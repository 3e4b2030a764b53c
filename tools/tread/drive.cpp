#include "drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>
#include <system_error>
#include <utility>

#include "answer.h"
#include "base/yaml/write.h"
#include "log/csv.h"
#include "metrics/metrics.h"
#include "metrics/own/own_metrics.h"
#include "output.h"
#include "report/run_report.h"
#include "run/simulate.h"
#include "tyres_of.h"

namespace tread::program {
namespace {

constexpr int kSignalStatus = 128;  // shells add this to the number of the signal that ended a program

volatile std::sig_atomic_t stopped_by = 0;

extern "C" void stopRun(int signal) {
    stopped_by = signal;
    std::signal(signal, SIG_DFL);
}

// Runs the simulation and records it in the log file and in memory. If the run fails, `writer` keeps the rows so far.
Log drive(const RunRecord& record, const Path& file, std::optional<LogWriter>& writer, const Tell& tell) {
    Log log;
    const Recorder memory = recorderInto(log);
    Recorder recorder;
    recorder.begin = [&](const std::vector<Column>& columns) {
        writer.emplace(file, columns);
        memory.begin(columns);
    };
    recorder.row = [&](std::span<const double> row) {
        writer->write(row);
        memory.row(row);
        tell(row.front());
    };
    recorder.stop = [](double) { return stopped_by != 0; };
    simulate(record.vehicle, record.scenario, recorder);
    writer->finish();
    return log;
}

KnownCar knownOf(const VehicleParams& vehicle, const Scenario& scenario) {
    return {vehicle.wheelbase, vehicle.steering.ratio, scenario.course, vehicle.steering.ratio_curve};
}

void addOwn(std::vector<Metric>& metrics, const VehicleParams& vehicle, const Scenario& scenario, const Log& log) {
    if (scenario.metrics.empty()) return;
    for (Metric& own : ownMetrics(scenario.metrics, log, parametersOf(vehicle, scenario), scenario))
        metrics.push_back(std::move(own));
}

void saveResults(const RunRecord& record, const Log& log, const Driven& found, const Path& folder) {
    writeFile(folder / "metrics.json", jsonText(found.json));
    writeFile(folder / "report.html",
              reportOf(record, log, found,
                       {{"log.csv", "log.csv"}, {"metrics.json", "metrics.json"}, {"run.yaml", "run.yaml"}}));
}

}  // namespace

Driven evaluate(const RunRecord& record, const Log& log) {
    Driven found;
    if (const std::string& manoeuvre = record.scenario.manoeuvre; !manoeuvre.empty()) {
        try {
            found.metrics = tread::metrics(log, manoeuvre, knownOf(record.vehicle, record.scenario));
        } catch (const MetricError& error) {
            found.no_metrics = fmt::format("no metrics of {}: {}", manoeuvre, error.what());
            found.warnings.push_back(found.no_metrics);
        }
    }
    addOwn(found.metrics, record.vehicle, record.scenario, log);
    for (const auto& [path, tyre] : tyresOf(record.vehicle)) {
        for (const std::string& note : tyre->notes) {
            const auto& known = found.warnings;
            if (std::find(known.begin(), known.end(), note) == known.end()) found.warnings.push_back(note);
        }
    }
    found.verdicts = tread::judge(record.scenario.accept, found.metrics);
    found.answer = withVerdict(runAnswer(record, log, found.metrics), found.verdicts);
    found.json = {{"answer", found.answer},
                  {"tread_version", record.tread_version},
                  {"vehicle", record.vehicle.name},
                  {"scenario", record.scenario.title},
                  {"manoeuvre", record.scenario.manoeuvre},
                  {"warnings", found.warnings},
                  {"metrics", tread::json(found.metrics)},
                  {"verdicts", tread::json(found.verdicts)}};
    return found;
}

std::string reportOf(const RunRecord& record, const Log& log, const Driven& driven, std::vector<Link> files) {
    return runReport({.title = record.scenario.title,
                      .answer = driven.answer,
                      .vehicle = record.vehicle.name,
                      .scenario = record.scenario.title,
                      .scenario_description = record.scenario.description,
                      .version = record.tread_version,
                      .log = log,
                      .metrics = driven.metrics,
                      .verdicts = driven.verdicts,
                      .resolved_yaml = writeYaml(record),
                      .warnings = driven.warnings,
                      .files = std::move(files),
                      .record = &record});
}

void removeEarlierRun(const OutputFolder& output) {
    for (const char* name : {"log.csv", "log.incomplete.csv", "run.yaml", "metrics.json", "report.html", "series.csv"})
        output.remove(name);
}

void saveRun(const RunRecord& record, const Log& log, const Driven& driven, const Path& folder) {
    const OutputFolder output(folder);
    removeEarlierRun(output);
    writeFile(folder / "run.yaml", writeYaml(record));
    writeLog(folder / "log.csv", log);
    saveResults(record, log, driven, folder);
    output.complete();
}

Driven driveInto(const RunRecord& record, const Path& folder, const Tell& tell) {
    const OutputFolder output(folder);
    removeEarlierRun(output);
    writeFile(folder / "run.yaml", writeYaml(record));
    std::optional<LogWriter> writer;
    const auto withRows = [&](const SimulationError& error) {
        std::string text = error.what() + (writer ? "; " + writer->keepIncomplete() : "");
        output.complete();  // an end in order: what is there is of this run
        return text;
    };
    try {
        const Log log = drive(record, folder / "log.csv", writer, tell);
        Driven driven = evaluate(record, log);
        saveResults(record, log, driven, folder);
        output.complete();
        return driven;
    } catch (const Interrupted& error) {
        throw Interrupted(withRows(error), error.time);
    } catch (const SimulationError& error) {
        throw SimulationError(withRows(error), error.time, error.suspect);
    }
}

std::vector<Metric> measure(const VehicleParams& vehicle, const Scenario& scenario, Log* log) {
    return measureUnless(stopAsked, vehicle, scenario, log);
}

std::vector<Metric> measureUnless(const Stop& stop, const VehicleParams& vehicle, const Scenario& scenario, Log* kept) {
    Log own;
    Log& log = kept ? *kept : own;
    Recorder recorder = recorderInto(log);
    recorder.stop = [&](double) { return stop(); };
    simulate(vehicle, scenario, recorder, {}, MovedBy::itself);
    std::vector<Metric> found;
    if (!scenario.manoeuvre.empty() || scenario.metrics.empty())
        found = tread::metrics(log, scenario.manoeuvre, knownOf(vehicle, scenario));
    addOwn(found, vehicle, scenario, log);
    return found;
}

void listenToSignals() {
    std::signal(SIGINT, stopRun);
    std::signal(SIGTERM, stopRun);
    std::signal(SIGHUP, stopRun);
}

bool stopAsked() {
    return stopped_by != 0;
}

int stoppedStatus() {
    return kSignalStatus + stopped_by;
}

}  // namespace tread::program
