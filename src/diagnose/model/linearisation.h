// A linearisation prepared for fits: whitened sensitivities to the relevant nuisances and to knobs, and their products.
#pragma once

#include "diagnose/model/sensitivities.h"
#include "diagnose/model/uncertainty.h"

namespace tread::diagnose::model {

struct Linearisation {
    Sensitivities about;
    std::vector<Eigen::Index> nuisances;   // the relevant ones: indices of parameters
    std::vector<Eigen::Index> parameters;  // these, then knobs
    std::vector<Eigen::MatrixXd> columns;  // per drive: rows x parameters, whitened
    std::vector<DriveProducts> products;   // per drive, of these columns
    // Small errors of the model along the knobs, which are known by the columns of these alone (D16b): indices of
    // parameters. Only fits about the calibrated car have them.
    std::vector<Eigen::Index> imperfections = {};
};
Linearisation linearisation(Sensitivities about, const std::vector<Eigen::Index>& nuisances,
                            const std::vector<Eigen::Index>& knobs, const Uncertainty& uncertainty, int threads);

// The same parameters about another point, where the knobs have the columns of `before`.
Linearisation relinearised(const Linearisation& before, Sensitivities about, const Uncertainty& uncertainty,
                           int threads);

// Nuisances that can change an answer: those with more than a negligible Fisher information.
std::vector<Eigen::Index> relevantNuisances(const std::vector<Eigen::Index>& nuisances, const Sensitivities& about,
                                            const Uncertainty& uncertainty, int threads);

// Sensitivities about another point: those to the nuisances are computed again in the drives where they matter, all
// others are taken from `before`. `rows`: of the model at the point; null if they are not known.
Sensitivities nuisancesAt(
    const Replays& replays, Drives drives, const Deviation& at, const Rows* rows, const Linearisation& before,
    const Uncertainty& uncertainty, const std::function<void(double)>& progress = [](double) {});

// Whitened rows of one drive: the columns of these parameters about a point, then the residual that `rows` leave.
Eigen::MatrixXd columnsAndResidual(Drives drives, const Uncertainty& uncertainty, const Sensitivities& about,
                                   const std::vector<Eigen::Index>& parameters, const Rows& rows, std::size_t drive);

// Products of all parameters of a linearisation and the residual of its point.
std::vector<DriveProducts> productsWithResidual(Drives drives, const Linearisation& linearisation,
                                                const Uncertainty& uncertainty);

}  // namespace tread::diagnose::model
