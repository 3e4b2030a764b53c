#include "run_inputs.h"

#include <algorithm>
#include <utility>

#include "accepting.h"
#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "base/pattern.h"
#include "base/setting.h"
#include "base/yaml_position.h"
#include "metrics/metrics.h"
#include "own_metrics.h"
#include "run/sensors.h"
#include "run/simulate.h"
#include "scenario/conditions.h"
#include "scenario/load.h"
#include "scenario/replay.h"
#include "series/series.h"
#include "tread/load.h"

namespace tread::program {
namespace {

// All fields that --set can change: those of the car under their own names, those of the scenario under "scenario.".
struct Settable {
    VehicleParams vehicle;
    Scenario scenario;

    static constexpr void describe(auto& self, auto&& field) {
        VehicleParams::describe(self.vehicle, field);
        field(TREAD_FIELD(scenario), About{"", "scenario"});
    }
    static void check(const auto& self, auto&& complain) { VehicleParams::check(self.vehicle, complain); }
};

std::string listingOf(std::string_view path) {
    if (path.starts_with("scenario")) return "`tread describe scenario` lists all paths behind \"scenario.\"";
    return "`tread describe vehicle` lists all paths";
}

struct Fault {
    std::string path;
    std::string text;
    TextPosition at = {};  // unless known: that of the path
};

// Names that the scenario itself cannot check: manoeuvres and channels.
std::vector<Fault> unknownNames(const Scenario& scenario, const std::string& file) {
    std::vector<Fault> faults;
    std::vector<std::string_view> known;
    for (const Manoeuvre& manoeuvre : manoeuvres()) known.push_back(manoeuvre.name);
    const std::string& name = scenario.manoeuvre;
    if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end()) {
        faults.push_back({"manoeuvre", "found the unknown manoeuvre " + quote(name) + ", expected " + listed(known) +
                                           ", or no such line for a run without metrics" + didYouMean(name, known)});
    }

    if (const std::string fault = faultOf(scenario); !fault.empty()) faults.push_back({"series", fault});
    const auto expectMetric = [&](const std::string& path, const std::string& metric) {
        std::vector<std::string> names;
        for (const MetricDefinition& definition : metricsOf(scenario)) names.push_back(definition.name);
        if (names.empty() || metric.empty() || std::find(names.begin(), names.end(), metric) != names.end()) return;
        const std::vector<std::string_view> views(names.begin(), names.end());
        faults.push_back({path, "found " + quote(metric) + ", which is no metric of " +
                                    (name.empty() ? "the scenario" : name) + didYouMean(metric, views) +
                                    "; `tread describe metrics` lists them"});
    };
    const SeriesParams& series = scenario.series;
    for (std::size_t i = 0; i < series.tune.size(); ++i)
        expectMetric("series.tune." + std::to_string(i) + ".metric", series.tune[i].metric);
    if (series.vary) expectMetric("series.vary.pass", series.vary->pass);
    if (series.highest) expectMetric("series.highest.pass", series.highest->pass);

    for (const AcceptFault& fault : acceptFaults(scenario.accept, ownerOf(scenario), acceptable(scenario))) {
        faults.push_back({joinPath("accept", fault.line.metric), fault.text, {fault.line.line, fault.line.column}});
    }

    const std::vector<KnownName> all = knownChannels(scenario);
    known.clear();
    for (const KnownName& channel : all) known.push_back(channel.name);
    for (std::size_t i = 0; i < scenario.log.channels.size(); ++i) {
        const std::string& pattern = scenario.log.channels[i];
        const auto fits = [&](std::string_view channel) { return matches(pattern, channel); };
        if (std::any_of(known.begin(), known.end(), fits)) continue;
        const std::string suggestion = didYouMean(pattern, known);
        faults.push_back({"log.channels." + std::to_string(i),
                          "found " + quote(pattern) + ", which fits no channel, expected a name or a pattern with *" +
                              (suggestion.empty() ? ";" : suggestion) + " `tread describe log` lists all channels"});
    }
    for (Problem& fault : faultsOfOwnMetrics(scenario, loggedChannels(scenario), file))
        faults.push_back({fault.path, std::move(fault.text), {fault.line, fault.column}});
    for (const ConditionFault& fault : conditionFaults(scenario, all))
        faults.push_back({fault.path, fault.text, positionWithin(file, fault.condition, fault.at)});
    for (SensorFault& fault : sensorFaults(scenario.log.sensors, known)) {
        faults.push_back({"log.sensors." + std::to_string(fault.sensor) + "." + fault.path, std::move(fault.text)});
    }
    return faults;
}

// A file of another kind has dozens of faults; the first of them are enough.
[[noreturn]] void refuse(std::vector<Problem> problems) {
    constexpr std::size_t kMost = 20;
    if (problems.size() > kMost) {
        const std::string more = std::to_string(problems.size() - kMost);
        problems.resize(kMost);
        problems.push_back({"", 0, 0, "", "and " + more + " more faults; `tread check` lists all"});
    }
    throw LoadError(std::move(problems));
}

}  // namespace

Scenario readScenario(const std::string& file) {
    Scenario scenario = loadScenario(file);
    std::vector<Problem> problems;
    for (const Fault& fault : unknownNames(scenario, file)) {
        const TextPosition position = fault.at.line > 0 ? fault.at : positionOfValue(file, fault.path);
        problems.push_back({file, position.line, position.column, fault.path, fault.text});
    }
    if (!problems.empty()) throw LoadError(std::move(problems));
    return scenario;
}

RunRecord readRunInputs(const RunOptions& options) {
    // Both files are read before any fault is reported.
    Settable inputs;
    std::vector<Problem> problems;
    const auto collect = [&](const auto& read) {
        try {
            read();
        } catch (const LoadError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        }
    };
    collect([&] { inputs.vehicle = loadVehicle(options.vehicle); });
    collect([&] { inputs.scenario = readScenario(options.scenario); });
    if (!problems.empty()) refuse(std::move(problems));

    if (!options.log.empty()) inputs.scenario.drive = options.log;
    constexpr const char* kSource = "--set";
    // The car settings of the scenario are applied as --set leaves them; --set itself is applied last.
    Settable asked = inputs;
    applySettings(asked, options.settings, kSource, listingOf);
    applySettings(inputs.vehicle, asked.scenario.car_settings, options.scenario + ": car_settings", listingOf);
    applySettings(inputs, options.settings, kSource, listingOf);
    for (const Fault& fault : unknownNames(inputs.scenario, "")) {
        problems.push_back({kSource, 0, 0, "scenario." + fault.path, fault.text});
    }
    if (!problems.empty()) throw LoadError(std::move(problems));
    inputs.scenario = withMetricsOf(options.metrics, std::move(inputs.scenario), loggedChannels(inputs.scenario));
    inputs.scenario.accept = merged(std::move(inputs.scenario.accept), acceptanceOf(options, inputs.scenario));

    RunRecord record;
    record.tread_version = TREAD_VERSION;
    record.vehicle = std::move(inputs.vehicle);
    record.scenario = withReplaysRead(std::move(inputs.scenario));
    return record;
}

}  // namespace tread::program
