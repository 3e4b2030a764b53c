// A few runs before a campaign: how long it will take, how much disk it needs, and which factors change nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/run_one.h"

namespace tread::campaign {

struct Probe {
    double seconds_per_run = 0;  // on one core
    std::uint64_t bytes_of_log = 0;
    std::vector<std::string> without_effect = {};  // a sentence each
};

// A run in the middle of the factors, then one for each factor with another value of it; in the first few cells, until
// every factor has changed something. Throws Interrupted.
Probe probe(const Plan& plan, const Measure& measure);

}  // namespace tread::campaign
