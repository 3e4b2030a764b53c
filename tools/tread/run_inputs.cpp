#include "run_inputs.h"

#include <algorithm>
#include <utility>

#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "base/setting.h"
#include "base/text_file.h"
#include "base/yaml_document.h"
#include "metrics/metrics.h"
#include "scenario/load.h"
#include "tread/load.h"

namespace tread::program {
namespace {

// All that --set reaches: the fields of the car by their own names, those of the scenario behind "scenario.".
struct Settable {
    VehicleParams vehicle;
    Scenario scenario;

    static constexpr void describe(auto& self, auto&& field) {
        VehicleParams::describe(self.vehicle, field);
        field(TREAD_FIELD(scenario), About{"", "scenario"});
    }
    static void check(const auto& self, auto&& complain) { VehicleParams::check(self.vehicle, complain); }
};

// Empty when metrics of that name exist, or none are asked for.
std::string manoeuvreFault(const std::string& name) {
    std::vector<std::string_view> names;
    for (const Manoeuvre& known : manoeuvres()) names.push_back(known.name);
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return {};
    return "found the unknown manoeuvre " + quote(name) + ", expected " + listed(names) + didYouMean(name, names) +
           "; without a manoeuvre the run has no metrics";
}

// Where a top-level key of a file has its value; {0, 0} when it has none.
TextPosition positionOfValue(const std::string& file, std::string_view key) {
    std::string fault;
    std::vector<Problem> problems;
    const auto text = readTextFile(file, fault);
    const auto document = text ? parseYaml(*text, file, problems) : std::nullopt;
    if (!document) return {0, 0};
    const std::vector<std::size_t>& children = document->root().children;
    for (std::size_t i = 0; i + 1 < children.size(); i += 2) {
        const YamlNode& value = document->nodes[children[i + 1]];
        if (document->nodes[children[i]].text == key) return {value.line, value.column};
    }
    return {0, 0};
}

Scenario readScenario(const std::string& file) {
    Scenario scenario = loadScenario(file);
    if (const std::string fault = manoeuvreFault(scenario.manoeuvre); !fault.empty()) {
        const TextPosition position = positionOfValue(file, "manoeuvre");
        throw LoadError({{file, position.line, position.column, "manoeuvre", fault}});
    }
    return scenario;
}

}  // namespace

RunRecord readRunInputs(const RunOptions& options) {
    // Both files are read before anything is complained about.
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
    if (!problems.empty()) throw LoadError(std::move(problems));

    constexpr const char* kSource = "--set";
    applySettings(inputs, options.settings, kSource);
    if (const std::string fault = manoeuvreFault(inputs.scenario.manoeuvre); !fault.empty()) {
        throw LoadError({{kSource, 0, 0, "scenario.manoeuvre", fault}});
    }
    RunRecord record;
    record.tread_version = TREAD_VERSION;
    record.vehicle = std::move(inputs.vehicle);
    record.scenario = std::move(inputs.scenario);
    return record;
}

}  // namespace tread::program
