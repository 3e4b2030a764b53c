// On-centre handling, weave test after ISO 13674-1: a slow sine about straight ahead, and what is read off the loops of
// one quantity over another.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kWeaveHalfWidth = 0.1;            // s
constexpr double kSmallestWeave = 0.5 / kDegrees;  // rad at the steering wheel
constexpr double kFastestWeave = 0.5;              // Hz: quicker is no on-centre weave
constexpr std::size_t kFewestWeaves = 4;
constexpr double kCentre = 0.2;  // of the amplitude: the range of the slopes on centre

double halfSwing(const TimeSeries& series, double from, double to) {
    return 0.5 * (highest(series, from, to).value - lowest(series, from, to).value);
}

struct Loop {
    double slope;   // of y over x on centre, mean of both branches
    double width;   // in x, between the branches at y = 0
    double height;  // in y, between the branches at x = 0
};

// Mean of `other` where `series` passes its mean upwards, less that where it passes downwards.
double betweenBranches(const TimeSeries& series, const TimeSeries& other, double from, double to) {
    const double middle = mean(series, from, to);
    double sum[2] = {0, 0}, count[2] = {0, 0};
    for (std::size_t i = 0; i + 1 < series.size(); ++i) {
        const double left = series.value[i] - middle, right = series.value[i + 1] - middle;
        if (series.time[i] < from || series.time[i] > to || (left < 0) == (right < 0)) continue;
        const double t = series.time[i] + left / (left - right) * (series.time[i + 1] - series.time[i]);
        sum[left < 0] += at(other, t);
        count[left < 0] += 1;
    }
    return sum[1] / count[1] - sum[0] / count[0];
}

double slopeOnCentre(const TimeSeries& x, const TimeSeries& y, double from, double to) {
    const double middle = mean(x, from, to);
    const double reach = kCentre * halfSwing(x, from, to);
    const TimeSeries rate = derivative(x, kWeaveHalfWidth);
    double slope = 0;
    for (const double direction : {1.0, -1.0}) {
        std::vector<double> xs, ys;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (x.time[i] < from || x.time[i] > to || direction * rate.value[i] <= 0) continue;
            if (std::abs(x.value[i] - middle) > reach) continue;
            xs.push_back(x.value[i]);
            ys.push_back(y.value[i]);
        }
        slope += 0.5 * (xs.size() < 3 ? kUndefined : fitLine(xs, ys).slope);
    }
    return slope;
}

Loop loopOf(const TimeSeries& x, const TimeSeries& y, double from, double to) {
    return {slopeOnCentre(x, y, from, to), std::abs(betweenBranches(y, x, from, to)),
            std::abs(betweenBranches(x, y, from, to))};
}

struct Weave {
    double speed, frequency, steering_amplitude, ay_amplitude;
    double yaw_rate_lag;  // s
    Loop ay_over_steering, yaw_rate_over_steering, torque_over_steering, torque_over_ay;
};

