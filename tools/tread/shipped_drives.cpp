#include "shipped_drives.h"

#include <string>

#include "base/yaml/setting.h"
#include "commands.h"
#include "diagnose/options.h"
#include "scenario/load.h"
#include "shipped_file.h"

namespace tread::program {
namespace {

using diagnose::PossibleDrive;

using tread::diagnose::PossibleDrive;

struct Shipped {
    const char* file;
    std::vector<std::string> settings = {};  // of the scenario
};

// Open-loop scenarios of at most half a minute each, some with another speed or amplitude.
const std::vector<Shipped>& shipped() {
    static const std::vector<Shipped> list{
        {"step_steer_80.yaml"},
        {"step_steer_80.yaml", {"phases.1.steering.ramp.to=80 deg"}},
        {"step_steer_100.yaml"},
        {"steering_pulse.yaml"},
        {"one_period_sine.yaml"},
        {"sine_with_dwell.yaml", {"phases.1.steering.sine_with_dwell.amplitude=75 deg"}},
        {"weave.yaml"},
        {"sine_sweep.yaml",
         {"phases.1.steering.sweep.duration=25", "phases.1.steering.sweep.from=0.2", "phases.1.until.duration=25"}},
        {"slowly_increasing_steer.yaml", {"phases.1.until.duration=12"}},
        {"straight_braking_100_part.yaml", {"phases.1.until.speed_below=20 km/h"}},
        {"coast_down.yaml", {"phases.1.until.duration=20"}},
        {"acceleration_100.yaml"},
    };
    return list;
}

}  // namespace

std::vector<PossibleDrive> shippedDrives() {
    const Path folder = shippedFolder("scenarios");
    std::vector<PossibleDrive> drives;
    if (folder.empty()) return drives;
    for (const Shipped& one : shipped()) {
        PossibleDrive drive{"scenarios/" + std::string(one.file), loadScenario(folder / one.file)};
        applySettings(drive.scenario, one.settings, "shipped scenario",
                      [](std::string_view) { return std::string("`tread describe scenario` lists all paths"); });
        for (const std::string& setting : one.settings) drive.name += " --set \"scenario." + setting + "\"";
        drives.push_back(std::move(drive));
    }
    return drives;
}

}  // namespace tread::program
