#include "scenario/load.h"

#include <algorithm>

#include "base/read_yaml.h"

namespace tread {

Scenario loadScenario(const std::filesystem::path& file) {
    return readYaml<Scenario>(file);
}

double longestDuration(const Scenario& scenario) {
    double sum = 0;
    for (const Phase& phase : scenario.phases) sum += phase.until.duration.value_or(scenario.time_limit);
    return std::min(sum, scenario.time_limit);
}

}  // namespace tread
