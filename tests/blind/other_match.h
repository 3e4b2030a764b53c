// The other car made to drive like one of tread's, as far as its structure allows.
#pragma once

#include "blind/gauges.h"
#include "blind/measure.h"
#include "blind/other_truth.h"
#include "tread/vehicle.h"

namespace other_car {

// The drives of a blind check by a car of tread in the gear of the other one, without noise and disturbances.
tread::Log drivenByTread(const tread::VehicleParams& vehicle, const tread::Drive& drive);

// Readings of one channel in means of 50 ms, and the deviation of the instrument's noise in these.
std::vector<double> means(const tread::Log& log, std::string_view channel);
double noiseOfMeans(const tread::Gauge& gauge);

// `begin` with its numbers moved to where the drives that are not held out come nearest to those of tread's car:
// Gauss-Newton steps on all readings, held near the beginning by a prior on each number.
Truth matched(const Truth& begin, const tread::VehicleParams& vehicle);

}  // namespace other_car
