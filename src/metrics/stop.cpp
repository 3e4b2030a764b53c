#include "metrics/stop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kOnsetShare = 0.001;  // of the largest pedal: where actuation starts ...
constexpr double kOnsetNoise = 5;      // ... or in standard deviations of its noise, so that noise is no actuation
constexpr double kSlowestStart = 2.0;  // m/s
constexpr double kLargestTurn = 0.5;   // m/s2: more is braking in a turn
// Of the initial speed: between them the deceleration counts as fully developed (UN R13-H, MFDD).
constexpr double kDevelopedFrom = 0.8, kDevelopedTo = 0.1;

double brakeOnset(const TimeSeries& brake) {
    const double most = *std::max_element(brake.value.begin(), brake.value.end());
    if (most < kRestingFoot) notFound("the brake is never applied");
    // The application that leads to the stop begins where the pedal last left zero before its largest value.
    const double level = std::max(kOnsetShare * most, kOnsetNoise * noise(brake));
    const double peak = highest(brake, brake.begin(), brake.end()).time;
    if (brake.value.front() > level && !firstCrossing(brake, level, brake.begin(), peak)) return brake.begin();
    return lastCrossing(brake, level, brake.begin(), peak).value_or(brake.begin());
}

}  // namespace

Stop findStop(const Log& log) {
    const TimeSeries brake = channels(log, {"driver.brake", "chassis.vx"}).front();
    const TimeSeries v = cleaned(speed(log), kSpeedHalfWidth);
    Stop stop{};
    stop.start = brakeOnset(brake);
    stop.initial_speed = at(v, stop.start);
    if (stop.initial_speed < kSlowestStart) {
        notFound(fmt::format("the car moves at only {:.2g} m/s when it is braked", stop.initial_speed));
    }
    const auto nearly = firstCrossing(v, kNearlyStopped, stop.start);
    if (!nearly) {
        const double least = *std::min_element(v.value.begin(), v.value.end());
        notFound(fmt::format("the car is braked from {:.3g} m/s but does not stop (slowest {:.3g} m/s)",
                             stop.initial_speed, least));
    }
    // Deceleration over the last stretch before; the speed sensor's noise and the car's rocking come after.
    const double before = firstCrossing(v, 0.1 * stop.initial_speed + kNearlyStopped, stop.start).value_or(stop.start);
    const double deceleration = (at(v, before) - kNearlyStopped) / std::max(*nearly - before, 1e-9);
    stop.end = *nearly + kNearlyStopped / deceleration;
    stop.distance = integral(v, stop.start, *nearly) + 0.5 * kNearlyStopped * kNearlyStopped / deceleration;
    return stop;
}

void expectNoTurn(const Log& log, const Stop& stop) {
    if (const auto yaw_rate = channelIfThere(log, "chassis.yaw_rate")) {
        const double turn = mean(*yaw_rate, stop.start - 0.2, stop.start) * stop.initial_speed;
        if (std::abs(turn) > kLargestTurn) {
            notFound(fmt::format("the car is in a turn of {:.2g} m/s2 when it is braked", std::abs(turn)));
        }
    }
}

double developedEnd(const TimeSeries& v, const Stop& stop) {
    return firstCrossing(v, kDevelopedTo * stop.initial_speed, stop.start).value_or(stop.end);
}

std::optional<double> developedEnd(const Log& log) {
    try {
        return developedEnd(cleaned(speed(log), kSpeedHalfWidth), findStop(log));
    } catch (const NotInLog&) {
        return {};
    }
}

double meanFullyDeveloped(const TimeSeries& v, const Stop& stop) {
    const double vb = kDevelopedFrom * stop.initial_speed, ve = kDevelopedTo * stop.initial_speed;
    const auto tb = firstCrossing(v, vb, stop.start), te = firstCrossing(v, ve, stop.start);
    if (!tb || !te) return kUndefined;
    return (vb * vb - ve * ve) / (2 * integral(v, *tb, *te));
}

double lateralDeviation(const Log& log, const Stop& stop) {
    const auto x = channelIfThere(log, "chassis.x"), y = channelIfThere(log, "chassis.y");
    const auto yaw = channelIfThere(log, "chassis.yaw");
    if (!x || !y || !yaw) return kUndefined;
    const double heading = at(*yaw, stop.start), x0 = at(*x, stop.start), y0 = at(*y, stop.start);
    TimeSeries away = *x;
    for (std::size_t i = 0; i < away.size(); ++i) {
        away.value[i] = (y->value[i] - y0) * std::cos(heading) - (x->value[i] - x0) * std::sin(heading);
    }
    const TimeSeries during = part(away, stop.start, stop.end);
    return *std::max_element(during.value.begin(), during.value.end(),
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
}

}  // namespace tread
