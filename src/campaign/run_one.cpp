#include "campaign/run_one.h"

#include <fmt/format.h>

#include <optional>

#include "metrics/metrics.h"
#include "run/simulate.h"
#include "series/series.h"
#include "tread/problem.h"

namespace tread::campaign {
namespace {

// The metrics of a run; of a search, those of its highest value, in whose run the log is recorded.
std::vector<Metric> metricsOf(const VehicleParams& vehicle, const Scenario& scenario, const Measure& measure,
                              Log* log) {
    const std::optional<Highest>& search = scenario.series.highest;
    if (!search) return measure(vehicle, scenario, log);
    const tread::Measure one = [&](const Scenario& changed) { return measure(vehicle, changed, nullptr); };
    const SeriesResult found = series(scenario, one, one);
    std::vector<Metric> highest = highestOf(scenario, found);
    if (highest.empty())
        throw MetricError(fmt::format("no run passes, not even with {} = {}", search->number, search->lowest));
    if (log) measure(vehicle, withHighest(scenario, found), log);
    return highest;
}

}  // namespace

Outcome outcomeOf(const Subject& subject, const Measure& measure, Log* log) {
    const auto failed = [&](Status status, const std::exception& error) {
        Outcome outcome{status, error.what(), {}, {}};
        outcome.verdicts = judge(subject.scenario.accept, {});
        return outcome;
    };
    try {
        Scenario scenario = subject.scenario;
        scenario =
            tuned(std::move(scenario), [&](const Scenario& one) { return measure(subject.vehicle, one, nullptr); });
        Outcome outcome;
        try {
            outcome.metrics = metricsOf(subject.vehicle, scenario, measure, log);
        } catch (const MetricError&) {
            if (!scenario.manoeuvre.empty()) throw;  // without a manoeuvre the run is driven for its log
        }
        outcome.verdicts = judge(scenario.accept, outcome.metrics);
        if (!allMet(outcome.verdicts)) outcome.status = Status::rejected;
        return outcome;
    } catch (const Interrupted&) {
        throw;
    } catch (const MetricError& error) {
        return failed(Status::no_metrics, error);
    } catch (const SimulationError& error) {
        return failed(Status::failed, error);
    } catch (const SeriesError& error) {
        return failed(Status::failed, error);
    }
}

Outcome outcomeOf(const Plan& plan, const PlannedRun& run, const Measure& measure, Log* log) {
    try {
        return outcomeOf(subjectOf(plan, run), measure, log);
    } catch (const LoadError& error) {
        Outcome outcome{Status::invalid, {}, {}, {}};
        for (const Problem& problem : error.problems()) {
            outcome.message += (outcome.message.empty() ? "" : "; ") + problem.path +
                               (problem.path.empty() ? "" : ": ") + problem.text;
        }
        return outcome;
    }
}

}  // namespace tread::campaign
