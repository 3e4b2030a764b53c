// Noise of the rows and disturbances of the drives; the same in all fits.
#pragma once

#include "diagnose/model/disturbance.h"
#include "diagnose/model/noise.h"
#include "inference/normal_equations.h"

namespace tread::diagnose::model {

using inference::DriveProducts;
using inference::NormalEquations;

struct Uncertainty {
    std::vector<double> until;                // s, per drive: later rows carry no information about the car
    std::vector<RowNoise> noise;              // per drive
    std::vector<Disturbances> disturbing;     // per drive
    std::vector<Eigen::MatrixXd> directions;  // per drive, whitened: columns of disturbances, then start speed
    std::vector<DriveProducts> bare;          // per drive: products of the directions alone
    Sizes sizes{};                            // of the disturbances with all parameters free; fits start from them

    // Standard deviation of each direction of a drive, for disturbances of the given sizes.
    Eigen::VectorXd sizesOf(std::size_t drive, const Sizes& with) const;
};

// Noise and disturbances about a point at which the model has `rows`. `until`: ends of the drives as known so far, s; a
// drive ends earlier where car and model slide apart. Disturbances have the usual sizes (D12). They are those of
// `known`, about a point nearby, or computed about this one, at least in the drives that are `renewed`.
Uncertainty uncertaintyAt(const Replays& replays, Drives drives, const Deviation& at, const Rows& rows,
                          std::vector<double> until, const Uncertainty* known = nullptr,
                          const std::vector<bool>& renewed = {}, Resolution resolution = Resolution::fine);
std::vector<double> endsOf(Drives drives);

// Whitened residual of a drive.
Eigen::VectorXd residual(Drives drives, const Uncertainty& uncertainty, const Rows& rows, std::size_t drive);

// Products of the given whitened columns of a drive with each other and with its directions.
DriveProducts productsOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::MatrixXd& columns);

// Squared residual of a drive after marginalising disturbances of these sizes. `off`: whitened residual.
double squaresOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::VectorXd& off, const Sizes& sizes);

// Normal equations of one drive, of each drive, and of all drives together, with disturbances of these sizes.
NormalEquations normalEquations(const Uncertainty& uncertainty, std::size_t drive, const DriveProducts& products,
                                const Sizes& sizes);
std::vector<NormalEquations> equationsOfEach(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products,
                                             const Sizes& sizes, int threads);
NormalEquations normalEquations(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products,
                                const Sizes& sizes, int threads);

// Birge ratio, at least 1: root of the squared residual over that expected of noise (R. T. Birge, The calculation of
// errors by the method of least squares, Physical Review 40, 1932). A model whose structure differs from that of the
// car leaves more than noise, and its conclusions are less certain by this factor (D27).
double birgeRatio(Drives drives, const Uncertainty& uncertainty, const Rows& rows, const Sizes& sizes);

}  // namespace tread::diagnose::model
