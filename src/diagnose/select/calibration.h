// The nominal car with its parameters where the recordings want them, within their tolerances: the car about which
// effects are sought.
#pragma once

#include "diagnose/model/problem.h"
#include "diagnose/select/fit.h"

namespace tread::diagnose::select {

using model::Parameter;
using model::Problem;

struct Calibration {
    const Problem& problem;
    Rows nominal;                         // what the nominal car does
    Rows allowed;                         // standard deviation of that by its tolerances
    Uncertainty uncertainty;              // about the calibrated car
    Linearisation about;                  // the calibrated car: nuisances and all knobs
    Fit fit;                              // that brought it there
    std::vector<DriveProducts> products;  // of the nuisances, all knobs and the residual about it

    Drives drives() const { return problem.drives; }
    // A parameter as a mixture of the relevant nuisances; empty when it is none.
    std::vector<model::Share> asNuisances(const Parameter& parameter) const;
};

// Throws SimulationError when the nominal car cannot be driven in the recordings.
Calibration calibrate(const Problem& problem, model::NominalCar nominal, const Progress& progress);

// The nominal car in place of the calibrated one: nothing is fitted.
Calibration uncalibrated(const Problem& problem, model::NominalCar nominal, const Progress& progress);

// Sizes of the disturbances under which the recordings are most likely, whatever mixture of nuisances and effects is
// true; near the usual ones unless the recordings say otherwise. `products`: of all of these and the residual (D26).
Sizes disturbanceSizes(Drives drives, const Uncertainty& uncertainty, const std::vector<DriveProducts>& products);

}  // namespace tread::diagnose::select
