// Models fitted to all recordings: which parameters are free, where the posterior is largest, and how much evidence it
// has.
#pragma once

#include <optional>
#include <vector>

#include "diagnose/model/linearisation.h"
#include "inference/laplace.h"

namespace tread::diagnose::select {

using model::Deviation;
using model::DriveProducts;
using model::Drives;
using model::Linearisation;
using model::Replays;
using model::Rows;
using model::Sizes;
using model::Uncertainty;

struct Fit {
    std::vector<Eigen::Index> free;  // nuisances, then knobs
    std::vector<Eigen::Index> knobs;
    Deviation at;
    Rows rows;
    std::vector<Eigen::MatrixXd> columns;  // per drive: of `free`, over the noise
    std::vector<DriveProducts> products;   // per drive: columns of `free`, then the residual
    double log_evidence = 0;
    double gained = 0;           // nats of misfit and prior, from the start of the fit
    Eigen::MatrixXd covariance;  // of `free`
    bool converged = false;

    Eigen::Index nuisances() const { return std::ssize(free) - std::ssize(knobs); }
};

// The log posterior about the point of a fit, with disturbances of other sizes.
inference::QuadraticModel quadraticAt(const Fit& fit, const Uncertainty& uncertainty, const Sizes& sizes);

// Evidence of a fit with disturbances of other sizes: the parameters may move on as far as these ask.
double logEvidence(const Fit& fit, const Uncertainty& uncertainty, const Sizes& sizes);

// Gauss-Newton with bounds and damping (Levenberg) from a point. The columns are those of the linearisation at first;
// every point that is driven corrects them (C. G. Broyden, A class of methods for solving nonlinear simultaneous
// equations, 1965), and those of the knobs are taken anew once the fit has settled. Nothing when the model cannot be
// driven at the start.
std::optional<Fit> fitted(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& linearisation, const std::vector<Eigen::Index>& knobs,
                          const Deviation& start);

}  // namespace tread::diagnose::select
