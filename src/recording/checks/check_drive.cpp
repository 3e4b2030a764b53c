// Checks of a drive as a whole: standstill, another scale, commands in place of measured inputs, references of another
// car.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/math/median.h"
#include "recording/checks/log_checks.h"
#include "recording/observation.h"

namespace tread::recording::checks {
namespace {

using Values = std::vector<double>;

constexpr double kStanding = 0.5;   // m/s; a recording that stays below shows no motion
constexpr double kTurning = 0.1;    // rad/s; slower turns say nothing about the radius
constexpr double kCrawling = 0.1;   // m/s
constexpr double kTightest = 0.7;   // radius of the tightest turn over the wheelbase; road cars: 1.5 to 2
constexpr double kJump = 60;        // rad/s of the steering wheel; no hand turns it faster than about 25
constexpr double kSteady = 0.2;     // share of a jump by which the signal may change around it
constexpr double kOtherCar = 1.35;  // factor between car and reference on the geometry of steering or wheels
constexpr double kSteered = 0.02;   // rad of the steering wheel, least standard deviation for a conclusion

// Median of the ratio of two channels where `use`; nothing from fewer than Relation::kFewest samples.
template <class Use>
std::optional<double> medianRatio(const Values& above, const Values& below, const Use& use) {
    Values ratios;
    for (std::size_t i = 0; i < above.size(); ++i)
        if (use(i) && std::isfinite(above[i] / below[i])) ratios.push_back(above[i] / below[i]);
    if (ratios.size() < static_cast<std::size_t>(Relation::kFewest)) return std::nullopt;
    return median(std::move(ratios));
}

// False if the lateral acceleration shows that speed or yaw rate has a wrong unit.
bool agreesWithAy(const LogChecks& checks, const Channel& vx, const Channel& r) {
    constexpr double kAlike = 2;  // factor that sideslip, roll and gains of sensors stay within
    const Channel* ay = measuredAs(checks.log, "chassis.ay");
    if (!ay) return true;
    Values across = vx.values;
    for (std::size_t i = 0; i < across.size(); ++i) across[i] *= r.values[i];
    const Relation found = relation(across, ay->values);
    return found.correlation < Relation::kCorrelated || std::abs(std::log(found.factor)) < std::log(kAlike);
}

void checkScale(const LogChecks& checks) {
    const Channel *vx = measuredAs(checks.log, "chassis.vx"), *r = measuredAs(checks.log, "chassis.yaw_rate");
    if (!vx || !r) return;
    const auto turns = [&](std::size_t i) { return vx->values[i] > kCrawling && std::abs(r->values[i]) > kTurning; };
    Values rates = r->values;
    for (double& rate : rates) rate = std::abs(rate);
    const auto radius = medianRatio(vx->values, rates, turns);
    const double wheelbase = checks.nominal.vehicle.wheelbase;
    if (!radius || *radius > kTightest * wheelbase || !agreesWithAy(checks, *vx, *r)) return;
    checks.warn(
        vx->name,
        fmt::format("over yaw rate gives turns of {:.2g} m radius, which a car with a wheelbase of {:.3g} m cannot "
                    "drive without spinning",
                    *radius, wheelbase),
        "The log is from a car of a different scale, or one of the two has a different unit",
        "Name the file of the car that was driven, and check the units of speed and yaw rate");
}

// The largest step between samples before and after which the signal is steady for 0.1 s, per second. Noise, spikes and
// a slower signal that is held between its samples have no such steps.
double largestJump(const LogChecks& checks, const Values& values) {
    const auto later = static_cast<std::size_t>(std::max(1.0, std::round(0.1 * checks.rate())));
    double largest = 0;
    for (std::size_t i = 1 + later; i + later < values.size(); ++i) {
        const double step = std::abs(values[i] - values[i - 1]), seconds = checks.time()[i] - checks.time()[i - 1];
        const double before = std::abs(values[i - 1] - values[i - 1 - later]),
                     after = std::abs(values[i + later] - values[i]);
        if (std::max(before, after) < kSteady * step) largest = std::max(largest, step / seconds);
    }
    return largest;
}

void checkCommands(const LogChecks& checks) {
    const Values* steer = checks.values("driver.steering_wheel_angle");
    const double jump = steer ? largestJump(checks, *steer) : 0;
    if (jump < kJump) return;
    checks.warn("driver.steering_wheel_angle",
                fmt::format("jumps within one sample ({:.0f} rad/s), as a command does, but no measured motion", jump),
                "Lag and delay of the actuator are then part of the gap",
                "Record the measured angle, or expect steering_delay among the causes");
}

// Geometry of a drive that a change of springs, tyres or load hardly alters.
struct Geometry {
    std::optional<double> steering;  // yaw rate over speed and steering-wheel angle, 1/m
    std::optional<double> wheel;     // spin of the front left wheel over speed, 1/m
};
Geometry geometryOf(const LogChecks& checks) {
    const Channel *vx = measuredAs(checks.log, "chassis.vx"), *r = measuredAs(checks.log, "chassis.yaw_rate");
    const Values *steer = checks.values("driver.steering_wheel_angle"), *spin = checks.values("wheel.front_left.spin");
    Geometry found;
    if (!vx) return found;
    const Values& speed = vx->values;
    if (spin) found.wheel = medianRatio(*spin, speed, [&](std::size_t i) { return speed[i] > LogChecks::kMoving; });
    if (!r || !steer) return found;
    Values turned = *steer;
    for (std::size_t i = 0; i < turned.size(); ++i) turned[i] *= speed[i];
    const Relation gain = relation(turned, r->values, [&](std::size_t i) {
        return speed[i] > LogChecks::kMoving && std::abs(speed[i] * r->values[i]) < LogChecks::kSliding;
    });
    if (gain.samples >= Relation::kFewest && gain.correlation > Relation::kCorrelated &&
        gain.spread > kSteered * LogChecks::kMoving)
        found.steering = gain.factor;
    return found;
}

}  // namespace

bool standsStill(const LogChecks& checks) {
    const Channel* vx = measuredAs(checks.log, "chassis.vx");
    if (!vx || checks.log.samples() < 2) return false;
    const auto below = [](const Channel* channel, double limit) {
        return !channel || std::all_of(channel->values.begin(), channel->values.end(),
                                       [&](double value) { return !(std::abs(value) > limit); });
    };
    const bool still = below(vx, kStanding) && below(measuredAs(checks.log, "chassis.yaw_rate"), kTurning);
    if (still)
        checks.warn("", "the car stands still in the whole recording",
                    "It shows only noise and zero offsets of the instruments",
                    "Use it to state noise (channels) and bias (instruments), and remove it from the recordings");
    return still;
}

void checkDrive(const LogChecks& checks) {
    checkScale(checks);
    checkCommands(checks);
}

void checkSameCar(const LogChecks& reference, const LogChecks& after) {
    const Geometry before = geometryOf(reference), now = geometryOf(after);
    const auto differs = [&](const std::optional<double>& a, const std::optional<double>& b, const char* what) {
        if (!a || !b || !(*a * *b > 0) || std::abs(std::log(*b / *a)) < std::log(kOtherCar)) return;
        reference.warn("", fmt::format("{} is {:.2g} times that of the recording itself", what, *a / *b),
                       "If the reference is from another car, the gap that is subtracted is not that of this model",
                       "Use a reference of the same car, recorded with the same instruments");
    };
    differs(before.steering, now.steering, "the yaw rate per speed and steering-wheel angle");
    differs(before.wheel, now.wheel, "the wheel speed per speed");
}

}  // namespace tread::recording::checks