MetricTable<Weave> weaveTable() {
    const std::string centre = fmt::format("on centre, within {:.0f} % of the amplitude", 100 * kCentre);
    const std::string no_torque = "; undefined when no torque is logged";
    return {
        {{"steering_sensitivity", "Steering sensitivity", "g/100deg", "d ay / d steering-wheel angle " + centre,
          Say{1, "steering sensitivity {} g/100 deg", 2}},
         [](const Weave& w) { return w.ay_over_steering.slope / kGravity * 100 / kDegrees; }},
        {{"steering_hysteresis", "Steering hysteresis", "deg",
          "steering-wheel angle between the two branches at ay = 0", Say{3, "hysteresis {} deg", 1}},
         [](const Weave& w) { return kDegrees * w.ay_over_steering.width; }},
        {{"ay_hysteresis", "Lateral acceleration, hysteresis", "m/s2",
          "lateral acceleration between the two branches at zero steering-wheel angle"},
         [](const Weave& w) { return w.ay_over_steering.height; }},
        {{"yaw_rate_gain", "Yaw rate, gain", "1/s", "d yaw rate / d steering-wheel angle " + centre},
         [](const Weave& w) { return w.yaw_rate_over_steering.slope; }},
        {{"yaw_rate_lag", "Yaw rate, lag", "s", "mean time from zero steering-wheel angle to zero yaw rate",
          Say{2, "yaw rate lags by {} ms", 0, 1000}},
         [](const Weave& w) { return w.yaw_rate_lag; }},
        {{"steering_stiffness", "Steering stiffness", "N m/rad",
          "d steering-wheel torque / d steering-wheel angle " + centre + no_torque},
         [](const Weave& w) { return w.torque_over_steering.slope; }},
        {{"steering_friction", "Steering friction", "N m", "torque between the two branches at zero angle" + no_torque},
         [](const Weave& w) { return w.torque_over_steering.height; }},
        {{"torque_gradient", "Steering-wheel torque gradient", "N m/g",
          "d steering-wheel torque / d ay " + centre + no_torque},
         [](const Weave& w) { return w.torque_over_ay.slope * kGravity; }},
        {{"torque_deadband", "Steering-wheel torque deadband", "g",
          "lateral acceleration between the two branches at zero torque" + no_torque},
         [](const Weave& w) { return w.torque_over_ay.width / kGravity; }},
        {{"speed", "Speed, mean", "m/s", "mean forward speed"}, [](const Weave& w) { return w.speed; }},
        {{"frequency", "Weave frequency", "Hz", "of the weave"}, [](const Weave& w) { return w.frequency; }},
        {{"steering_amplitude", "Steering-wheel amplitude", "deg", "half the swing of the steering-wheel angle"},
         [](const Weave& w) { return kDegrees * w.steering_amplitude; }},
        {{"ay_amplitude", "Lateral acceleration, amplitude", "m/s2", "half the swing of the lateral acceleration"},
         [](const Weave& w) { return w.ay_amplitude; }},
    };
}

Weave findWeave(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries hand = cleaned(needed[0], kWeaveHalfWidth), yaw_rate = cleaned(needed[2], kWeaveHalfWidth),
                     ay = cleaned(needed[3], kWeaveHalfWidth);
    const double amplitude = halfSwing(hand, hand.begin(), hand.end());
    if (amplitude < kSmallestWeave) notFound("the steering wheel hardly moves");
    const auto turns = turningPoints(hand, amplitude);
    if (turns.size() < kFewestWeaves) {
        notFound(fmt::format("the steering turns back {} times, expected at least {}", turns.size(), kFewestWeaves));
    }
    // Whole periods: from one turning point to the last of the same side.
    const std::size_t periods = (turns.size() - 1) / 2;
    const double to = turns.back().time, from = turns[turns.size() - 1 - 2 * periods].time;
    Weave found{};
    found.frequency = static_cast<double>(periods) / (to - from);
    if (found.frequency > kFastestWeave) {
        notFound(fmt::format("the steering swings at {:.2g} Hz, expected at most {:.2g} Hz", found.frequency,
                             kFastestWeave));
    }
    found.speed = mean(needed[1], from, to);
    found.steering_amplitude = halfSwing(hand, from, to);
    found.ay_amplitude = halfSwing(ay, from, to);
    found.ay_over_steering = loopOf(hand, ay, from, to);
    found.yaw_rate_over_steering = loopOf(hand, yaw_rate, from, to);
    found.torque_over_steering = found.torque_over_ay = {kUndefined, kUndefined, kUndefined};
    if (const auto torque = channelIfThere(log, "steering.torque")) {
        const TimeSeries clean = cleaned(*torque, kWeaveHalfWidth);
        found.torque_over_steering = loopOf(hand, clean, from, to);
        found.torque_over_ay = loopOf(ay, clean, from, to);
    }
    // Zero steering to zero yaw rate, over all half-waves.
    const double hand_middle = mean(hand, from, to), yaw_middle = mean(yaw_rate, from, to);
    double lag = 0, count = 0;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
        const auto zero = firstCrossing(hand, hand_middle, turns[i].time, turns[i + 1].time);
        if (!zero || turns[i].time < from) continue;
        const double half = 0.5 / found.frequency;
        const auto answer = firstCrossing(yaw_rate, yaw_middle, *zero - 0.25 * half, *zero + 0.75 * half);
        if (!answer) continue;
        lag += *answer - *zero;
        count += 1;
    }
    found.yaw_rate_lag = count > 0 ? lag / count : kUndefined;
    return found;
}

}  // namespace

Manoeuvre weave() {
    return {"weave", "a slow weave about straight ahead: on-centre sensitivity, hysteresis, lag (after ISO 13674-1)",
            [] { return definitions(weaveTable()); },
            [](const Log& log, const KnownCar&) { return values(weaveTable(), findWeave(log)); }};
}

}  // namespace tread
