// Step steer, after ISO 7401.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/math/median.h"
#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kSmallestStep = 0.02;           // rad at the steering wheel; less is a correction
constexpr double kSlowestRise = 0.6;             // s from 10 to 90 %; slower is a ramp (the standard asks for 0.15 s)
constexpr double kShortestHold = 1.0;            // s; the yaw rate needs about that to settle
constexpr double kHoldBand = 0.05;               // of the step: how far a driver's hands may wander while holding
constexpr double kHoldShare = 0.9;               // of the time that must be spent within the band
constexpr double kSlowestStep = 1.0;             // m/s; below, a car does not turn
constexpr double kSteadyWindow = 1.0;            // s at the end of the hold over which the steady state is taken
constexpr double kSteadyDrift = 0.03;            // change over that window, as a share, up to which it counts as steady
constexpr double kLeastOvershoot = 0.005;        // less is no peak
constexpr double kStepSteeringHalfWidth = 0.02;  // s; keeps the corners of a quick ramp

struct Step {
    double onset;      // s
    double half;       // s, time zero of the standard: half the steering input
    double hold_end;   // s
    double before;     // rad
    double amplitude;  // rad, with sign
    double rate;       // rad/s
    double direction() const { return amplitude < 0 ? -1 : 1; }
};

// From the first to the last time at which the steering is within the band around the held value.
struct Hold {
    double from = 0, to = 0;
    double share = 0;  // of the samples that lie within the band
};
Hold findHold(const TimeSeries& steering, double held, double amplitude) {
    Hold hold;
    std::size_t first = steering.size(), last = 0, inside = 0;
    for (std::size_t i = 0; i < steering.size(); ++i) {
        if (std::abs(steering.value[i] - held) > kHoldBand * std::abs(amplitude)) continue;
        first = std::min(first, i);
        last = i;
        ++inside;
    }
    if (inside == 0) return hold;
    return {steering.time[first], steering.time[last],
            static_cast<double>(inside) / static_cast<double>(last - first + 1)};
}

Step findStep(const TimeSeries& steering) {
    // Rough: from the first sample to the largest change, and how long more than half of that lasts.
    const double start = steering.value.front();
    double farthest = 0;
    for (double value : steering.value) {
        if (std::abs(value - start) > std::abs(farthest)) farthest = value - start;
    }
    if (std::abs(farthest) < kSmallestStep) {
        notFound(fmt::format("the steering wheel moves by only {:.2g} deg, expected a step of at least {:.2g} deg",
                             kDegrees * std::abs(farthest), kDegrees * kSmallestStep));
    }
    const double rough_half = *firstCrossing(steering, start + 0.5 * farthest, steering.begin());
    const auto behind = static_cast<std::size_t>(
        std::upper_bound(steering.time.begin(), steering.time.end(), rough_half) - steering.time.begin());
    const double half_end =
        firstCrossing(steering, start + 0.5 * farthest, steering.time[std::min(behind, steering.size() - 1)])
            .value_or(steering.end());
    const TimeSeries high = part(steering, rough_half, half_end);
    const Hold hold = findHold(high, median(high.value), farthest);

    // Refined: levels as means over the quiet times before and behind.
    Step step{};
    step.hold_end = hold.to;
    const double quarter = 0.25 * (hold.to - hold.from);  // the corners of the hold are not yet, or no longer, held
    const double after = mean(steering, hold.from + quarter, hold.to - quarter);
    const double t10 =
        lastCrossing(steering, start + 0.1 * (after - start), steering.begin(), rough_half).value_or(steering.begin());
    const double t90 = firstCrossing(steering, start + 0.9 * (after - start), rough_half).value_or(hold.from);
    step.onset = std::max(t10 - 0.125 * (t90 - t10), steering.begin());
    step.before = mean(steering, step.onset - 1, step.onset);
    step.amplitude = after - step.before;
    step.half = firstCrossing(steering, step.before + 0.5 * step.amplitude, step.onset).value_or(rough_half);
    step.rate = 0.8 * step.amplitude / std::max(t90 - t10, 1e-9);

    if (t90 - t10 > kSlowestRise) {
        notFound(fmt::format("the steering takes {:.2g} s from 10 to 90 %, expected at most {:.2g} s", t90 - t10,
                             kSlowestRise));
    }
    if (hold.to - hold.from < kShortestHold || hold.share < kHoldShare) {
        notFound(fmt::format("the steering is held for only {:.2g} s, expected at least {:.2g} s within {:.0f} %",
                             hold.to - hold.from, kShortestHold, 100 * kHoldBand));
    }
    return step;
}

