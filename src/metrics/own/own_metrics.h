// The values of metrics that users define, from a log.
#pragma once

#include <string>
#include <vector>

#include "log/log.h"
#include "metrics/metric.h"
#include "scenario/expression/check.h"
#include "scenario/scenario.h"
#include "tread/vehicle.h"

namespace tread {

// A number of car or scenario, by its path: "vehicle.mass".
struct RunParameter {
    std::string name;
    std::string unit;
    double value;  // SI; NaN: not known
};

std::vector<RunParameter> parametersOf(const VehicleParams& vehicle, const Scenario& scenario);
// Those of some car: names and units, without values.
std::vector<RunParameter> parametersOf(const Scenario& scenario);

// What an expression may name.
KnownNames knownNames(const std::vector<KnownName>& channels, const std::vector<RunParameter>& parameters,
                      const Scenario& scenario);

struct OwnMetricFault {
    std::size_t metric;
    std::string field;  // "value", "name"
    std::size_t at;     // byte of the expression
    std::string text;
};
// Names that are unknown, units that do not fit, names that are given twice or belong to `taken`.
std::vector<OwnMetricFault> ownMetricFaults(const std::vector<OwnMetric>& metrics, const KnownNames& known,
                                            const std::vector<MetricDefinition>& taken);

std::vector<MetricDefinition> definitions(const std::vector<OwnMetric>& metrics);

// Undefined, that is NaN: metrics whose moments never come, or that need what log and parameters lack.
std::vector<Metric> ownMetrics(const std::vector<OwnMetric>& metrics, const Log& log,
                               const std::vector<RunParameter>& parameters, const Scenario& scenario);

}  // namespace tread
