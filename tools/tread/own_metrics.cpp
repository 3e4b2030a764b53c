#include "own_metrics.h"

#include <algorithm>

#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "log/log_columns.h"
#include "metrics/metrics.h"
#include "run/simulate.h"

namespace tread::program {
namespace {

std::vector<MetricDefinition> ofManoeuvre(const std::string& name) {
    for (const Manoeuvre& manoeuvre : manoeuvres()) {
        if (manoeuvre.name == name) return manoeuvre.definitions();
    }
    return {};
}

}  // namespace

std::vector<MetricDefinition> metricsOf(const Scenario& scenario) {
    std::vector<MetricDefinition> all = ofManoeuvre(scenario.manoeuvre);
    for (MetricDefinition& own : definitions(scenario.metrics)) all.push_back(std::move(own));
    return all;
}

std::vector<Problem> faultsOfOwnMetrics(const Scenario& scenario, const std::vector<KnownName>& channels,
                                        const std::string& file) {
    std::vector<Problem> problems;
    const KnownNames known = knownNames(channels, parametersOf(scenario), scenario);
    for (const OwnMetricFault& fault : ownMetricFaults(scenario.metrics, known, ofManoeuvre(scenario.manoeuvre))) {
        const std::string path = "metrics." + std::to_string(fault.metric) + "." + fault.field;
        const TextPosition at = fault.field == "value"
                                    ? positionWithin(file, scenario.metrics[fault.metric].value, fault.at)
                                    : positionOfValue(file, path);
        problems.push_back({file, at.line, at.column, path, fault.text});
    }
    return problems;
}

Scenario withMetricsOf(const std::string& file, Scenario scenario, const std::vector<KnownName>& channels) {
    if (file.empty()) return scenario;
    Scenario more = scenario;
    more.metrics = readYaml<OwnMetricsFile>(file).metrics;
    throwIfAny(faultsOfOwnMetrics(more, channels, file));
    for (OwnMetric& metric : more.metrics) {
        std::erase_if(scenario.metrics, [&](const OwnMetric& own) { return own.name == metric.name; });
        scenario.metrics.push_back(std::move(metric));
    }
    return scenario;
}

std::vector<KnownName> loggedChannels(const Scenario& scenario) {
    std::vector<KnownName> channels;
    for (const Column& column : columnsOf(scenario)) channels.push_back({column.name, column.unit});
    return channels;
}

std::vector<KnownName> loggedChannels(const Log& log) {
    std::vector<KnownName> channels;
    for (const Channel& channel : log.channels) channels.push_back({channel.name, channel.unit});
    return channels;
}

// Of phases, sensors and the course only the scenario knows; a phase may be named by its number here.
void checkOwnMetricsFile(const std::string& file) {
    Scenario any;
    any.metrics = readYaml<OwnMetricsFile>(file).metrics;
    any.course.path.resize(2);
    throwIfAny(faultsOfOwnMetrics(any, loggedChannels(any), file));
}

}  // namespace tread::program
