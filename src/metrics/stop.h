// A braking to standstill in a log: when, from what speed, over what way.
#pragma once

#include <optional>
#include <string_view>

#include "log/log.h"
#include "metrics/series.h"

namespace tread {

// From here the last metre is extrapolated, out of the sensor's noise.
inline constexpr double kNearlyStopped = 0.2;  // m/s

struct Stop {
    double start;          // s, brake actuation
    double initial_speed;  // m/s
    double end;            // s, standstill
    double distance;       // m
    double duration() const { return end - start; }
};

// Throws MetricError when no car is braked to standstill.
Stop findStop(const Log& log);

// Throws MetricError when the car turns as it is braked.
void expectNoTurn(const Log& log, const Stop& stop);

// The end of fully developed braking, s: the speed is 10 % of the initial speed (UN R13-H). What follows is coming to
// rest: the force of the brakes ends with the motion and the body swings back on its suspension, so that the
// acceleration there, a jerk through zero, says nothing of the brakes. The standstill without it.
double developedEnd(const TimeSeries& v, const Stop& stop);
// The same of a log; nothing when no car is braked to standstill in it.
std::optional<double> developedEnd(const Log& log);

// Mean fully developed deceleration: the average over distance between 80 and 10 % of the initial speed.
double meanFullyDeveloped(const TimeSeries& v, const Stop& stop);

// Largest distance of the path from the line along which the car went when the brake was applied; left is positive.
double lateralDeviation(const Log& log, const Stop& stop);

}  // namespace tread
