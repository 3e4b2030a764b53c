// Fit of a model to all recordings: its free parameters and the sizes of its remainder, the point of largest posterior
// density, and the evidence.
#pragma once

#include <optional>
#include <vector>

#include "base/math/random.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/model/imperfection.h"
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

// Whether the prior of an effect's size takes part in a fit. It ranks effects; the size of an effect that is named is
// estimated without it.
enum class SizePrior { typical, none };

// Whether the sizes of the remainder are estimated with a fit, or stay the usual ones, without imperfections, so that
// the parameters close as much of the gap as they can.
enum class Remainder { estimated, usual };

struct Fit {
    std::vector<Eigen::Index> free;  // nuisances, imperfections, then knobs: indices of parameters
    std::vector<Eigen::Index> knobs, imperfections;
    Deviation at;
    Rows rows;                             // of the model, with its imperfections
    Rows of_car;                           // without
    std::vector<Eigen::MatrixXd> columns;  // per drive: columns of `free`, whitened
    std::vector<DriveProducts> products;   // per drive: columns of `free`, then the residual
    Sizes sizes{};                         // of the remainder
    model::Imperfection imperfection{};    // sizes of the imperfections
    double log_evidence = 0;
    double gained = 0;           // nats by which the fit lowered the negative log posterior
    Eigen::MatrixXd covariance;  // posterior covariance of `free`, in units; bounds are not taken into account
    SizePrior prior = SizePrior::typical;
    bool converged = false;

    Eigen::Index nuisances() const { return std::ssize(free) - std::ssize(knobs); }  // imperfections included
    Eigen::Index numbers() const { return nuisances() - std::ssize(imperfections); }
};

// Where a fit starts. Without sizes of the remainder, from those of the uncertainty.
struct Start {
    Deviation at;
    std::optional<Sizes> sizes = {};
    model::Imperfection imperfection = model::usualImperfection();
    // The end of another fit. Its columns of the knobs are then computed anew where they differ from those of the
    // calibrated car. At other points, such as trials where the car slides, they may be no better than those.
    bool is_end = false;
    // ln Z that a fit must reach to matter. One that its linear model does not lead there ends early, not converged.
    double least = -kInfinity;
};

// Where a fit ended, so that another one goes on from there.
inline Start endOf(const Fit& fit) {
    return {fit.at, fit.sizes, fit.imperfection, true};
}

// The same with the nuisances at their nominal values, which may hold what they did in place of effects. A fit that
// starts there may find another maximum.
Start anew(const Fit& fit);

// A random point from the Gaussian posterior of a fit, cut at the bounds of the parameters.
Deviation drawn(const Replays& replays, const Fit& fit, Random& random);

// The fit with imperfections of their usual sizes; its rows stay.
Fit withUsualImperfections(Fit fit, const Replays& replays);

// The i-th free parameter of a fit, as the number that it moves first.
answer::NuisanceEstimate numberOf(const Fit& fit, const Replays& replays, Eigen::Index i);

// Products of the free parameters of a fit, then of further columns of a drive.
DriveProducts productsBeside(const Fit& fit, const Uncertainty& uncertainty, std::size_t drive,
                             const Eigen::MatrixXd& further);

// Quadratic model of the log posterior about the point of a fit.
inference::QuadraticModel quadraticAt(const Fit& fit, const Uncertainty& uncertainty);

// Fits nuisances and `knobs` from `start` by a damped Gauss-Newton method (Levenberg) within bounds, in turn with the
// sizes of the remainder. The columns are at first those of the linearisation.
// Each replay updates them (C. G. Broyden, A class of methods for solving nonlinear simultaneous equations, 1965), and
// those of the knobs are computed again once the fit has settled, or is about to be given up. Nothing when the model
// cannot be driven at the start.
std::optional<Fit> fitted(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& linearisation, const std::vector<Eigen::Index>& knobs,
                          const Start& start, SizePrior prior = SizePrior::typical,
                          Remainder remainder = Remainder::estimated);

// A fit with all its columns taken about its point: `here` is linearised there. Those of the fit have learnt from its
// steps, the short ones of which teach more of the roughness of the response than of its slope.
Fit withColumnsOfItsPoint(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& here, const Fit& fit);

}  // namespace tread::diagnose::select
