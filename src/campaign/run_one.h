// One run of a campaign.
#pragma once

#include <functional>
#include <vector>

#include "campaign/row.h"
#include "log/log.h"

namespace tread::campaign {

// Drives a car through a scenario and computes the metrics of its manoeuvre; fills the log when there is one. Throws
// SimulationError, MetricError, Interrupted.
using Measure = std::function<std::vector<Metric>(const VehicleParams&, const Scenario&, Log* log)>;

// A run that fails has an outcome too. Throws Interrupted.
Outcome outcomeOf(const Subject& subject, const Measure& measure, Log* log = nullptr);
Outcome outcomeOf(const Plan& plan, const PlannedRun& run, const Measure& measure, Log* log = nullptr);

}  // namespace tread::campaign
