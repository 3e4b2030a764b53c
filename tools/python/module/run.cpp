// A car through a scenario, into memory.
#include <pybind11/stl.h>

#include <utility>

#include "bind.h"
#include "interruptible.h"
#include "logged_run.h"
#include "plausibility.h"
#include "run/simulate.h"
#include "run_inputs.h"
#include "run_series.h"
#include "scenario/load.h"
#include "series/series.h"

namespace tread::python {
namespace {

using program::RunOptions;

bool isSingle(const Scenario& scenario) {
    return !scenario.series.vary && !scenario.series.highest;
}

void expectOneRun(const RunOptions& options, const Scenario& scenario) {
    if (isSingle(scenario)) return;
    throw LoadError({{options.scenario, 0, 0, "series",
                      "found a series of runs, expected a single run; tread.run_series drives it"}});
}

Log driven(const RunRecord& record, const Watch& watch) {
    Log log;
    const double longest = longestDuration(record.scenario);
    const Recorder memory = recorderInto(log);
    Recorder recorder = memory;
    recorder.row = [&](std::span<const double> row) {
        memory.row(row);
        watch.tell(std::min(1.0, row.front() / longest));
    };
    recorder.stop = [&](double) { return watch.stop(); };
    simulate(record.vehicle, record.scenario, recorder);
    return log;
}

LoggedRunPointer run(const RunOptions& options, const Watch& watch) {
    auto [record, implausible] = program::readRunInputs(options);
    expectOneRun(options, record.scenario);
    auto result = std::make_shared<LoggedRun>();
    try {
        result->record = program::tunedRecord(std::move(record), watch.stop);
        result->log = driven(*result->record, watch);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError& error) {
        throw SimulationError(program::withSuspects(error, implausible), error.time, error.suspect);
    }
    result->name = result->record->scenario.title;
    for (const Problem& warning : implausible) result->warnings.push_back(toText(warning));
    return result;
}

struct DrivenSeries {
    SeriesResult result;
    std::vector<std::string> warnings;
};

DrivenSeries runSeries(const RunOptions& options, const Watch& watch) {
    auto [record, implausible] = program::readRunInputs(options);
    if (isSingle(record.scenario))
        throw LoadError(
            {{options.scenario, 0, 0, "series", "found none, expected a series of runs; tread.run drives it"}});
    const RunRecord ready = program::tunedRecord(std::move(record), watch.stop);
    const Measure measure = [&](const Scenario& scenario) {
        return program::measureUnless(watch.stop, ready.vehicle, scenario, nullptr);
    };
    DrivenSeries found{series(ready.scenario, measure, measure), {}};
    for (const Problem& warning : implausible) found.warnings.push_back(toText(warning));
    return found;
}

py::tuple tupleOf(const DrivenSeries& driven) {
    py::list runs;
    for (const SeriesRun& run : driven.result.runs) {
        py::dict metrics;
        for (const Metric& metric : run.metrics) metrics[py::str(metric.name)] = metric.value;
        runs.append(py::make_tuple(run.value, run.passed, run.failure, metrics));
    }
    const SeriesResult& result = driven.result;
    return py::make_tuple(result.number, result.unit, runs, result.highest, driven.warnings);
}

RunOptions optionsOf(const std::string& vehicle, const std::string& scenario, const std::vector<std::string>& settings,
                     const std::string& log, const std::string& metrics, const std::string& accept, bool strict) {
    RunOptions options;
    options.vehicle = vehicle, options.scenario = scenario;
    options.settings = settings, options.settings_source = "settings";
    options.log = log, options.metrics = metrics, options.accept = accept;
    options.strict = strict;
    return options;
}

}  // namespace

void bindRun(py::module_& module) {
    module.def(
        "run",
        [](const std::string& vehicle, const std::string& scenario, const std::vector<std::string>& settings,
           const std::string& log, const std::string& metrics, const std::string& accept, bool strict,
           const py::object& progress) {
            const RunOptions options = optionsOf(vehicle, scenario, settings, log, metrics, accept, strict);
            return interruptible([&](const Watch& watch) { return run(options, watch); }, progress);
        },
        py::arg("vehicle"), py::arg("scenario"), py::arg("settings"), py::arg("log"), py::arg("metrics"),
        py::arg("accept"), py::arg("strict"), py::arg("progress"));
    module.def(
        "run_series",
        [](const std::string& vehicle, const std::string& scenario, const std::vector<std::string>& settings,
           const std::string& metrics, bool strict) {
            const RunOptions options = optionsOf(vehicle, scenario, settings, "", metrics, "", strict);
            return tupleOf(interruptible([&](const Watch& watch) { return runSeries(options, watch); }));
        },
        py::arg("vehicle"), py::arg("scenario"), py::arg("settings"), py::arg("metrics"), py::arg("strict"));
}

}  // namespace tread::python
