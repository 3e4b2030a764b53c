// The other car made to drive like one of tread's, as far as its structure allows.
#pragma once

#include <Eigen/Dense>
#include <string_view>
#include <vector>

#include "blind/drives.h"
#include "blind/gauges.h"
#include "blind/other_truth.h"
#include "log/log.h"
#include "tread/vehicle.h"

namespace other_car {

// The drives of a blind check by a car of tread in the gear of the other one, without noise and disturbances.
tread::Log drivenByTread(const tread::VehicleParams& vehicle, const tread::Drive& drive);

// Readings of one channel in means of 50 ms, and the deviation of the instrument's noise in these.
std::vector<double> means(const tread::Log& log, std::string_view channel);
double noiseOfMeans(const tread::Gauge& gauge);

// The plain car of the other simulator as near to a car of tread as it comes on the drives that are not held out: least
// squares over all readings, with a prior on each number about its beginning, by Gauss-Newton steps.
struct Matching {
    Truth begin;
    Eigen::VectorXd wanted;   // readings over their noise
    Eigen::VectorXd at;       // of the free numbers, in deviations of their priors
    Eigen::MatrixXd columns;  // of the readings by these, near there
};
Matching matchingOf(const Truth& begin, const tread::VehicleParams& vehicle);
Truth plainCar(const Matching& matching);

// The same for a car of another structure, from there on.
Truth matched(const Matching& matching, const Structure& structure);

}  // namespace other_car
