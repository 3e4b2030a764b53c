// What all models of the drives share: how noisy the rows are, and what disturbs the drives.
#pragma once

#include "diagnose/model/disturbance.h"
#include "diagnose/model/noise.h"
#include "inference/normal_equations.h"

namespace tread::diagnose::model {

using inference::DriveProducts;
using inference::NormalEquations;

struct Uncertainty {
    std::vector<double> until;                // s, per drive: what comes later says nothing about the car
    std::vector<RowNoise> noise;              // per drive
    std::vector<Disturbances> disturbing;     // per drive
    std::vector<Eigen::MatrixXd> directions;  // per drive: disturbances, then the speed at the start; over the noise
    std::vector<DriveProducts> bare;          // per drive: products of the directions alone
    Sizes sizes{};                            // of the disturbances

    // Standard deviation of each direction of a drive, with disturbances of other sizes.
    Eigen::VectorXd sizesOf(std::size_t drive, const Sizes& with) const;
};

// Of the drives about a point, where the model does `rows`; with disturbances of the usual sizes. `until` as the drives
// or an earlier look have it: a drive ends earlier where the car and the model slide apart (D12).
Uncertainty uncertaintyAt(const Replays& replays, Drives drives, const Deviation& at, const Rows& rows,
                          std::vector<double> until);
std::vector<double> endsOf(Drives drives);

// Residual of a drive over its noise.
Eigen::VectorXd residual(Drives drives, const Uncertainty& uncertainty, const Rows& rows, std::size_t drive);

// Products of further columns of a drive, over the noise, in place of any others.
DriveProducts productsOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::MatrixXd& columns);

// Sum of squares of what is off in a drive, over its noise, once the disturbances are marginalised.
double squaresOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::VectorXd& off);

// Normal equations of one drive, and of all drives, with disturbances of these sizes.
NormalEquations normalEquations(const Uncertainty& uncertainty, std::size_t drive, const DriveProducts& products,
                                const Sizes& sizes);
NormalEquations normalEquations(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products,
                                const Sizes& sizes);

// The root of Birge's ratio (R. T. Birge, The calculation of errors by the method of least squares, Physical Review 40,
// 1932), not below 1: how many times the noise the rows of a model leave. A model whose structure is not that of the
// car leaves more, and what it says of anything is that much less certain (D27).
double birgeRatio(Drives drives, const Uncertainty& uncertainty, const Rows& rows);

}  // namespace tread::diagnose::model
