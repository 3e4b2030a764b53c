// How pages show metrics.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/metric.h"
#include "report/text.h"

namespace tread {

// A share that is said in percent is shown so too.
inline DisplayUnit displayUnit(const Metric& metric) {
    if (metric.unit == "-" && metric.say.scale == 100) return {"%", 100};
    return displayUnit(metric.unit);
}

// "12.4"; 0 for what is nothing but rounding at the digits in which the metric is said.
inline std::string shownValue(const Metric& metric, int significant_digits) {
    constexpr double kNothing = 1e-3;  // of the last digit that is said
    const double last = std::pow(10, -metric.say.decimals);
    const bool nothing = metric.say.rank > 0 && std::abs(metric.say.scale * metric.value) < kNothing * last;
    return nothing ? "0" : formatNumber(metric.value * displayUnit(metric).scale, significant_digits);
}

// A metric that could be computed.
inline std::optional<double> metricNamed(const std::vector<Metric>& metrics, std::string_view name) {
    for (const Metric& metric : metrics) {
        if (metric.name == name && std::isfinite(metric.value)) return metric.value;
    }
    return std::nullopt;
}

}  // namespace tread
