// A linearisation made ready for fits: the sensitivities to the relevant nuisance parameters over the noise, and their
// products.
#pragma once

#include "diagnose/model/sensitivities.h"
#include "diagnose/model/uncertainty.h"

namespace tread::diagnose::model {

struct Linearisation {
    Sensitivities about;
    std::vector<Eigen::Index> nuisances;   // those that are relevant: indices of parameters
    std::vector<Eigen::MatrixXd> columns;  // per drive: rows x nuisances, over the noise
    std::vector<DriveProducts> products;   // per drive, of those
};
Linearisation linearisation(Sensitivities about, const std::vector<Eigen::Index>& nuisances,
                            const Uncertainty& uncertainty);

// Those of the nuisances that make a difference to any answer.
std::vector<Eigen::Index> relevantNuisances(const std::vector<Eigen::Index>& nuisances, const Sensitivities& about,
                                            const Uncertainty& uncertainty);

// The drives about another point: sensitivities to the nuisances anew where they make a difference, all else as before.
Sensitivities nuisancesAt(const Replays& replays, Drives drives, const Deviation& at, const Linearisation& before,
                          const Uncertainty& uncertainty, const std::function<void(double)>& progress);

// Of one drive, over the noise: the columns of these parameters about a point, then the residual that the rows leave.
Eigen::MatrixXd columnsAndResidual(Drives drives, const Uncertainty& uncertainty, const Sensitivities& about,
                                   const std::vector<Eigen::Index>& parameters, const Rows& rows, std::size_t drive);

// Products of the nuisances, these parameters and the residual, all about the point of the linearisation.
std::vector<DriveProducts> productsWith(const std::vector<Eigen::Index>& parameters, Drives drives,
                                        const Linearisation& linearisation, const Uncertainty& uncertainty);

}  // namespace tread::diagnose::model
