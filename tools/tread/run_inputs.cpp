#include "run_inputs.h"

#include <algorithm>
#include <utility>

#include "accepting.h"
#include "base/text/changed.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/pattern.h"
#include "base/text/trimmed.h"
#include "base/yaml/position.h"
#include "base/yaml/setting.h"
#include "base/yaml/write.h"
#include "campaign/subject.h"
#include "kind_of_file.h"
#include "metrics/metrics.h"
#include "own_metrics.h"
#include "plausibility.h"
#include "run/sensors.h"
#include "run/simulate.h"
#include "scenario/conditions.h"
#include "scenario/load.h"
#include "scenario/replay.h"
#include "series/series.h"
#include "shipped_file.h"
#include "vehicle/fields.h"

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
    const bool known_or_none = name.empty() || std::find(known.begin(), known.end(), name) != known.end();
    if (!known_or_none) {
        faults.push_back({"manoeuvre", "found the unknown manoeuvre " + quote(name) + ", expected " + listed(known) +
                                           ", or no such line for a run without metrics" + didYouMean(name, known)});
    }

    if (const std::string fault = faultOf(scenario); !fault.empty()) faults.push_back({"series", fault});
    const auto expectMetric = [&](const std::string& path, const std::string& metric) {
        std::vector<std::string> names;
        for (const MetricDefinition& definition : metricsOf(scenario)) names.push_back(definition.name);
        if (names.empty() || metric.empty() || std::find(names.begin(), names.end(), metric) != names.end()) return;
        const std::vector<std::string_view> views(names.begin(), names.end());
        faults.push_back({path, "found " + quote(metric) + ", which is not a metric of " +
                                    (name.empty() ? "the scenario" : name) + didYouMean(metric, views) +
                                    "; `tread describe metrics` lists them"});
    };
    const SeriesParams& series = scenario.series;
    for (std::size_t i = 0; i < series.tune.size(); ++i)
        expectMetric("series.tune." + std::to_string(i) + ".metric", series.tune[i].metric);
    if (series.vary) expectMetric("series.vary.pass", series.vary->pass);
    if (series.highest) expectMetric("series.highest.pass", series.highest->pass);

    // Nobody knows the metrics of an unknown manoeuvre.
    const Acceptance accept = known_or_none ? scenario.accept : Acceptance{};
    for (const AcceptFault& fault : acceptFaults(accept, ownerOf(scenario), acceptable(scenario))) {
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
                          "found " + quote(pattern) +
                              ", which matches no channel, expected a name or a pattern with *" +
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

// The field of a setting as YAML; its path without old names. Nothing where there is no such field.
struct Field {
    std::string path;
    YamlItem item;
};
std::optional<Field> fieldAt(Settable inputs, const std::string& path) {
    std::optional<Field> found;
    tread::detail::visitField(inputs, path, About{}, [&](const auto& field, const About& about, const std::string& at) {
        found = {at, tread::detail::itemOf("", field, about)};
    });
    return found;
}

// "22.2 m/s"; empty for what is no single word or number.
std::string valueText(const YamlItem& item) {
    if (item.kind != YamlItem::Kind::scalar) return {};
    return item.comment.empty() ? item.text : item.text + " " + item.comment;
}

// Titles state values ("at 80 km/h") and names stand for a car as its file has it: both say what the command line has
// changed. The value before is quoted from the file, or is that of an included file or a default.
void sayChanges(Settable& inputs, const Settable& before, const RunOptions& options) {
    constexpr std::string_view kScenario = "scenario.";
    for (const std::string& setting : options.settings) {
        const std::size_t equals = setting.find('=');
        const auto was = fieldAt(before, std::string(trimmed(setting.substr(0, equals))));
        const auto is = was ? fieldAt(inputs, was->path) : std::nullopt;
        if (!is || yamlText(was->item) == yamlText(is->item)) continue;
        const bool of_scenario = was->path.starts_with(kScenario);
        const std::string path = of_scenario ? was->path.substr(kScenario.size()) : was->path;
        const auto written = writtenValue(of_scenario ? options.scenario : options.vehicle, path);
        const std::string old = written && !written->text.empty() ? written->text : valueText(was->item);
        std::string given(trimmed(std::string_view(setting).substr(equals + 1)));
        std::string_view unit = given;
        if (takeNumber(unit) && trimmed(unit).empty() && !is->item.comment.empty()) given += " " + is->item.comment;
        std::string& name = of_scenario ? inputs.scenario.title : inputs.vehicle.name;
        name = withChange(name, path + " " + given + (old.empty() ? "" : " (was " + old + ")"));
    }
}

std::vector<Problem> placed(const std::vector<Fault>& faults, const std::string& file) {
    std::vector<Problem> problems;
    for (const Fault& fault : faults) {
        const TextPosition position = fault.at.line > 0 ? fault.at : positionOfValue(file, fault.path);
        problems.push_back({file, position.line, position.column, fault.path, fault.text});
    }
    return problems;
}

}  // namespace

