// Slowly increasing steer at constant speed, after FMVSS 126 (S7.6) and SAE J266: the steering-wheel angle A at 0.3 g,
// by which sine with dwell is scaled.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kRegressionFrom = 0.1 * kGravity, kRegressionTo = 0.375 * kGravity;  // range of the regression
constexpr double kAngleReading = 0.3 * kGravity;
constexpr double kSlowSteerHalfWidth = 0.25;         // s; everything changes slowly here
constexpr double kFastestSlowSteer = 25 / kDegrees;  // rad/s: faster is no slow steering
constexpr double kSpeedChange = 0.05;                // of the speed, over the range of the regression
constexpr std::size_t kFewestRegressed = 10;         // samples

struct SlowSteer {
    double angle;        // rad, at 0.3 g
    double slope;        // rad per m/s2
    double speed;        // m/s
    double rate;         // rad/s
    double largest_ay;   // m/s2
    double angle_there;  // rad
    double understeer;   // rad per m/s2 at the road wheels
};

MetricTable<SlowSteer> slowlyIncreasingSteerTable() {
    const std::string range =
        fmt::format("regression over {:.3g} to {:.3g} g", kRegressionFrom / kGravity, kRegressionTo / kGravity);
    return {
        {{"steering_angle_03g", "Steering-wheel angle at 0.3 g", "deg",
          "A: steering-wheel angle at 0.3 g, from straight ahead, on the line of the " + range,
          Say{1, "steering-wheel angle at 0.3 g {} deg", 1}},
         [](const SlowSteer& s) { return kDegrees * s.angle; }},
        {{"steering_wheel_gradient", "Steering-wheel angle gradient", "deg/g",
          "d steering-wheel angle / d ay, " + range},
         [](const SlowSteer& s) { return kDegrees * kGravity * s.slope; }},
        {{"understeer_gradient", "Understeer gradient", "deg/g",
          "d road-wheel angle (by the steering ratio) / d ay, minus wheelbase / speed^2; undefined when these are not "
          "known",
          Say{2, "understeer gradient {} deg/g", 2}},
         [](const SlowSteer& s) { return kDegrees * kGravity * s.understeer; }},
        {{"largest_ay", "Lateral acceleration, maximum", "m/s2", "largest magnitude of the lateral acceleration",
          Say{3, "up to {} m/s2 of lateral acceleration", 2}},
         [](const SlowSteer& s) { return s.largest_ay; }},
        {{"steering_angle_largest_ay", "Steering-wheel angle at the largest lateral acceleration", "deg",
          "magnitude of the steering-wheel angle there"},
         [](const SlowSteer& s) { return kDegrees * s.angle_there; }},
        {{"speed", "Speed, mean", "m/s", "mean over the range of the regression"},
         [](const SlowSteer& s) { return s.speed; }},
        {{"steering_rate", "Steering-wheel rate", "deg/s", "mean over the range of the regression"},
         [](const SlowSteer& s) { return kDegrees * s.rate; }},
    };
}

SlowSteer findSlowSteer(const Log& log, const KnownCar& car) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.ay"});
    const TimeSeries hand = cleaned(needed[0], kSlowSteerHalfWidth), ay = cleaned(needed[2], kSlowSteerHalfWidth);
    const TimeSeries v = speed(log);
    const Instant left = highest(ay, ay.begin(), ay.end()), right = lowest(ay, ay.begin(), ay.end());
    const double sign = left.value >= -right.value ? 1 : -1;
    const Instant most = sign > 0 ? left : right;
    const double zero = hand.value.front();

    std::vector<double> x, y, road, times, speeds;
    for (std::size_t i = 0; i < ay.size() && ay.time[i] <= most.time; ++i) {
        const double a = sign * ay.value[i];
        if (a < kRegressionFrom || a > kRegressionTo) continue;
        x.push_back(a);
        y.push_back(sign * (hand.value[i] - zero));
        road.push_back(sign * car.roadWheelAngle(hand.value[i]));
        times.push_back(ay.time[i]);
        speeds.push_back(v.value[i]);
    }
    if (x.size() < kFewestRegressed || *std::max_element(x.begin(), x.end()) < kAngleReading) {
        notFound(fmt::format(
            "the lateral acceleration reaches {:.2g} m/s2, expected a slow rise through {:.2g} to {:.2g} m/s2",
            sign * most.value, kRegressionFrom, kRegressionTo));
    }
    const double rate = fitLine(times, y).slope;
    if (rate <= 0 || rate > kFastestSlowSteer) {
        notFound(fmt::format("the steering wheel turns at {:.3g} deg/s, expected up to {:.3g} deg/s", kDegrees * rate,
                             kDegrees * kFastestSlowSteer));
    }
    const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
    if (*fastest - *slowest > kSpeedChange * *fastest) {
        notFound(
            fmt::format("the speed changes from {:.3g} to {:.3g} m/s, expected a constant one", *fastest, *slowest));
    }
    double sum = 0;
    for (double value : speeds) sum += value;
    const Line line = fitLine(x, y);
    SlowSteer found{};
    found.slope = line.slope;
    found.angle = line.offset + line.slope * kAngleReading;
    found.speed = sum / static_cast<double>(speeds.size());
    found.rate = rate;
    found.largest_ay = sign * most.value;
    found.angle_there = sign * (at(hand, most.time) - zero);
    found.understeer = fitLine(x, road).slope - car.wheelbase / (found.speed * found.speed);
    return found;
}

}  // namespace

Manoeuvre slowlyIncreasingSteer() {
    return {"slowly_increasing_steer",
            "slow steering at constant speed: steering-wheel angle at 0.3 g (after FMVSS 126)",
            [] { return definitions(slowlyIncreasingSteerTable()); },
            [](const Log& log, const KnownCar& car) {
                return values(slowlyIncreasingSteerTable(), findSlowSteer(log, car));
            }};
}

}  // namespace tread
