// Metrics of the user's own: of a scenario, and of the file that --metrics names.
#pragma once

#include <string>
#include <vector>

#include "metrics/own/own_metrics.h"
#include "tread/problem.h"

namespace tread::program {

// The metrics that a run of the scenario has: those of its manoeuvre, and its own.
std::vector<MetricDefinition> metricsOf(const Scenario& scenario);

// Faults of the scenario's own metrics, which stand in `file` as "metrics.0", ...; `channels`: what its log has.
std::vector<Problem> faultsOfOwnMetrics(const Scenario& scenario, const std::vector<KnownName>& channels,
                                        const std::string& file);

// The scenario with the metrics of a file beside its own, or in place of those of the same name. Throws LoadError.
Scenario withMetricsOf(const std::string& file, Scenario scenario, const std::vector<KnownName>& channels);

// The channels that a log of the scenario has; those of a log.
std::vector<KnownName> loggedChannels(const Scenario& scenario);
std::vector<KnownName> loggedChannels(const Log& log);

// A file of metrics for any scenario. Throws LoadError.
void checkOwnMetricsFile(const std::string& file);

}  // namespace tread::program
