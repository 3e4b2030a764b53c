// Reading a scenario file.
#pragma once

#include <filesystem>

#include "scenario/scenario.h"

namespace tread {

Scenario loadScenario(const std::filesystem::path& file);  // throws LoadError

// Longest time that the scenario can take, s: the sum of its phases as far as they name a duration.
double longestDuration(const Scenario& scenario);

}  // namespace tread
