#include "golden/golden_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "log/csv.h"
#include "run/simulate.h"
#include "scenario/load.h"
#include "tread/load.h"

namespace tread::golden {
namespace {

const std::filesystem::path kSource = TREAD_SOURCE_DIR;

// What the driver does, how the body moves, and one number from the depth of every sub-model: what a change breaks
// shows in at least one of them.
const std::vector<std::string> kChannels = {"driver.steering_wheel_angle",
                                            "driver.throttle",
                                            "chassis.x",
                                            "chassis.y",
                                            "chassis.z",
                                            "chassis.roll",
                                            "chassis.pitch",
                                            "chassis.vx",
                                            "chassis.yaw_rate",
                                            "chassis.ay",
                                            "wheel.front_left.load",
                                            "wheel.front_left.fx",
                                            "wheel.front_right.fy",
                                            "wheel.rear_left.spin",
                                            "wheel.rear_right.patch_v",
                                            "driveline.engine_speed"};

// Rows per second: about a hundred rows show the course of a manoeuvre.
double rateOf(const std::string& name) {
    static const std::map<std::string, double> own = {
        {"coast_down", 1}, {"drop_and_settle", 40}, {"parked_on_slope", 20}, {"steady_circle", 4}};
    const auto found = own.find(name);
    return found == own.end() ? 20 : found->second;
}

constexpr double kParkedTime = 5;  // s: what creeps in a minute does so from the first second

// Numbers are kept to seven digits: more than the tolerances need, and what changed can be read.
double rounded(double value) {
    constexpr int kDigits = 7;
    constexpr double kNothing = 1e-12;  // of any unit: the noise of a car at rest
    if (!(std::abs(value) > kNothing)) return std::isfinite(value) ? 0 : value;
    const double unit = std::pow(10, kDigits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * unit) / unit;
}

}  // namespace

std::vector<std::string> names() {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(kSource / "scenarios")) {
        if (entry.path().extension() == ".yaml") found.push_back(entry.path().stem().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::filesystem::path fileOf(const std::string& name) {
    return kSource / "tests" / "golden" / (name + ".csv");
}

Log run(const std::string& name) {
    const VehicleParams car = loadVehicle(kSource / "vehicles" / "compact.yaml");
    Scenario scenario = loadScenario(kSource / "scenarios" / (name + ".yaml"));
    if (name == "parked_on_slope") scenario.phases.back().until.duration = kParkedTime;
    scenario.log = {rateOf(name), kChannels};
    Log log = simulate(car, scenario);
    for (Channel& channel : log.channels) {
        for (double& value : channel.values) value = rounded(value);
    }
    return log;
}

Comparison compareToGolden(const std::string& name, const Log& log) {
    // A difference in the last digit of one sine is 1e-16 of its value. The manoeuvres damp it, except where a wheel
    // locks or a phase ends one step earlier; measured between g++ and clang, with and without the processor's fused
    // multiply-add in the C library: see kMeasured.
    constexpr double kRelative = 1e-4;
    Tolerances tolerances;
    tolerances.relative = kRelative;
    return compare(readLog(fileOf(name)), log, tolerances);
}

}  // namespace tread::golden
