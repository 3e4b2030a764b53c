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

namespace tread::python {
namespace {

using program::RunOptions;

void expectOneRun(const RunOptions& options, const Scenario& scenario) {
    if (!scenario.series.vary && !scenario.series.highest) return;
    throw LoadError({{options.scenario, 0, 0, "series",
                      "found a series of runs, expected a single run; call tread.run once for each value"}});
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

}  // namespace

void bindRun(py::module_& module) {
    module.def(
        "run",
        [](const std::string& vehicle, const std::string& scenario, const std::vector<std::string>& settings,
           const std::string& log, const std::string& metrics, const std::string& accept, bool strict,
           const py::object& progress) {
            RunOptions options;
            options.vehicle = vehicle, options.scenario = scenario;
            options.settings = settings, options.settings_source = "settings";
            options.log = log, options.metrics = metrics, options.accept = accept;
            options.strict = strict;
            return interruptible([&](const Watch& watch) { return run(options, watch); }, progress);
        },
        py::arg("vehicle"), py::arg("scenario"), py::arg("settings"), py::arg("log"), py::arg("metrics"),
        py::arg("accept"), py::arg("strict"), py::arg("progress"));
}

}  // namespace tread::python
