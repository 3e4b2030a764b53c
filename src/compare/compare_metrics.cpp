#include "compare/compare_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tread {
namespace {

std::string inWords(const std::optional<double>& value, const std::string& unit) {
    if (!value) return "undefined";
    return fmt::format("{:.6g}{}{}", *value, unit.empty() ? "" : " ", unit);
}

nlohmann::json jsonOf(const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

}  // namespace

std::vector<MetricComparison> compareMetrics(const std::vector<MetricValue>& reference,
                                             const std::vector<MetricValue>& candidate, const Tolerances& tolerances) {
    std::vector<MetricComparison> all;
    for (const MetricValue& here : reference) {
        const AllowedDifference allowed = allowedDifference(tolerances, here.name, here.unit);
        if (allowed.ignore) continue;
        MetricComparison one{here.name, here.unit, here.value, {}, 0, false};
        const auto there = std::find_if(candidate.begin(), candidate.end(), [&](const MetricValue& other) {
            return other.name == here.name && other.unit == here.unit;
        });
        if (there != candidate.end()) one.candidate = there->value;
        if (here.value) one.allowed = allowed.absolute + allowed.relative * std::abs(*here.value);
        if (here.value && one.candidate) {
            one.same = std::abs(*one.candidate - *here.value) <= one.allowed;
        } else {
            one.same = there != candidate.end() && !here.value && !one.candidate;
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::string text(const MetricComparison& comparison) {
    const std::string unit = comparison.unit == "-" ? "" : comparison.unit;
    const std::string words = fmt::format("{} {} instead of {}", comparison.metric, inWords(comparison.candidate, unit),
                                          inWords(comparison.reference, unit));
    if (!comparison.reference || !comparison.candidate) return words;
    return fmt::format("{}, {:.4g}{}{} allowed", words, comparison.allowed, unit.empty() ? "" : " ", unit);
}

nlohmann::json json(const std::vector<MetricComparison>& comparisons) {
    nlohmann::json list = nlohmann::json::array();
    for (const MetricComparison& one : comparisons) {
        list.push_back({{"metric", one.metric},
                        {"unit", one.unit},
                        {"reference", jsonOf(one.reference)},
                        {"candidate", jsonOf(one.candidate)},
                        {"allowed", one.allowed},
                        {"same", one.same}});
    }
    return list;
}

}  // namespace tread