// End of the hold, or of its part before the driver brakes or lifts off: that is another manoeuvre.
double pedalChange(const Log& log, const Step& step) {
    double end = step.hold_end;
    const auto brake = channelIfThere(log, "driver.brake"), throttle = channelIfThere(log, "driver.throttle");
    if (brake) end = std::min(end, firstCrossing(*brake, kRestingFoot, step.onset).value_or(end));
    if (throttle && at(*throttle, step.onset) > kRestingFoot) {
        end = std::min(end, firstCrossing(*throttle, kRestingFoot, step.onset).value_or(end));
    }
    return end;
}

// The answer of one channel, in the direction of the step and as increments over its value before.
struct Response {
    double steady;                  // at the end of the hold
    double drift;                   // change over the steady window as a share of steady
    double time90 = kUndefined;     // s after time zero
    double peak_time = kUndefined;  // s after time zero
    double overshoot = 0;           // (peak - steady) / steady
};

Response respond(const TimeSeries& measured, const Step& step, double half_width) {
    const TimeSeries clean = cleaned(measured, half_width);
    const double before = mean(measured, step.onset - 1, step.onset);
    const double sign = mean(measured, step.hold_end - 0.2, step.hold_end) < before ? -1 : 1;
    const double window = std::min(kSteadyWindow, (step.hold_end - step.half) / 3);
    const TimeSeries end = increments(part(measured, step.hold_end - window, step.hold_end), before, sign);

    Response response{};
    const double steady = mean(end, end.begin(), end.end());
    response.drift = fitLine(end.time, end.value).slope * window / steady;
    const TimeSeries answer = increments(clean, before, sign);
    if (const auto t = firstCrossing(answer, 0.9 * steady, step.onset, step.hold_end)) response.time90 = *t - step.half;
    const Instant peak = highest(answer, step.onset, step.hold_end);
    response.overshoot = std::max(0.0, peak.value / steady - 1);
    const double least = std::max(kLeastOvershoot, isNoisy(measured) ? 2 * noise(measured) / steady : 0);
    if (response.overshoot > least) response.peak_time = peak.time - step.half;
    response.steady = sign * steady;
    return response;
}

// Increment of a channel from before the step to the end of the hold.
double steadyIncrement(const TimeSeries& series, const Step& step) {
    const double window = std::min(kSteadyWindow, (step.hold_end - step.half) / 3);
    return mean(series, step.hold_end - window, step.hold_end) - mean(series, step.onset - 1, step.onset);
}

struct StepSteer {
    Step step;
    double speed;  // m/s
    Response yaw_rate, ay;
    double sideslip = kUndefined;  // rad, as in a left turn
    double roll = kUndefined;      // rad

    bool steady() const { return std::abs(yaw_rate.drift) <= kSteadyDrift && std::abs(ay.drift) <= kSteadyDrift; }
};

MetricTable<StepSteer> responseTable(Response StepSteer::*response, std::string_view what, std::string_view words,
                                     const Say& response_time, const Say& overshoot) {
    const auto name = [&](std::string_view metric) { return fmt::format("{}_{}", what, metric); };
    return {
        {{name("response_time"), titleOf(words, "response time"), "s",
          fmt::format("from half the steering input to 90 % of the steady {}", words), response_time},
         [response](const StepSteer& s) { return (s.*response).time90; }},
        {{name("peak_response_time"), titleOf(words, "peak response time"), "s",
          fmt::format("from half the steering input to the peak of the {}; undefined without overshoot", words)},
         [response](const StepSteer& s) { return (s.*response).peak_time; }},
        {{name("overshoot"), titleOf(words, "overshoot"), "-", fmt::format("(peak - steady) / steady {}", words),
          overshoot},
         [response](const StepSteer& s) { return (s.*response).overshoot; }},
    };
}

