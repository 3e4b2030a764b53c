#include "metrics/metrics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "accepting.h"
#include "base/yaml/session.h"
#include "commands.h"
#include "describable.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "log/log_columns.h"
#include "output.h"
#include "own_metrics.h"
#include "run_inputs.h"
#include "tread/load.h"

namespace tread::program {
namespace {

void expectKnown(std::string_view manoeuvre) {
    std::vector<std::string_view> names;
    for (const Manoeuvre& known : manoeuvres()) names.push_back(known.name);
    if (std::find(names.begin(), names.end(), manoeuvre) == names.end()) rejectName("manoeuvre", manoeuvre, names);
}

// What is known of the drive besides its log: the scenario that was driven, with the metrics of the file.
Scenario drivenScenario(const MetricsOptions& options, const Log& log) {
    Scenario scenario;
    if (!options.scenario.empty()) scenario = readScenario(options.scenario);
    return withMetricsOf(options.metrics, std::move(scenario), loggedChannels(log));
}

// A log with metrics of the user's own need not show a known manoeuvre.
std::string manoeuvreOf(const Log& log, const Scenario& driven) {
    if (driven.metrics.empty()) return detectManoeuvre(log);
    try {
        return detectManoeuvre(log);
    } catch (const MetricError&) {
        return {};
    }
}

std::vector<RunParameter> parametersOfRun(const MetricsOptions& options, const Scenario& driven) {
    if (options.vehicle.empty()) return parametersOf(driven);
    return parametersOf(loadVehicle(options.vehicle), driven);
}

}  // namespace

int metrics(const MetricsOptions& options) {
    const bool detected = options.manoeuvre.empty();
    if (!detected) expectKnown(options.manoeuvre);
    expectKind(options.log, {"log"});
    expectKind(options.scenario, {"scenario"});
    expectKind(options.accept, {"accept"});
    const Log log = readLog(options.log);
    throwIfAny(unitFaults(log, options.log));

    bool accepted = true;
    try {
        Scenario driven = drivenScenario(options, log);
        const std::string manoeuvre = detected ? manoeuvreOf(log, driven) : options.manoeuvre;
        const KnownCar known{.course = driven.course};
        driven.manoeuvre = manoeuvre;
        driven.series = {};
        RunOptions asked;
        asked.accept = options.accept;
        asked.scenario = options.scenario;
        const Acceptance acceptance = acceptanceOf(asked, driven);
        std::vector<Metric> found;
        if (!manoeuvre.empty()) found = tread::metrics(log, manoeuvre, known);
        for (Metric& own : ownMetrics(driven.metrics, log, parametersOfRun(options, driven), driven))
            found.push_back(std::move(own));
        const std::vector<Verdict> verdicts = tread::judge(acceptance, found);
        accepted = allMet(verdicts);
        if (options.json) {
            printJson({{"log", options.log},
                       {"manoeuvre", manoeuvre},
                       {"detected", detected},
                       {"metrics", tread::json(found)},
                       {"verdicts", tread::json(verdicts)}});
        } else {
            std::string words = text(manoeuvre.empty() ? "no known manoeuvre" : manoeuvre, found);
            for (const Verdict& verdict : verdicts) words += "Verdict: " + text(verdict) + "\n";
            say(words, toneOf(verdicts));
        }
    } catch (const MetricError& error) {
        throw LoadError({{options.log, 0, 0, "", error.what()}});
    }
    return accepted ? kYes : kNo;
}

}  // namespace tread::program
