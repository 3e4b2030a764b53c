// Fishhook and J-turn, after NHTSA's rollover tests: do both wheels of one side leave the road at once?

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"

namespace tread {
namespace {

constexpr std::string_view kFishhook = "fishhook", kJTurn = "j_turn";
constexpr double kPlateau = 0.95;                 // of the largest angle: steered to its end
constexpr double kBegins = 0.05;                  // of it: steering has begun
constexpr double kAlike = 0.8;                    // least angle of one side over that of the other, of a fishhook
constexpr double kLargeAngle = 60 / kDegrees;     // rad; less is no test of the roll-over
constexpr double kFishhookRate = 500 / kDegrees;  // rad/s, least of 720 deg/s as logged
constexpr double kJTurnRate = 750 / kDegrees;     // rad/s, least of 1000 deg/s; a step steer has up to 500
constexpr double kShortestLastHold = 1;           // s, least time at the last angle
constexpr double kNoLoad = 1;                     // N, of a measured load: less is none

struct Rollover {
    double amplitude, begin, reversal = kUndefined;          // rad, s, s
    double entry_speed;                                      // m/s
    double two_wheels = kUndefined, one_wheel = kUndefined;  // s
    double transfer = kUndefined;                            // -
    double roll, roll_rate = kUndefined, ay, sideslip = kUndefined;
    bool known() const { return !std::isnan(two_wheels); }
};

MetricTable<Rollover> table(bool fishhook) {
    MetricTable<Rollover> lines = {
        {{"two_wheel_lift", "Two-wheel lift, longest", "s",
          "longest time during which both wheels of one side carry no load at once; 0: never; undefined without the "
          "wheels' loads",
          Say{1, "two wheels lifted for {} s", 2}},
         [](const Rollover& r) { return r.two_wheels; }},
        {{"no_two_wheel_lift", "No two-wheel lift", "-", "1 when that never happens: a pass criterion for series"},
         [](const Rollover& r) { return r.known() ? (r.two_wheels == 0 ? 1.0 : 0.0) : kUndefined; }},
        {{"wheel_lift", "Wheel lift, longest", "s", "longest time during which any one wheel carries no load"},
         [](const Rollover& r) { return r.one_wheel; }},
        {{"load_transfer_ratio", "Load transfer ratio, peak", "-",
          "largest magnitude of (right load - left load) / (right load + left load); 1: one side is lifted",
          Say{2, "load transfer ratio up to {}", 2}},
         [](const Rollover& r) { return r.transfer; }},
        {{"largest_roll", "Roll angle, peak", "deg", "largest magnitude of the roll angle",
          Say{3, "roll angle up to {} deg", 1}},
         [](const Rollover& r) { return kDegrees * r.roll; }},
        {{"largest_roll_rate", "Roll rate, peak", "deg/s", "largest magnitude of the roll rate"},
         [](const Rollover& r) { return kDegrees * r.roll_rate; }},
        {{"largest_ay", "Lateral acceleration, peak", "m/s2", "largest magnitude of the lateral acceleration"},
         [](const Rollover& r) { return r.ay; }},
        {{"largest_sideslip", "Sideslip angle, peak", "deg", "largest magnitude of the sideslip angle"},
         [](const Rollover& r) { return kDegrees * r.sideslip; }},
        {{"entry_speed", "Speed at the beginning of the steering", "m/s", "speed when the steering begins"},
         [](const Rollover& r) { return r.entry_speed; }},
        {{"steering_angle", "Steering-wheel angle, peak", "deg", "largest magnitude of the steering-wheel angle"},
         [](const Rollover& r) { return kDegrees * r.amplitude; }},
    };
    if (fishhook) {
        lines.push_back({{"reversal_time", "Time to the countersteer", "s",
                          "from the beginning of the steering to that of the countersteer"},
                         [](const Rollover& r) { return r.reversal - r.begin; }});
    }
    return lines;
}

double largest(const TimeSeries& series) {
    return largestSample(series);
}

// Longest time for which the value is at most the limit, from sample to sample.
double longestBelow(const TimeSeries& series, double limit) {
    double longest = 0;
    std::size_t first = series.size();
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series.value[i] > limit) {
            first = series.size();
            continue;
        }
        first = std::min(first, i);
        longest = std::max(longest, series.time[i] - series.time[first]);
    }
    return longest;
}

