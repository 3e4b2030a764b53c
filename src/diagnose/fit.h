// Models fitted to all recordings: which parameters are free, where the fit is best, and how much evidence it has.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "diagnose/bench.h"
#include "diagnose/disturbance.h"
#include "diagnose/noise.h"
#include "identify/gram.h"

namespace tread {

// What all models share: how noisy the rows are, and what disturbs the drives. Disturbances are divided by the noise.
struct Uncertainty {
    std::vector<RowNoise> noise;                // per drive
    std::vector<Disturbances> disturbing;       // per drive
    std::vector<Eigen::MatrixXd> directions;    // per drive: disturbances, then the speed at the start; over the noise
    std::vector<DriveGram> bare;                // per drive: products of the directions alone
    std::array<double, kDisturbances> sizes{};  // of the usual ones

    // Of each direction of a drive, with sizes other than those.
    Eigen::VectorXd sizesOf(std::size_t drive, const std::array<double, kDisturbances>& with) const;
};

// A linearisation made ready for fits: its nuisances' columns over the noise, and their products.
struct Ground {
    Linearised about;
    std::vector<Eigen::Index> nuisances;  // those that matter
    std::vector<Eigen::MatrixXd> columns;
    std::vector<DriveGram> grams;
};
Ground ground(Linearised about, const std::vector<Eigen::Index>& nuisances, const Uncertainty& uncertainty);

inline constexpr double kKnobStep = 0.3;  // units, of the differences of effects: their typical sizes are large

struct Fit {
    std::vector<Eigen::Index> free;  // nuisances, then knobs
    std::vector<Eigen::Index> knobs;
    Deviation at;
    Rows rows;
    std::vector<Eigen::MatrixXd> columns;  // per drive: of `free`, over the noise
    std::vector<DriveGram> grams;          // per drive: columns of `free`, then the residual
    double log_evidence = 0;
    double gained = 0;           // nats of misfit and prior, from the start of the fit
    Eigen::MatrixXd covariance;  // of `free`
    bool converged = false;
};

// Residual of a drive over its noise.
Eigen::VectorXd residual(const Bench& bench, const Uncertainty& uncertainty, const Rows& rows, std::size_t drive);

// Sum of squares of what is off in a drive, over its noise, in the metric of noise and usual disturbances.
double squaresOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::VectorXd& off);

// Products of all drives, columns of `free` and then the residual.
Gram total(const std::vector<DriveGram>& grams, const Uncertainty& uncertainty,
           const std::array<double, kDisturbances>& sizes);

// Evidence of a fit (Laplace) with disturbances of other sizes.
double logEvidenceOf(const Fit& fit, const Uncertainty& uncertainty, const std::array<double, kDisturbances>& sizes);

// Gauss-Newton with bounds and damping (Levenberg) from a point. The columns are those of the ground at first; every
// point that is driven corrects them (Broyden), and the knobs' are taken anew once the fit has settled. Nothing when
// the model cannot be driven at the start.
std::optional<Fit> fitted(Bench& bench, const Uncertainty& uncertainty, const Ground& ground,
                          const std::vector<Eigen::Index>& knobs, const Deviation& start);

}  // namespace tread