VehicleParams readVehicle(const std::string& file, std::vector<Problem>& problems) {
    return readYaml<VehicleParams>(file, problems);
}

Scenario readScenario(const std::string& file, std::vector<Problem>& problems) {
    std::vector<Problem> faults;
    Scenario scenario = loadScenario(file, faults);
    addFurther(faults, placed(unknownNames(scenario, file), file));
    problems.insert(problems.end(), faults.begin(), faults.end());
    return scenario;
}

Scenario readScenario(const std::string& file) {
    std::vector<Problem> problems;
    Scenario scenario = readScenario(file, problems);
    throwIfAny(std::move(problems));
    return scenario;
}

RunInputs readRunInputs(const RunOptions& given) {
    RunOptions options = given;
    options.vehicle = shippedFile(options.vehicle, "vehicles");
    options.scenario = shippedFile(options.scenario, "scenarios");
    // All files and settings are looked at before any fault is reported; what is found in a later one holds whatever
    // the correction of an earlier fault will be.
    Settable inputs;
    std::vector<Problem> problems;
    const auto collect = [&](const auto& read) {
        try {
            read();
        } catch (const LoadError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        }
    };
    collect([&] {
        expectKind(options.vehicle, {"vehicle"});
        inputs.vehicle = readVehicle(options.vehicle, problems);
    });
    const std::size_t of_the_car = problems.size();
    collect([&] {
        expectKind(options.scenario, {"scenario"});
        inputs.scenario = readScenario(options.scenario, problems);
    });
    const bool scenario_is_sound = problems.size() == of_the_car;
    if (!options.log.empty()) inputs.scenario.drive = options.log;
    collect([&] { expectKind(options.log, {"log"}); });

    const std::string& source = options.settings_source;
    const std::vector<Fault> before = unknownNames(inputs.scenario, "");
    // The car settings of the scenario are applied as --set leaves them; --set itself is applied last.
    Settable asked = inputs;
    std::vector<std::string> car_settings;
    collect([&] {
        applySettings(asked, options.settings, source, campaign::listingOf);
        car_settings = asked.scenario.car_settings;
        applySettings(inputs.vehicle, car_settings, options.scenario + ": car_settings", campaign::listingOf);
        const Settable file = inputs;
        applySettings(inputs, options.settings, source, campaign::listingOf);
        sayChanges(inputs, file, options);
    });
    for (const Fault& fault : unknownNames(inputs.scenario, "")) {
        const auto same = [&](const Fault& old) { return old.path == fault.path && old.text == fault.text; };
        if (std::any_of(before.begin(), before.end(), same)) continue;
        problems.push_back({source, 0, 0, "scenario." + fault.path, fault.text});
    }
    collect([&] {
        expectKind(options.accept, {"accept"});
        if (!scenario_is_sound) return;
        inputs.scenario = withMetricsOf(options.metrics, std::move(inputs.scenario), loggedChannels(inputs.scenario));
        inputs.scenario.accept = merged(std::move(inputs.scenario.accept), acceptanceOf(options, inputs.scenario));
    });

    const AppliedSettings set{options.settings, source}, set_scenario{options.settings, source, "scenario."};
    std::vector<Problem> warnings =
        implausibleIn(inputs.vehicle, options.vehicle, {{car_settings, options.scenario, "", "car_settings"}, set});
    for (Problem& warning : implausibleIn(inputs.scenario, options.scenario, {set_scenario}))
        warnings.push_back(std::move(warning));
    if (options.strict) problems.insert(problems.end(), warnings.begin(), warnings.end());
    if (!options.strict) warnOfImplausible(warnings);
    throwIfAny(std::move(problems));

    RunRecord record;
    record.tread_version = TREAD_VERSION;
    record.vehicle = std::move(inputs.vehicle);
    record.scenario = withReplaysRead(std::move(inputs.scenario));
    return {std::move(record), std::move(warnings)};
}

}  // namespace tread::program
