#include "inference/heterogeneity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "inference/chi_squared.h"

namespace tread::inference {
namespace {

constexpr double kLeastInformed = 1e-12;  // least squared value over its variance, instead of 0

}  // namespace

Heterogeneity heterogeneity(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient, double squared_value,
                            double least_share) {
    const double all = information.diagonal().sum();
    std::vector<Eigen::Index> informed;
    for (Eigen::Index d = 0; d < gradient.size(); ++d)
        if (information(d, d) > least_share * all) informed.push_back(d);
    if (informed.size() < 2) return {};
    // Twice the log likelihood gained by one value per drive, and by one value for all drives.
    const Eigen::MatrixXd each = information(informed, informed);
    const Eigen::VectorXd slope = gradient(informed);
    const double apart = slope.dot(each.ldlt().solve(slope)), together = slope.sum() * slope.sum() / each.sum();
    Heterogeneity found{.q = std::max(0.0, apart - together),
                        .degrees_of_freedom = static_cast<double>(informed.size() - 1)};
    const double over_variance = std::max(squared_value * each.sum(), kLeastInformed);
    found.spread = std::sqrt(found.q / found.degrees_of_freedom / over_variance);
    found.p = chiSquaredTail(found.q, found.degrees_of_freedom);
    return found;
}

double logBayesFactorOfSpread(const Heterogeneity& found, double wide, double narrow) {
    if (found.degrees_of_freedom == 0 || found.spread == 0) return 0;
    const double over_variance = found.q / found.degrees_of_freedom / (found.spread * found.spread);
    const double of_drive = over_variance / (found.degrees_of_freedom + 1);
    const double variance_narrow = 1 + narrow * narrow * of_drive, variance_wide = 1 + wide * wide * of_drive;
    return 0.5 * found.q * (1 / variance_narrow - 1 / variance_wide) -
           0.5 * found.degrees_of_freedom * std::log(variance_wide / variance_narrow);
}

}  // namespace tread::inference
