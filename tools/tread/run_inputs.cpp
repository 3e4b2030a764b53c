#include "run_inputs.h"

#include <algorithm>
#include <utility>

#include "accepting.h"
#include "base/changed.h"
#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "base/pattern.h"
#include "base/setting.h"
#include "base/trimmed.h"
#include "base/write_yaml.h"
#include "base/yaml_position.h"
#include "metrics/metrics.h"
#include "run/sensors.h"
#include "run/simulate.h"
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
std::vector<Fault> unknownNames(const Scenario& scenario) {
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
        for (const Manoeuvre& manoeuvre : manoeuvres()) {
            if (manoeuvre.name != name || metric.empty()) continue;
            std::vector<std::string> names;
            for (const MetricDefinition& definition : manoeuvre.definitions()) names.push_back(definition.name);
            if (std::find(names.begin(), names.end(), metric) != names.end()) continue;
            const std::vector<std::string_view> views(names.begin(), names.end());
            faults.push_back({path, "found " + quote(metric) + ", which is no metric of " + name +
                                        didYouMean(metric, views) + "; `tread describe metrics` lists them"});
        }
    };
    const SeriesParams& series = scenario.series;
    for (std::size_t i = 0; i < series.tune.size(); ++i)
        expectMetric("series.tune." + std::to_string(i) + ".metric", series.tune[i].metric);
    if (series.vary) expectMetric("series.vary.pass", series.vary->pass);
    if (series.highest) expectMetric("series.highest.pass", series.highest->pass);

    for (const AcceptFault& fault : acceptFaults(scenario.accept, ownerOf(scenario), acceptable(scenario))) {
        faults.push_back({joinPath("accept", fault.line.metric), fault.text, {fault.line.line, fault.line.column}});
    }

    const std::vector<Column> all = recordedColumns({});
    known.clear();
    for (const Column& column : all) known.push_back(column.name);
    for (std::size_t i = 0; i < scenario.log.channels.size(); ++i) {
        const std::string& pattern = scenario.log.channels[i];
        const auto fits = [&](std::string_view channel) { return matches(pattern, channel); };
        if (std::any_of(known.begin(), known.end(), fits)) continue;
        const std::string suggestion = didYouMean(pattern, known);
        faults.push_back({"log.channels." + std::to_string(i),
                          "found " + quote(pattern) + ", which fits no channel, expected a name or a pattern with *" +
                              (suggestion.empty() ? ";" : suggestion) + " `tread describe log` lists all channels"});
    }
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
        const std::string old =
            writtenValue(of_scenario ? options.scenario : options.vehicle, path).value_or(valueText(was->item));
        std::string given(trimmed(std::string_view(setting).substr(equals + 1)));
        std::string_view unit = given;
        if (takeNumber(unit) && trimmed(unit).empty() && !is->item.comment.empty()) given += " " + is->item.comment;
        std::string& name = of_scenario ? inputs.scenario.title : inputs.vehicle.name;
        name = withChange(name, path + " " + given + (old.empty() ? "" : " (was " + old + ")"));
    }
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
    for (const Fault& fault : unknownNames(scenario)) {
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
    const Settable before = inputs;
    applySettings(inputs, options.settings, kSource, listingOf);
    sayChanges(inputs, before, options);
    for (const Fault& fault : unknownNames(inputs.scenario)) {
        problems.push_back({kSource, 0, 0, "scenario." + fault.path, fault.text});
    }
    if (!problems.empty()) throw LoadError(std::move(problems));
    inputs.scenario.accept = merged(std::move(inputs.scenario.accept), acceptanceOf(options, inputs.scenario));

    RunRecord record;
    record.tread_version = TREAD_VERSION;
    record.vehicle = std::move(inputs.vehicle);
    record.scenario = withReplaysRead(std::move(inputs.scenario));
    return record;
}

}  // namespace tread::program
