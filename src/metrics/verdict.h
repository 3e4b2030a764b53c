// Is a run accepted? Its metrics against the conditions of a scenario or of a file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/metric.h"
#include "scenario/accept.h"

namespace tread {

struct Verdict {
    std::string run;  // of a series; empty: the only one
    std::string metric;
    double value;  // NaN: could not be computed, which is a miss
    std::string unit;
    std::string condition;
    bool met;
    std::string title = {};  // of the metric, for people
    // How far the value is inside what the condition allows, in the unit of the metric; negative: outside. None for a
    // metric that could not be computed, and for "= 0", which has no inside.
    std::optional<double> margin = {};
};

// A number of a verdict in the unit in which its condition is written: "48.9 m", "12 %".
std::string valueInWords(const Verdict& verdict, int digits = 5);
// "3.8 m to spare", "8.9 m beyond"; empty without a margin.
std::string marginInWords(const Verdict& verdict);

// Conditions on metrics that are not among `known`, or with a unit that does not fit. Each with its line.
struct AcceptFault {
    AcceptLine line;
    std::string text;
};
std::vector<AcceptFault> acceptFaults(const Acceptance& acceptance, std::string_view manoeuvre,
                                      const std::vector<MetricDefinition>& known);

// One verdict for each condition, in their order. A metric that `metrics` lacks could not be computed.
std::vector<Verdict> judge(const Acceptance& acceptance, const std::vector<Metric>& metrics,
                           const std::string& run = {});

bool allMet(const std::vector<Verdict>& verdicts);

// "stopping_distance: 48.9 m, required < 40 m: missed, 8.9 m beyond".
std::string text(const Verdict& verdict);
// "accepted: 3 conditions met", "not accepted: 1 of 3 conditions missed"; empty without conditions.
std::string answer(const std::vector<Verdict>& verdicts);
nlohmann::json json(const std::vector<Verdict>& verdicts);

}  // namespace tread
