#include "golden/golden_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "log/csv.h"
#include "places/places.h"
#include "run/simulate.h"
#include "scenario/load.h"
#include "tread/load.h"

namespace tread::golden {
namespace {

const std::filesystem::path kSource = sourceFile();

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

// Names of the files without folder and extension, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder, std::string_view extension) {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == extension) found.push_back(entry.path().stem().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

std::vector<std::string> scenarios() {
    return namesIn(kSource / "scenarios", ".yaml");
}

std::vector<std::string> names() {
    return namesIn(kSource / "tests" / "golden", ".csv");
}

std::filesystem::path fileOf(const std::string& name) {
    return kSource / "tests" / "golden" / (name + ".csv");
}

VehicleParams car() {
    return loadVehicle(kSource / "vehicles" / "compact.yaml");
}

Log run(const std::string& name, const VehicleParams& car) {
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
    // What the rounding of a formula that is written in another way may change: locked wheels blow up the sixteenth
    // digit to 2e-7 of a force's peak and 1e-8 rad/s of a yaw rate that should be none. Another compiler or processor
    // changes nothing (tests/bits).
    constexpr double kRelative = 1e-5;
    constexpr double kAbsolute = 1e-6;       // of any unit
    constexpr double kAbsoluteForce = 1e-2;  // N and N m
    Tolerances tolerances;
    tolerances.relative = kRelative;
    for (UnitTolerance& unit : tolerances.units) {
        unit.absolute = unit.unit == "N" || unit.unit == "N m" ? kAbsoluteForce : kAbsolute;
    }
    return compare(readLog(fileOf(name)), log, tolerances);
}

}  // namespace tread::golden
