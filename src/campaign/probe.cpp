#include "campaign/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>

#include "campaign/log_file.h"

namespace tread::campaign {
namespace {

constexpr std::size_t kMostCells = 6;
constexpr double kMiddle = 0.5, kElsewhere = 0.9;  // of a distribution

double valueAt(const Plan& plan, const Cell& cell, std::size_t index, double share) {
    const Variable& variable = plan.variables[index];
    if (variable.drawn) return valueOfShare(plan, cell, variable, share);
    return share == kMiddle ? variable.numbers.front() : variable.numbers.back();
}

// Runs without metrics are compared by their logs.
struct Driven {
    Outcome outcome;
    Log log;
};
Driven drivenBy(const Plan& plan, const PlannedRun& run, const Measure& measure) {
    Driven driven;
    driven.outcome = outcomeOf(plan, run, measure, &driven.log);
    return driven;
}

bool isSame(const Log& a, const Log& b) {
    return std::equal(a.channels.begin(), a.channels.end(), b.channels.begin(), b.channels.end(),
                      [](const Channel& one, const Channel& other) { return one.values == other.values; });
}

bool isSame(const Outcome& a, const Outcome& b) {
    const auto same = [](const Metric& one, const Metric& other) {
        return std::bit_cast<std::uint64_t>(one.value) == std::bit_cast<std::uint64_t>(other.value);
    };
    return a.status == b.status && a.message == b.message &&
           std::equal(a.metrics.begin(), a.metrics.end(), b.metrics.begin(), b.metrics.end(), same);
}

}  // namespace

Probe probe(const Plan& plan, const Measure& measure) {
    Probe found;
    std::vector<bool> matters(plan.variables.size()), asked(plan.variables.size());
    std::vector<std::pair<double, double>> tried(plan.variables.size());
    double seconds = 0, runs = 0;
    for (std::size_t c = 0; c < std::min(kMostCells, plan.cells.size()); ++c) {
        const Cell& cell = plan.cells[c];
        PlannedRun middle = plannedRun(plan, cell.first);
        for (std::size_t i = 0; i < plan.variables.size(); ++i) {
            if (middle.values[i] == middle.values[i]) middle.values[i] = valueAt(plan, cell, i, kMiddle);
        }
        const auto begin = std::chrono::steady_clock::now();
        const Driven reference = drivenBy(plan, middle, measure);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        seconds += took.count() * static_cast<double>(cell.runs);
        runs += static_cast<double>(cell.runs);
        if (plan.inputs.campaign.logs)
            found.bytes_of_log = std::max<std::uint64_t>(found.bytes_of_log, binaryLog(reference.log).size());
        for (std::size_t i = 0; i < plan.variables.size(); ++i) {
            if (matters[i] || middle.values[i] != middle.values[i]) continue;
            PlannedRun other = middle;
            other.values[i] = valueAt(plan, cell, i, kElsewhere);
            if (other.values[i] == middle.values[i]) continue;
            asked[i] = true;
            tried[i] = {middle.values[i], other.values[i]};
            const Driven changed = drivenBy(plan, other, measure);
            matters[i] = !isSame(reference.outcome, changed.outcome) ||
                         (reference.outcome.metrics.empty() && !isSame(reference.log, changed.log));
        }
    }
    found.seconds_per_run = runs > 0 ? seconds / runs : 0;
    for (std::size_t i = 0; i < plan.variables.size(); ++i) {
        const Variable& variable = plan.variables[i];
        if (!asked[i] || matters[i]) continue;
        found.without_effect.push_back(
            fmt::format("the factor {} changes nothing: all {} are the same with {} and with {}, the other factors "
                        "in their middle",
                        variable.path, plan.metrics.empty() ? "logged values" : "metrics",
                        valueText(variable, tried[i].first), valueText(variable, tried[i].second)));
    }
    return found;
}

}  // namespace tread::campaign
