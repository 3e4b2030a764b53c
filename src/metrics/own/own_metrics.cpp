#include "metrics/own/own_metrics.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/fields/numbers.h"
#include "base/fields/reference_table.h"
#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "metrics/channels.h"
#include "metrics/own/evaluate.h"
#include "scenario/expression/parse.h"
#include "vehicle/fields.h"

namespace tread {
namespace {

template <class Described>
void add(std::vector<RunParameter>& parameters, Described object, const std::string& prefix) {
    for (const Number& number : numbers(object, prefix))
        parameters.push_back({number.path, std::string(number.about.unit), *number.value});
}

std::vector<std::string> phasesOf(const Scenario& scenario) {
    std::vector<std::string> names;
    for (const Phase& phase : scenario.phases) names.push_back(phase.name);
    return names;
}

double inUnit(double si, const std::string& unit) {
    std::string why;
    const auto known = parseUnit(unit, why);
    return known ? (si - known->offset) * known->denominator / known->numerator : si;
}

}  // namespace

std::vector<RunParameter> parametersOf(const VehicleParams& vehicle, const Scenario& scenario) {
    std::vector<RunParameter> parameters;
    add(parameters, vehicle, "vehicle");
    add(parameters, scenario, "scenario");
    return parameters;
}

std::vector<RunParameter> parametersOf(const Scenario& scenario) {
    std::vector<RunParameter> parameters;
    for (const ReferenceRow& row : referenceTable<VehicleParams>()) {
        if (!row.unit.empty()) parameters.push_back({"vehicle." + row.path, row.unit, kUndefined});
    }
    add(parameters, scenario, "scenario");
    return parameters;
}

KnownNames knownNames(const std::vector<KnownName>& channels, const std::vector<RunParameter>& parameters,
                      const Scenario& scenario) {
    KnownNames known{.channels = channels, .phases = phasesOf(scenario), .any_phase = scenario.phases.empty()};
    for (const RunParameter& parameter : parameters) known.parameters.push_back({parameter.name, parameter.unit});
    return known;
}

std::vector<OwnMetricFault> ownMetricFaults(const std::vector<OwnMetric>& metrics, const KnownNames& known,
                                            const std::vector<MetricDefinition>& taken) {
    std::vector<OwnMetricFault> faults;
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const OwnMetric& metric = metrics[i];
        const auto same = [&](const auto& other) { return other.name == metric.name; };
        const auto before = metrics.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::any_of(metrics.begin(), before, same))
            faults.push_back(
                {i, "name", 0, concat({"found a second metric ", quote(metric.name), ", expected a name for each"})});
        if (std::any_of(taken.begin(), taken.end(), same)) {
            faults.push_back(
                {i, "name", 0,
                 concat({"found ", quote(metric.name), ", which the manoeuvre has already; choose another name"})});
        }
        ExpressionFault fault;
        std::optional<Term> term = parseExpression(metric.value.text, fault);
        if (term && checkMetric(*term, metric.unit, known, fault)) continue;
        faults.push_back({i, "value", fault.at, fault.text});
    }
    return faults;
}

std::vector<MetricDefinition> definitions(const std::vector<OwnMetric>& metrics) {
    std::vector<MetricDefinition> out;
    for (const OwnMetric& metric : metrics) {
        out.push_back(
            {metric.name, {}, metric.unit, metric.definition.empty() ? metric.value.text : metric.definition});
    }
    return out;
}

std::vector<Metric> ownMetrics(const std::vector<OwnMetric>& metrics, const Log& log,
                               const std::vector<RunParameter>& parameters, const Scenario& scenario) {
    const KnownNames known = [&] {
        std::vector<KnownName> channels;
        for (const Channel& channel : log.channels) channels.push_back({channel.name, channel.unit});
        return knownNames(channels, parameters, scenario);
    }();
    const std::vector<MetricDefinition> about = definitions(metrics);
    std::vector<Metric> out;
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        ExpressionFault fault;
        std::optional<Term> term = parseExpression(metrics[i].value.text, fault);
        const bool fits = term && checkMetric(*term, metrics[i].unit, known, fault);
        const double si = fits ? evaluate(*term, log, parameters, known.phases) : kUndefined;
        out.push_back({about[i].name, inUnit(si, about[i].unit), about[i].unit, about[i].definition, {}});
    }
    return out;
}

}  // namespace tread