void findLift(const Log& log, Rollover& found) {
    std::vector<TimeSeries> loads;
    for (std::string_view wheel : kWheelNames) {
        auto load = channelIfThere(log, fmt::format("wheel.{}.load", wheel));
        if (!load) return;
        loads.push_back(*std::move(load));
    }
    TimeSeries left = loads[0], right = loads[1];  // the larger load of the side: both are lifted when it is none
    found.one_wheel = found.transfer = 0;
    for (const TimeSeries& load : loads) found.one_wheel = std::max(found.one_wheel, longestBelow(load, kNoLoad));
    for (std::size_t i = 0; i < left.size(); ++i) {
        const double on_left = loads[0].value[i] + loads[2].value[i], on_right = loads[1].value[i] + loads[3].value[i];
        if (on_left + on_right > kNoLoad)
            found.transfer = std::max(found.transfer, std::abs(on_right - on_left) / (on_left + on_right));
        left.value[i] = std::max(loads[0].value[i], loads[2].value[i]);
        right.value[i] = std::max(loads[1].value[i], loads[3].value[i]);
    }
    found.two_wheels = std::max(longestBelow(left, kNoLoad), longestBelow(right, kNoLoad));
}

// The first sample from a time on that is below the level; nothing when none is.
std::optional<double> firstBelow(const TimeSeries& series, double level, double from) {
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series.time[i] > from && series.value[i] < level) return series.time[i];
    }
    return {};
}

double fastest(const TimeSeries& hand) {
    double rate = 0;
    for (std::size_t i = 1; i < hand.size(); ++i) {
        rate = std::max(rate, std::abs(hand.value[i] - hand.value[i - 1]) / (hand.time[i] - hand.time[i - 1]));
    }
    return rate;
}

Rollover findRollover(const Log& log, bool fishhook) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.roll", "chassis.vx", "chassis.ay"});
    const TimeSeries hand = increments(needed[0], needed[0].value.front());
    const Instant left = highest(hand, hand.begin(), hand.end()), right = lowest(hand, hand.begin(), hand.end());
    Rollover found{};
    found.amplitude = std::max(left.value, -right.value);
    const double less = std::min(left.value, -right.value);
    if (found.amplitude < kLargeAngle) {
        notFound(fmt::format("the steering wheel turns to {:.3g} deg at most, expected {:.3g} deg or more",
                             kDegrees * found.amplitude, kDegrees * kLargeAngle));
    }
    if (fishhook != (less >= kAlike * found.amplitude)) {
        notFound(fishhook ? "the steering wheel turns to one side only, or farther to one than to the other"
                          : "the steering wheel turns to both sides");
    }
    const double rate = fastest(hand), least = fishhook ? kFishhookRate : kJTurnRate;
    if (rate < least) {
        notFound(fmt::format("the steering wheel turns at {:.3g} deg/s at most, expected {:.3g} deg/s or more",
                             kDegrees * rate, kDegrees * least));
    }
    // A fishhook begins with the side that comes first, a J-turn has only one.
    const bool to_the_left = fishhook ? left.time < right.time : left.value > -right.value;
    const double sign = to_the_left ? 1 : -1;
    const double first = sign * (sign > 0 ? left.value : right.value);
    const TimeSeries turned = increments(hand, 0, sign);
    found.begin = firstCrossing(turned, kBegins * first, turned.begin()).value_or(turned.begin());
    const double up = firstCrossing(turned, kPlateau * first, found.begin).value_or(found.begin);
    const auto down = firstBelow(turned, kPlateau * first, up);
    double held_from = up, held_to = down.value_or(turned.end());
    if (fishhook) {
        found.reversal = down.value_or(kUndefined);
        held_from = firstBelow(turned, -kPlateau * less, held_to).value_or(turned.end());
        held_to = firstBelow(increments(turned, 0, -1), kPlateau * less, held_from).value_or(turned.end());
    }
    // A log that ends before is that of a car which tipped over.
    if (held_to < turned.end() && held_to - held_from < kShortestLastHold) {
        notFound(fmt::format("the last angle is held for {:.2g} s, expected {} s or more", held_to - held_from,
                             kShortestLastHold));
    }
    found.entry_speed = at(speed(log), found.begin);
    found.roll = largest(needed[1]);
    found.ay = largest(needed[3]);
    if (const auto rate_of_roll = channelIfThere(log, "chassis.roll_rate")) found.roll_rate = largest(*rate_of_roll);
    if (const auto slip = sideslip(log)) found.sideslip = largest(*slip);
    findLift(log, found);
    return found;
}

}  // namespace

Manoeuvre fishhook() {
    return {kFishhook, "steering to one side and hard to the other: two-wheel lift (after NHTSA)",
            [] { return definitions(table(true)); },
            [](const Log& log, const KnownCar&) { return values(table(true), findRollover(log, true)); }};
}

Manoeuvre jTurn() {
    return {kJTurn, "one large, quick steer that is held: two-wheel lift (after NHTSA)",
            [] { return definitions(table(false)); },
            [](const Log& log, const KnownCar&) { return values(table(false), findRollover(log, false)); }};
}

}  // namespace tread
