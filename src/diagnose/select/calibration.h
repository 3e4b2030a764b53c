// The calibrated car: the nominal car with its nuisance parameters fitted to the recordings, within their tolerances.
// Effects are searched for about this car.
#pragma once

#include <memory>

#include "diagnose/model/problem.h"
#include "diagnose/select/fit.h"
#include "diagnose/select/together.h"

namespace tread::diagnose::select {

using model::Parameter;
using model::Problem;
using SharedLinearisation = std::shared_ptr<const Linearisation>;

// A car within its tolerances that leaves the smallest squared gap. A fit, which is likelier, may leave a larger one
// where its remainder is large.
struct Closest {
    Deviation at;
    Rows rows;
};

struct Calibration {
    const Problem& problem;
    Rows nominal;                         // rows of the nominal car
    Rows allowed;                         // standard deviation of these due to the tolerances
    Uncertainty uncertainty;              // about the calibrated car
    Linearisation about;                  // about the calibrated car: nuisances and all knobs
    Fit fit;                              // of the nuisances; its point is the calibrated car
    std::vector<DriveProducts> products;  // of the nuisances, all knobs and the residual, about the calibrated car
    Closest closest = {};
    Uncertainty of_gap = {};  // that weights rows as the squared gap does
    // Where an effect keeps car and model together for longer than the calibrated car: that car with the effect. Drives
    // then end where this one slides apart, and are linearised about it.
    std::optional<Together> together = {};
    // Share of the motion of the car before that the model does not predict: an error of its structure, and so of every
    // signature. 0 without drives of that car.
    double structure_error = 0;

    Drives drives() const { return problem.drives; }
    // A parameter as a mixture of the relevant nuisances; empty when it is not one.
    std::vector<model::Share> asNuisances(const Parameter& parameter) const;
};

// The linearisation about another point: nuisances anew, knobs as about the calibrated car.
SharedLinearisation linearisedAt(const Calibration& car, const Fit& fit);

// The replays of cars whose numbers stay within their tolerances, and a point with some numbers within their bounds.
Replays withinTolerances(const Calibration& car);
Deviation clamped(Deviation at, const std::vector<Eigen::Index>& some, const std::vector<Parameter>& parameters);

// The closest car, found from a point. These knobs take part, free of the prior of their sizes; others stay. Nothing
// when the car cannot be driven there.
std::optional<Closest> closestTo(const Calibration& car, const Deviation& at, const std::vector<Eigen::Index>& knobs);

// Throws SimulationError when the nominal car cannot be driven in the recordings.
Calibration calibrate(const Problem& problem, model::NominalCar nominal, const Progress& progress);

// The nominal car in place of the calibrated one, with nothing fitted.
Calibration uncalibrated(const Problem& problem, model::NominalCar nominal, const Progress& progress);

// Sizes of the remainder when all nuisances and all effects are free. `products`: of all these parameters and the
// residual (D26).
Sizes sizesWithAllFree(const Problem& problem, const Uncertainty& uncertainty,
                       const std::vector<DriveProducts>& products);

}  // namespace tread::diagnose::select
