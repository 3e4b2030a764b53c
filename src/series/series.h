// Runs a scenario several times, as its `series` asks. Knows neither the car nor how a run is made.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "metrics/metric.h"
#include "scenario/scenario.h"

namespace tread {

// The series cannot go on: one sentence.
class SeriesError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// A run of a scenario, and the metrics of its manoeuvre. Throws MetricError or SimulationError when it has none.
using Measure = std::function<std::vector<Metric>(const Scenario&)>;

// One run of a series.
struct SeriesRun {
    double value;                 // of the number, SI
    std::vector<Metric> metrics;  // none when the run failed
    std::string failure;          // why; empty when it did not
    bool passed;                  // true without a verdict
};

struct SeriesResult {
    std::string number;  // path; empty when there is no series
    std::string unit;    // SI
    std::vector<SeriesRun> runs;
    double highest;  // that passed, SI; NaN: none, or not asked for
};

// The scenario with the numbers that `scale` and `tune` ask for. Throws SeriesError when a target cannot be reached.
Scenario tuned(Scenario scenario, const Measure& measure);

// The runs of `vary` or `highest`, made by `run`, in their order; `measure` makes those that only scale the values.
SeriesResult series(const Scenario& scenario, const Measure& measure, const Measure& run);

// A search has this one metric: the highest value that passes. `scenario` has `series.highest`.
MetricDefinition highestMetric(const Scenario& scenario);

// The metrics of a search: its highest value, in SI units; none when no run passes.
std::vector<Metric> highestOf(const Scenario& scenario, const SeriesResult& found);

// The scenario of the run with the highest value that passes.
Scenario withHighest(const Scenario& scenario, const SeriesResult& found);

// What is wrong with the numbers and limits that the series names; empty: nothing.
std::string faultOf(const Scenario& scenario);

}  // namespace tread
