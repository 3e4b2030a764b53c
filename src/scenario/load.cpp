#include "scenario/load.h"

#include <algorithm>

#include "base/read_yaml.h"
#include "scenario/replay.h"

namespace tread {

Scenario loadScenario(const std::filesystem::path& file) {
    std::vector<Problem> problems;
    Scenario scenario = loadScenario(file, problems);
    throwIfAny(std::move(problems));
    return scenario;
}

Scenario loadScenario(const std::filesystem::path& file, std::vector<Problem>& problems) {
    Scenario scenario = readYaml<Scenario>(file, problems);
    placeReplays(scenario, file.parent_path());
    if (auto& vary = scenario.series.vary; vary && !vary->of_scenario.empty())
        vary->of_scenario = (file.parent_path() / vary->of_scenario).lexically_normal().string();
    return scenario;
}

double longestDuration(const Scenario& scenario) {
    double end = 0;
    for (const Phase& phase : scenario.phases) {
        const double by_duration = end + phase.until.duration.value_or(scenario.time_limit);
        end = std::max(end, std::min(by_duration, phase.until.time.value_or(kInfinity)));
    }
    return std::min(end, scenario.time_limit);
}

}  // namespace tread
