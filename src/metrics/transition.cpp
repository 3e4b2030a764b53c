// On-centre handling, transition test after ISO 13674-2: a slow ramp out of straight ahead.

#include <fmt/format.h>

#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kTransitionHalfWidth = 0.1;          // s
constexpr double kAyHalfWidth = 0.25;                 // s
constexpr double kFastestRamp = 6 / kDegrees;         // rad/s
constexpr double kFirstAy = 0.2, kLastAy = 1.0;       // m/s2, range of the slopes
constexpr std::size_t kFewestTransitionSamples = 10;  // samples

struct Transition {
    double speed, rate;
    double sensitivity;  // m/s2 per rad
    double deadband;     // rad
    double yaw_gain;     // 1/s
    double torque_gradient;
    double torque_deadband;  // N m
};

MetricTable<Transition> transitionTable() {
    const std::string range = fmt::format("regression over {:.1f} to {:.1f} m/s2", kFirstAy, kLastAy);
    return {
        {{"steering_sensitivity", "Steering sensitivity", "g/100deg", "d ay / d steering-wheel angle, " + range,
          Say{1, "steering sensitivity {} g/100 deg", 2}},
         [](const Transition& t) { return t.sensitivity / kGravity * 100 / kDegrees; }},
        {{"steering_deadband", "Steering deadband", "deg", "steering-wheel angle at which that line starts from ay = 0",
          Say{2, "dead band {} deg", 2}},
         [](const Transition& t) { return kDegrees * t.deadband; }},
        {{"yaw_rate_gain", "Yaw rate, gain", "1/s", "d yaw rate / d steering-wheel angle over the same time"},
         [](const Transition& t) { return t.yaw_gain; }},
        {{"torque_gradient", "Steering-wheel torque gradient", "N m/g",
          "d steering-wheel torque / d ay, " + range + "; undefined when no torque is logged"},
         [](const Transition& t) { return t.torque_gradient * kGravity; }},
        {{"torque_deadband", "Steering-wheel torque deadband", "N m", "torque at which that line starts from ay = 0"},
         [](const Transition& t) { return t.torque_deadband; }},
        {{"speed", "Speed, mean", "m/s", "mean forward speed"}, [](const Transition& t) { return t.speed; }},
        {{"steering_rate", "Steering-wheel rate", "deg/s", "mean over the regression"},
         [](const Transition& t) { return kDegrees * t.rate; }},
    };
}

Transition findTransition(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries hand = cleaned(needed[0], kTransitionHalfWidth),
                     yaw_rate = cleaned(needed[2], kTransitionHalfWidth), ay = cleaned(needed[3], kAyHalfWidth);
    const double sign =
        std::abs(highest(ay, ay.begin(), ay.end()).value) > std::abs(lowest(ay, ay.begin(), ay.end()).value) ? 1 : -1;
    const auto torque = channelIfThere(log, "steering.torque");
    std::vector<double> times, angles, accelerations, rates, torques;
    const double rest = mean(hand, hand.begin(), hand.begin() + 0.2);
    const double end = firstCrossing(ay, sign * kLastAy, ay.begin()).value_or(ay.end());
    for (std::size_t i = 0; i < ay.size() && ay.time[i] <= end; ++i) {
        if (sign * ay.value[i] < kFirstAy) continue;
        times.push_back(ay.time[i]);
        angles.push_back(sign * (hand.value[i] - rest));
        accelerations.push_back(sign * ay.value[i]);
        rates.push_back(sign * yaw_rate.value[i]);
        if (torque) torques.push_back(sign * torque->value[i]);
    }
    if (times.size() < kFewestTransitionSamples || end == ay.end()) {
        notFound(fmt::format("expected a slow rise of the lateral acceleration through {:.1f} to {:.1f} m/s2", kFirstAy,
                             kLastAy));
    }
    Transition found{};
    found.rate = fitLine(times, angles).slope;
    if (found.rate <= 0 || found.rate > kFastestRamp) {
        notFound(fmt::format("the steering wheel turns at {:.2g} deg/s, expected at most {:.2g} deg/s",
                             kDegrees * found.rate, kDegrees * kFastestRamp));
    }
    const Line line = fitLine(angles, accelerations);
    found.sensitivity = line.slope;
    found.deadband = -line.offset / line.slope;
    found.yaw_gain = fitLine(angles, rates).slope;
    const Line turning = torque ? fitLine(accelerations, torques) : Line{kUndefined, kUndefined};
    found.torque_gradient = turning.slope;
    found.torque_deadband = turning.offset;
    found.speed = mean(needed[1], times.front(), times.back());
    return found;
}

}  // namespace

Manoeuvre transition() {
    return {"transition", "a slow ramp out of straight ahead: on-centre sensitivity and dead band (after ISO 13674-2)",
            [] { return definitions(transitionTable()); },
            [](const Log& log, const KnownCar&) { return values(transitionTable(), findTransition(log)); }};
}

}  // namespace tread
