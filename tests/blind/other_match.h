// Fits the other car to a car of tread, as far as its structure allows.
#pragma once

#include <Eigen/Dense>
#include <string_view>
#include <vector>

#include "blind/drives/drives.h"
#include "blind/other_truth.h"
#include "blind/world/instruments.h"
#include "log/log.h"
#include "tread/vehicle.h"

namespace other_car {

// A drive by a car of tread in the gear of the other car, without noise and disturbances.
tread::Log drivenByTread(const tread::VehicleParams& vehicle, const tread::blind::drives::Drive& drive);

// Means of a channel over 50 ms, and the standard deviation of their noise.
std::vector<double> means(const tread::Log& log, std::string_view channel);
double noiseOfMeans(const tread::blind::world::InstrumentSheet& sheet);

// Fit of the plain car (without structural choices) to a car of tread on the training drives: least squares over all
// readings by Gauss-Newton steps. Only numbers that the two models define differently are fitted, each with a Gaussian
// prior about its initial value.
struct Matching {
    Truth begin;
    Eigen::VectorXd wanted;   // readings of tread's car over their noise
    Eigen::VectorXd at;       // free numbers, in standard deviations of their priors
    Eigen::MatrixXd columns;  // derivatives of the readings with respect to `at`
};
Matching matchingOf(const Truth& begin, const tread::VehicleParams& vehicle);
Truth plainCar(const Matching& matching);

// The fit for a car of another structure, starting from the plain one.
Truth matched(const Matching& matching, const Structure& structure);

}  // namespace other_car
