// Reading a scenario file.
#pragma once

#include <filesystem>

#include "scenario/scenario.h"
#include "tread/problem.h"

namespace tread {

Scenario loadScenario(const std::filesystem::path& file);  // throws LoadError

// The scenario as far as its file is sound; the faults are added to `problems`.
Scenario loadScenario(const std::filesystem::path& file, std::vector<Problem>& problems);

// Longest time that the scenario can take, s: the sum of its phases as far as they name a duration.
double longestDuration(const Scenario& scenario);

}  // namespace tread
