#include "metrics/metrics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "accepting.h"
#include "base/yaml_session.h"
#include "commands.h"
#include "describable.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "log/log_columns.h"
#include "output.h"
#include "run_inputs.h"

namespace tread::program {
namespace {

void expectKnown(std::string_view manoeuvre) {
    std::vector<std::string_view> names;
    for (const Manoeuvre& known : manoeuvres()) names.push_back(known.name);
    if (std::find(names.begin(), names.end(), manoeuvre) == names.end()) rejectName("manoeuvre", manoeuvre, names);
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
        const std::string manoeuvre = detected ? detectManoeuvre(log) : options.manoeuvre;
        KnownCar known;
        if (!options.scenario.empty()) known.course = readScenario(options.scenario).course;
        RunOptions asked;
        asked.accept = options.accept;
        asked.scenario = options.scenario;
        Scenario driven;
        driven.manoeuvre = manoeuvre;
        const Acceptance acceptance = acceptanceOf(asked, driven);
        const std::vector<Metric> found = tread::metrics(log, manoeuvre, known);
        const std::vector<Verdict> verdicts = tread::judge(acceptance, found);
        accepted = allMet(verdicts);
        if (options.json) {
            printJson({{"log", options.log},
                       {"manoeuvre", manoeuvre},
                       {"detected", detected},
                       {"metrics", tread::json(found)},
                       {"verdicts", tread::json(verdicts)}});
        } else {
            std::string words = text(manoeuvre, found);
            for (const Verdict& verdict : verdicts) words += "Verdict: " + text(verdict) + "\n";
            say(words, toneOf(verdicts));
        }
    } catch (const MetricError& error) {
        throw LoadError({{options.log, 0, 0, "", error.what()}});
    }
    return accepted ? kYes : kNo;
}

}  // namespace tread::program
