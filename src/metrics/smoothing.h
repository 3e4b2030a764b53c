// What lies beneath measurement noise: how much of it there is, and the series without it.
#pragma once

#include "metrics/series.h"

namespace tread {

// Standard deviation of white measurement noise, from fourth differences: nearly blind to the signal itself.
double noise(const TimeSeries& series);

// Local parabola over +-half_width around each sample: its value, and its slope. Fewer than five samples in reach: the
// series itself, and its plain differences.
TimeSeries smoothed(const TimeSeries& series, double half_width);
TimeSeries derivative(const TimeSeries& series, double half_width);

// Mean over +-half_width: rounds corners, but never goes beyond the values around.
TimeSeries averaged(const TimeSeries& series, double half_width);

// Smoothed when there is noise to speak of; a simulated log stays as it is, corners and all.
bool isNoisy(const TimeSeries& series);
TimeSeries cleaned(const TimeSeries& series, double half_width);
TimeSeries cleanDerivative(const TimeSeries& series, double half_width);

}  // namespace tread
