#include "diagnose/model/gap.h"

#include <cmath>

namespace tread::diagnose::model {

Eigen::VectorXd floorOf(const Uncertainty& uncertainty, std::size_t drive) {
    Sizes usual{};
    for (const Disturbed kind : kDisturbedKinds) usual[placeOf(kind)] = 1;
    const Eigen::VectorXd sizes = uncertainty.sizesOf(drive, usual);
    const Eigen::VectorXd disturbed = (uncertainty.directions[drive] * sizes.asDiagonal()).rowwise().squaredNorm();
    return uncertainty.noise[drive].deviation.cwiseProduct((disturbed.array() + 1).sqrt().matrix());
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