MetricTable<StepSteer> stepSteerTable() {
    MetricTable<StepSteer> lines =
        responseTable(&StepSteer::yaw_rate, "yaw_rate", "yaw rate", {1, "yaw rate responds within {} ms", 0, 1000},
                      {2, "overshoots by {} %", 0, 100});
    const auto add = [&](const MetricTable<StepSteer>& more) { lines.insert(lines.end(), more.begin(), more.end()); };
    add(responseTable(&StepSteer::ay, "ay", "lateral acceleration", {}, {}));
    add({
        {{"yaw_rate_gain", "Yaw rate, gain", "1/s", "steady yaw rate over steering-wheel angle"},
         [](const StepSteer& s) { return s.yaw_rate.steady / s.step.amplitude; }},
        {{"ay_gain", "Lateral acceleration, gain", "m/s2/rad", "steady lateral acceleration over steering-wheel angle"},
         [](const StepSteer& s) { return s.ay.steady / s.step.amplitude; }},
        {{"steady_sideslip", "Sideslip angle, steady", "deg",
          "sideslip angle at the end of the hold, with the sign of a left turn"},
         [](const StepSteer& s) { return kDegrees * s.sideslip; }},
        {{"tb", "TB value", "s deg", "peak response time of the yaw rate times steady sideslip"},
         [](const StepSteer& s) { return s.yaw_rate.peak_time * (kDegrees * s.sideslip); }},
        {{"roll_gradient", "Roll gradient", "deg/g", "steady roll angle over steady lateral acceleration"},
         [](const StepSteer& s) { return kDegrees * s.roll / (s.ay.steady / kGravity); }},
    });
    // Conditions of the test.
    add({
        {{"speed", "Speed", "m/s", "forward speed when the steering begins"},
         [](const StepSteer& s) { return s.speed; }},
        {{"steering_amplitude", "Steering-wheel step", "deg",
          "steady-state steering-wheel angle minus the initial angle"},
         [](const StepSteer& s) { return kDegrees * s.step.amplitude; }},
        {{"steering_rate", "Steering-wheel rate", "deg/s", "mean rate from 10 to 90 % of the step"},
         [](const StepSteer& s) { return kDegrees * std::abs(s.step.rate); }},
        {{"steady_ay", "Lateral acceleration, steady", "m/s2",
          "lateral acceleration at the end of the hold minus the initial value",
          Say{3, "settles at {} m/s2 of lateral acceleration", 2}},
         [](const StepSteer& s) { return s.ay.steady; }},
        {{"steady", "Steady state reached (1: yes, 0: no)", "-",
          fmt::format("1 when yaw rate and lateral acceleration change by at most {:.0f} % over the last part of the "
                      "hold; 0: the car has not settled, so its steady values are not final",
                      100 * kSteadyDrift)},
         [](const StepSteer& s) { return s.steady() ? 1.0 : 0.0; }},
        {{"steady_drift", "Yaw rate, drift over the hold", "-",
          "relative change of the yaw rate over the last part of the hold"},
         [](const StepSteer& s) { return s.yaw_rate.drift; }},
    });
    return lines;
}

StepSteer findStepSteer(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    Step step = findStep(cleaned(needed[0], kStepSteeringHalfWidth));
    step.hold_end = pedalChange(log, step);
    if (step.hold_end - step.half < kShortestHold) notFound("the driver brakes or lifts off during the step");
    const double v = mean(needed[1], step.onset - 0.1, step.onset);
    if (v < kSlowestStep) notFound(fmt::format("the car moves at only {:.2g} m/s when it is steered", v));
    StepSteer found{.step = step,
                    .speed = v,
                    .yaw_rate = respond(needed[2], step, kResponseHalfWidth),
                    .ay = respond(needed[3], step, kResponseHalfWidth)};
    if (const auto slip = sideslip(log)) found.sideslip = step.direction() * steadyIncrement(*slip, step);
    if (const auto roll = channelIfThere(log, "chassis.roll")) found.roll = steadyIncrement(*roll, step);
    return found;
}

}  // namespace

Manoeuvre stepSteer() {
    return {"step_steer", "a quick steering input, then held: response times, overshoot, gains (after ISO 7401)",
            [] { return definitions(stepSteerTable()); },
            [](const Log& log, const KnownCar&) { return values(stepSteerTable(), findStepSteer(log)); }};
}

}  // namespace tread
