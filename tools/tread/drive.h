// One run into a folder: log, resolved inputs, metrics, report.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.h"
#include "log/log.h"
#include "metrics/metric.h"
#include "metrics/verdict.h"
#include "output_folder.h"
#include "report/html.h"
#include "run/run_record.h"

namespace tread::program {

struct Driven {
    std::string answer;
    std::vector<Metric> metrics;
    std::vector<Verdict> verdicts;
    std::vector<std::string> warnings;
    std::string no_metrics;  // why the manoeuvre has none; empty: it has, or there is no manoeuvre
    nlohmann::json json;     // what metrics.json holds
};

// Told the time in the run, s.
using Tell = std::function<void(double time)>;

// What a run would leave there.
void removeEarlierRun(const OutputFolder& output);

// What a run that has been driven answers.
Driven evaluate(const RunRecord& record, const Log& log);

// The page of a run, with links to files that lie beside it.
std::string reportOf(const RunRecord& record, const Log& log, const Driven& driven, std::vector<Link> files);

// Writes a run that has been driven as driveInto does. Throws FileError.
void saveRun(const RunRecord& record, const Log& log, const Driven& driven, const Path& folder);

// Throws SimulationError, which says what became of the rows so far; FileError.
Driven driveInto(const RunRecord& record, const Path& folder, const Tell& tell);

// The first Ctrl-C, or the end of the terminal, ends a run in order, the second the program.
void listenToSignals();
bool stopAsked();

// Asked in every step whether a run shall end, with Interrupted.
using Stop = std::function<bool()>;

// The metrics of a run that leaves nothing behind but its log, when one is given. Throws SimulationError, MetricError.
std::vector<Metric> measure(const VehicleParams& vehicle, const Scenario& scenario, Log* log = nullptr);
std::vector<Metric> measureUnless(const Stop& stop, const VehicleParams& vehicle, const Scenario& scenario, Log* log);

// Exit status of a program that was stopped so.
int stoppedStatus();

}  // namespace tread::program
