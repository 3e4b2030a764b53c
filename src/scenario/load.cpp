#include "scenario/load.h"

#include <algorithm>
#include <utility>

#include "base/yaml/read.h"
#include "scenario/course_file.h"
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
    const auto place = [&](std::string& name) {
        if (!name.empty()) name = (file.parent_path() / name).lexically_normal().string();
    };
    if (auto& vary = scenario.series.vary) place(vary->of_scenario);
    for (Scale& scale : scenario.series.scale) place(scale.of_scenario);
    return withCourseRead(std::move(scenario), file);
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
