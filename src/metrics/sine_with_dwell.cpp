// Sine with dwell: stability and responsiveness, after FMVSS 126, UN R13-H and ISO 19365.

#include "metrics/sine_with_dwell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kSmallestDwell = 0.1;            // rad at the steering wheel; less is a correction
constexpr double kDwellSteeringHalfWidth = 0.02;  // s
constexpr double kLowOfPeak = 0.05,
                 kHighOfPeak = 0.15;  // of the peaks: through these the ends of the sine are drawn out
constexpr double kFirstCheck = kYawRateChecks[0].after,
                 kSecondCheck = kYawRateChecks[1].after;  // s after completion of steer
constexpr double kFirstShare = kYawRateChecks[0].share, kSecondShare = kYawRateChecks[1].share;
constexpr double kDisplacementReading = 1.07;   // s after beginning of steer
constexpr double kLight = 1.83, kHeavy = 1.52;  // m, up to and above 3500 kg
constexpr double kShortestDwell = 0.1;          // s
constexpr double kNearPeak = 0.97;              // of the second peak: the wheel waits
constexpr double kPeakMisfit = 0.25;            // of the first peak, by which the second may differ

struct Dwell {
    double begin, end;        // s: beginning and completion of steer
    double amplitude;         // rad
    double frequency, dwell;  // Hz, s
    double speed;             // m/s, at the beginning
    double peak_yaw_rate;     // rad/s, of the second half-wave, with the sign of that half-wave
    double first, second;     // rad/s, at the two times after completion
    double displacement;      // m, towards the first steering
    double largest_ay, largest_sideslip;

    double ratio(double yaw_rate) const { return std::max(0.0, yaw_rate / peak_yaw_rate); }
    bool stable() const { return ratio(first) <= kFirstShare && ratio(second) <= kSecondShare; }
};

MetricTable<Dwell> sineWithDwellTable() {
    const auto flag = [](bool yes) { return yes ? 1.0 : 0.0; };
    const std::string peak = "over the peak of the second half-wave";
    return {
        {{"stable", "Stable (1: yes, 0: no)", "-",
          fmt::format("1 when the yaw rate is at most {:.0f} % of its peak {:.2f} s and {:.0f} % {:.2f} s after "
                      "completion of steer",
                      100 * kFirstShare, kFirstCheck, 100 * kSecondShare, kSecondCheck)},
         [flag](const Dwell& d) { return flag(d.stable()); }},
        {{"yaw_rate_ratio_1.00s", "Yaw rate left after 1.00 s", "-",
          fmt::format("yaw rate {:.2f} s after completion of steer {}; 0 when it has turned back", kFirstCheck, peak),
          Say{1, "{} % of the peak yaw rate 1 s after the steering (35 % allowed)", 0, 100},
          fmt::format("<= {:.0f} %", 100 * kFirstShare)},
         [](const Dwell& d) { return d.ratio(d.first); }},
        {{"yaw_rate_ratio_1.75s", "Yaw rate left after 1.75 s", "-",
          fmt::format("yaw rate {:.2f} s after completion of steer {}; 0 when it has turned back", kSecondCheck, peak),
          Say{2, "{} % after 1.75 s (20 % allowed)", 0, 100}, fmt::format("<= {:.0f} %", 100 * kSecondShare)},
         [](const Dwell& d) { return d.ratio(d.second); }},
        {{"lateral_displacement", "Lateral displacement", "m",
          fmt::format("of the centre of gravity from the initial line, {:.2f} s after beginning of steer, positive "
                      "towards the first steering",
                      kDisplacementReading),
          Say{3, "displaced by {} m (at least 1.83 m)", 2}},
         [](const Dwell& d) { return d.displacement; }},
        {{"responsive", "Responsive (1: yes, 0: no)", "-",
          fmt::format("1 when that is at least {:.2f} m; required of vehicles up to 3500 kg at five times the angle at "
                      "0.3 g and above",
                      kLight)},
         [flag](const Dwell& d) { return flag(d.displacement >= kLight); }},
        {{"responsive_heavy", "Responsive as a heavy vehicle (1: yes, 0: no)", "-",
          fmt::format("1 when it is at least {:.2f} m, required of heavier vehicles", kHeavy)},
         [flag](const Dwell& d) { return flag(d.displacement >= kHeavy); }},
        {{"peak_yaw_rate", "Yaw rate, peak", "deg/s",
          "largest yaw rate after the steering changes sign, in its new direction"},
         [](const Dwell& d) { return kDegrees * std::abs(d.peak_yaw_rate); }},
        {{"largest_sideslip", "Sideslip angle, maximum", "deg",
          "largest magnitude of the sideslip angle; undefined when it is not logged"},
         [](const Dwell& d) { return kDegrees * d.largest_sideslip; }},
        {{"largest_ay", "Lateral acceleration, maximum", "m/s2", "largest magnitude of the lateral acceleration"},
         [](const Dwell& d) { return d.largest_ay; }},
        {{"steering_amplitude", "Steering-wheel amplitude", "deg", "mean of the two peaks of the steering-wheel angle"},
         [](const Dwell& d) { return kDegrees * d.amplitude; }},
        {{"frequency", "Steering frequency", "Hz", "of the sine, from its first half-wave"},
         [](const Dwell& d) { return d.frequency; }},
        {{"dwell", "Dwell", "s", "completion of steer minus beginning of steer minus the period of the sine"},
         [](const Dwell& d) { return d.dwell; }},
        {{"speed", "Speed", "m/s", "when the steering begins"}, [](const Dwell& d) { return d.speed; }},
    };
}

