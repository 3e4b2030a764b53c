#include "diagnose/model/gap.h"

#include <cmath>

#include "inference/whitening.h"

namespace tread::diagnose::model {

namespace {

// Variance of each row of a drive by disturbances of the usual sizes, in units of that of its noise.
Eigen::ArrayXd disturbed(const Uncertainty& uncertainty, std::size_t drive) {
    return usualDisturbances(uncertainty, drive).rowwise().squaredNorm();
}

}  // namespace

Eigen::MatrixXd usualDisturbances(const Uncertainty& uncertainty, std::size_t drive) {
    Sizes usual{};
    for (const Disturbed kind : kDisturbedKinds) usual[placeOf(kind)] = 1;
    return uncertainty.directions[drive] * uncertainty.sizesOf(drive, usual).asDiagonal();
}

Eigen::VectorXd floorOf(const Uncertainty& uncertainty, std::size_t drive) {
    return uncertainty.noise[drive].deviation.cwiseProduct((disturbed(uncertainty, drive) + 1).sqrt().matrix());
}

Eigen::VectorXd filteredFloorOf(const Uncertainty& uncertainty, std::size_t drive) {
    return (disturbed(uncertainty, drive) + inference::kLeftByBinomial).sqrt();
}

Uncertainty weightedAsTheGap(const Uncertainty& uncertainty, Drives drives) {
    Uncertainty weighted{.until = uncertainty.until,
                         .noise = uncertainty.noise,
                         .disturbing = std::vector<Disturbances>(drives.size()),
                         .directions = {},
                         .bare = {}};
    weighted.sizes.fill(1);
    for (std::size_t d = 0; d < drives.size(); ++d) {
        weighted.noise[d].deviation = floorOf(uncertainty, d);
        const Eigen::MatrixXd by_start_speed =
            weighted.noise[d].over(uncertainty.disturbing[d].by_start_speed) * disturbanceScale(drives[d]);
        weighted.bare.push_back(inference::productsOf(Eigen::MatrixXd(by_start_speed.rows(), 0), by_start_speed));
        weighted.directions.push_back(by_start_speed);
    }
    return weighted;
}

Eigen::VectorXd gapOf(Drives drives, const Uncertainty& uncertainty, const Eigen::VectorXd& rows, std::size_t drive) {
    return (drives[drive].measured - rows).cwiseQuotient(floorOf(uncertainty, drive));
}

double squaredGap(Drives drives, const Uncertainty& uncertainty, const Eigen::VectorXd& rows, std::size_t drive) {
    return gapOf(drives, uncertainty, rows, drive).squaredNorm();
}

std::vector<double> squaredGaps(Drives drives, const Uncertainty& uncertainty, const Rows& rows) {
    std::vector<double> gaps;
    for (std::size_t d = 0; d < rows.size(); ++d) gaps.push_back(squaredGap(drives, uncertainty, rows[d], d));
    return gaps;
}

double comparedRows(const Uncertainty& uncertainty, std::size_t drive) {
    return static_cast<double>(uncertainty.noise[drive].deviation.array().isFinite().count());
}

double levelOf(Drives drives, const Uncertainty& uncertainty, const Rows& rows) {
    double squares = 0, count = 0;
    for (std::size_t d = 0; d < rows.size(); ++d) {
        squares += squaredGap(drives, uncertainty, rows[d], d);
        count += comparedRows(uncertainty, d);
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

}  // namespace tread::diagnose::model
