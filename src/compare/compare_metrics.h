// Are the metrics of two runs the same within tolerance?
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/tolerances.h"

namespace tread {

struct MetricValue {
    std::string name;
    std::optional<double> value;  // none: could not be computed
    std::string unit;
};

struct MetricComparison {
    std::string metric;
    std::string unit;
    std::optional<double> reference;
    std::optional<double> candidate;
    double allowed = 0;
    bool same = false;
};

// Of all metrics of the reference that are not ignored; one that the candidate lacks, or has in another unit, differs.
// A metric that neither could compute is the same.
std::vector<MetricComparison> compareMetrics(const std::vector<MetricValue>& reference,
                                             const std::vector<MetricValue>& candidate, const Tolerances& tolerances);

// "stopping_distance 48.9 m instead of 47 m, 0.235 m allowed".
std::string text(const MetricComparison& comparison);
nlohmann::json json(const std::vector<MetricComparison>& comparisons);

}  // namespace tread
