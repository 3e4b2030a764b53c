#include "accepting.h"

#include <algorithm>

#include "base/fields/field_path.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "metrics/metrics.h"
#include "own_metrics.h"
#include "series/series.h"

namespace tread::program {
namespace {

Problem problemAt(const std::string& file, const AcceptFault& fault) {
    return {file, fault.line.line, fault.line.column, joinPath("accept", fault.line.metric), fault.text};
}

bool has(const std::vector<MetricDefinition>& known, const std::string& metric) {
    return std::any_of(known.begin(), known.end(), [&](const MetricDefinition& about) { return about.name == metric; });
}

std::vector<MetricDefinition> allMetrics() {
    std::vector<MetricDefinition> all;
    for (const Manoeuvre& manoeuvre : manoeuvres()) {
        for (MetricDefinition& definition : manoeuvre.definitions()) all.push_back(std::move(definition));
    }
    return all;
}

// Whether a name is that of no manoeuvre's metric, nor nearly so: then it can be a metric of the user's own.
bool mayBeOwn(const std::string& metric) {
    const std::vector<MetricDefinition> known = allMetrics();
    std::vector<std::string_view> names;
    for (const MetricDefinition& about : known) names.push_back(about.name);
    return !metric.starts_with("highest_") && !has(known, metric) && !closest(metric, names);
}

std::string ownMetricNote(const AcceptLine& line) {
    return "line " + std::to_string(line.line) + ": no manoeuvre has a metric " + quote(line.metric) +
           "; a scenario or a file given with --metrics must define it";
}

// A line whose unit fits the metric of one manoeuvre is fine, however many manoeuvres have a metric of that name.
std::vector<AcceptFault> faultsInAnyManoeuvre(const Acceptance& acceptance) {
    std::vector<AcceptFault> faults;
    for (const AcceptLine& line : acceptance.lines) {
        if (line.metric.starts_with("highest_")) continue;  // what a scenario searches is known with the scenario
        std::vector<AcceptFault> first;
        bool fits = false;
        for (const MetricDefinition& known : allMetrics()) {
            if (known.name != line.metric) continue;
            auto found = acceptFaults({{line}}, "any", {known});
            fits = fits || found.empty();
            if (first.empty()) first = std::move(found);
        }
        if (first.empty() && !fits) first = acceptFaults({{line}}, "any manoeuvre", allMetrics());
        if (!fits) faults.insert(faults.end(), first.begin(), first.end());
    }
    return faults;
}

}  // namespace

std::string ownerOf(const Scenario& scenario) {
    if (!scenario.series.highest) return scenario.manoeuvre;
    return "a search, which has " + quote(highestMetric(scenario).name) + " alone";
}

std::vector<MetricDefinition> acceptable(const Scenario& scenario) {
    if (scenario.series.highest) return {highestMetric(scenario)};
    return metricsOf(scenario);
}

Acceptance acceptanceOf(const RunOptions& options, const Scenario& scenario) {
    if (options.accept.empty()) return {};
    const AcceptFile file = readYaml<AcceptFile>(options.accept);
    const std::vector<MetricDefinition> known = acceptable(scenario);
    Acceptance asked = file.accept;
    if (!options.all.empty()) std::erase_if(asked.lines, [&](const auto& line) { return !has(known, line.metric); });
    for (const ScenarioAcceptance& own : file.accept_of) {
        if (own.scenario == Path(options.scenario).stem()) asked = merged(std::move(asked), own.accept);
    }
    std::vector<Problem> problems;
    for (const AcceptFault& fault : acceptFaults(asked, ownerOf(scenario), known))
        problems.push_back(problemAt(options.accept, fault));
    throwIfAny(std::move(problems));
    return asked;
}

void expectAllUsed(const std::string& name, const std::vector<NamedScenario>& scenarios) {
    if (name.empty()) return;
    const AcceptFile file = readYaml<AcceptFile>(name);
    std::vector<Problem> problems;
    std::vector<MetricDefinition> known;
    bool all_read = true;
    for (const NamedScenario& one : scenarios) {
        if (!one.scenario) all_read = false;
        if (!one.scenario) continue;
        for (MetricDefinition& about : acceptable(*one.scenario)) known.push_back(std::move(about));
    }
    for (const AcceptLine& line : file.accept.lines) {
        if (!all_read || has(known, line.metric)) continue;
        for (const AcceptFault& fault : acceptFaults({{line}}, "any of these scenarios", known))
            problems.push_back(problemAt(name, fault));
    }
    std::vector<std::string_view> names;
    for (const NamedScenario& one : scenarios) names.push_back(one.name);
    for (std::size_t i = 0; i < file.accept_of.size(); ++i) {
        const std::string& wanted = file.accept_of[i].scenario;
        if (std::find(names.begin(), names.end(), wanted) != names.end()) continue;
        const std::string path = "accept_of." + std::to_string(i) + ".scenario";
        const TextPosition at = positionOfValue(name, path);
        problems.push_back({name, at.line, at.column, path,
                            "found " + quote(wanted) + ", expected the name of a scenario that is driven" +
                                didYouMean(wanted, names)});
    }
    throwIfAny(std::move(problems));
}

std::vector<std::string> checkAcceptFile(const std::string& name) {
    const AcceptFile file = readYaml<AcceptFile>(name);
    std::vector<Problem> problems;
    std::vector<std::string> notes;
    const auto check = [&](Acceptance acceptance) {
        for (const AcceptLine& line : acceptance.lines) {
            if (mayBeOwn(line.metric)) notes.push_back(ownMetricNote(line));
        }
        std::erase_if(acceptance.lines, [](const AcceptLine& line) { return mayBeOwn(line.metric); });
        for (const AcceptFault& fault : faultsInAnyManoeuvre(acceptance)) problems.push_back(problemAt(name, fault));
    };
    check(file.accept);
    for (const ScenarioAcceptance& own : file.accept_of) check(own.accept);
    throwIfAny(std::move(problems));
    return notes;
}

Tone toneOf(const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return Tone::plain;
    return allMet(verdicts) ? Tone::good : Tone::bad;
}

std::vector<JUnitCase> junitCases(const std::string& name, const std::vector<Verdict>& verdicts) {
    std::vector<JUnitCase> cases{{name, "run"}};
    for (const Verdict& verdict : verdicts) {
        const std::string run = verdict.run.empty() ? "" : verdict.run + ": ";
        cases.push_back({name, run + verdict.metric + " " + verdict.condition, verdict.met ? "" : text(verdict)});
    }
    return cases;
}

}  // namespace tread::program
