#include "campaign/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "campaign/log_file.h"
#include "run/together.h"

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
    double seconds = 0;
};

// Runs of a cell; the first one is repeated until as many are driven at once as in the campaign, so that they take as
// long as there.
std::vector<Driven> drivenBy(const Plan& plan, std::vector<PlannedRun> planned, std::uint64_t of_cell,
                             const Measure& measure) {
    const std::size_t wanted = planned.size(), at_once = runsAtOnce(of_cell, 1);
    planned.resize(std::max(wanted, at_once), planned.front());
    std::vector<Driven> driven(planned.size());
    drivenTogether(planned.size(), 1, [&](std::size_t i) {
        const double begin = ownSeconds();
        driven[i].outcome = outcomeOf(plan, planned[i], measure, &driven[i].log);
        driven[i].seconds = ownSeconds() - begin;
    });
    driven.resize(wanted);
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
        // The reference, and one more for each factor that is not known to matter.
        std::vector<PlannedRun> planned{middle};
        std::vector<std::size_t> factors;
        for (std::size_t i = 0; i < plan.variables.size(); ++i) {
            if (matters[i] || middle.values[i] != middle.values[i]) continue;
            PlannedRun other = middle;
            other.values[i] = valueAt(plan, cell, i, kElsewhere);
            if (other.values[i] == middle.values[i]) continue;
            asked[i] = true;
            tried[i] = {middle.values[i], other.values[i]};
            planned.push_back(std::move(other));
            factors.push_back(i);
        }
        const std::vector<Driven> driven = drivenBy(plan, planned, cell.runs, measure);
        const Driven& reference = driven.front();
        seconds += reference.seconds * static_cast<double>(cell.runs);
        runs += static_cast<double>(cell.runs);
        if (plan.inputs.campaign.logs)
            found.bytes_of_log = std::max<std::uint64_t>(found.bytes_of_log, binaryLog(reference.log).size());
        for (std::size_t k = 0; k < factors.size(); ++k) {
            const Driven& changed = driven[k + 1];
            matters[factors[k]] = !isSame(reference.outcome, changed.outcome) ||
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