// Where a flank that passes a low and a high level would meet zero.
double drawnOut(double t_low, double t_high) {
    return t_low - (t_high - t_low) * kLowOfPeak / (kHighOfPeak - kLowOfPeak);
}

// Times and sizes of the steering alone.
Dwell findSteering(const TimeSeries& hand) {
    const TimeSeries angle = increments(hand, hand.value.front());
    const Instant high = highest(angle, angle.begin(), angle.end()), low = lowest(angle, angle.begin(), angle.end());
    const double sign = high.time < low.time ? 1 : -1;
    const Instant first = sign > 0 ? high : low, second = sign > 0 ? low : high;
    Dwell found{};
    found.amplitude = 0.5 * std::abs(first.value - second.value);
    if (found.amplitude < kSmallestDwell) {
        notFound(fmt::format("the steering wheel moves by only +-{:.2g} deg, expected at least {:.2g} deg",
                             kDegrees * found.amplitude, kDegrees * kSmallestDwell));
    }
    if (std::abs(first.value + second.value) > kPeakMisfit * found.amplitude)
        notFound("the steering has no peaks of equal size on both sides");
    const auto rising = [&](double level) {
        return lastCrossing(angle, level * first.value, angle.begin(), first.time);
    };
    const auto falling = [&](double level) { return firstCrossing(angle, level * second.value, second.time); };
    const auto turned = lastCrossing(angle, 0, first.time, second.time);
    const auto waits = firstCrossing(angle, kNearPeak * second.value, first.time);
    const auto leaves = lastCrossing(angle, kNearPeak * second.value, second.time, angle.end());
    if (!rising(kLowOfPeak) || !rising(kHighOfPeak) || !falling(kLowOfPeak) || !falling(kHighOfPeak) || !turned ||
        !waits || !leaves)
        notFound("the steering does not begin and end where it was");
    found.begin = drawnOut(*rising(kLowOfPeak), *rising(kHighOfPeak));
    found.end = drawnOut(*falling(kLowOfPeak), *falling(kHighOfPeak));
    found.frequency = 0.5 / (*turned - found.begin);
    found.dwell = found.end - found.begin - 1 / found.frequency;
    if (found.dwell < kShortestDwell) {
        notFound(fmt::format("the steering dwells for {:.2g} s at its second peak, expected at least {:.2g} s",
                             found.dwell, kShortestDwell));
    }
    return found;
}

// How far the car has come aside, towards a side; from its position, or from its lateral acceleration as the rule does.
double displacement(const Log& log, const Dwell& dwell, double side) {
    const auto x = channelIfThere(log, "chassis.x"), y = channelIfThere(log, "chassis.y"),
               yaw = channelIfThere(log, "chassis.yaw");
    const double from = dwell.begin, to = from + kDisplacementReading;
    if (x && y && yaw) {
        const double heading = mean(*yaw, from - 0.2, from);
        return side *
               ((at(*y, to) - at(*y, from)) * std::cos(heading) - (at(*x, to) - at(*x, from)) * std::sin(heading));
    }
    const TimeSeries ay = channels(log, {"chassis.ay"}).front();
    const TimeSeries change = increments(ay, mean(ay, from - 0.5, from));
    double v = 0, way = 0, t = from;
    for (constexpr double kStep = 0.001; t < to; t += kStep) {
        const double before = v;
        v += integral(change, t, std::min(t + kStep, to));
        way += 0.5 * (before + v) * std::min(kStep, to - t);
    }
    return side * way;
}

double largestMagnitude(const TimeSeries& series, double from, double to) {
    return std::max(std::abs(highest(series, from, to).value), std::abs(lowest(series, from, to).value));
}

Dwell findDwell(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries hand = cleaned(needed[0], kDwellSteeringHalfWidth);
    Dwell found = findSteering(hand);
    if (hand.end() < found.end + kSecondCheck) {
        notFound(fmt::format("the log ends {:.2g} s after completion of steer, expected {:.2f} s",
                             hand.end() - found.end, kSecondCheck));
    }
    const double side = at(hand, found.begin + 0.25 / found.frequency) > hand.value.front() ? 1 : -1;
    const TimeSeries yaw_rate = cleaned(needed[2], kResponseHalfWidth);
    const double turned = found.begin + 0.5 / found.frequency;
    found.peak_yaw_rate = side > 0 ? lowest(yaw_rate, turned, found.end + kFirstCheck).value
                                   : highest(yaw_rate, turned, found.end + kFirstCheck).value;
    found.first = at(yaw_rate, found.end + kFirstCheck);
    found.second = at(yaw_rate, found.end + kSecondCheck);
    found.speed = at(speed(log), found.begin);
    found.displacement = displacement(log, found, side);
    found.largest_ay = largestMagnitude(cleaned(needed[3], kResponseHalfWidth), found.begin, found.end);
    const auto slip = sideslip(log);
    found.largest_sideslip =
        slip ? largestMagnitude(cleaned(*slip, kResponseHalfWidth), found.begin, found.end + kSecondCheck) : kUndefined;
    return found;
}

}  // namespace

DwellSteering dwellSteering(const Log& log) {
    const Dwell found = findDwell(log);
    return {found.begin, found.end, found.peak_yaw_rate};
}

Manoeuvre sineWithDwell() {
    return {"sine_with_dwell", "sine with dwell: stability and lateral displacement (after FMVSS 126 and ISO 19365)",
            [] { return definitions(sineWithDwellTable()); },
            [](const Log& log, const KnownCar&) { return values(sineWithDwellTable(), findDwell(log)); }};
}

}  // namespace tread
