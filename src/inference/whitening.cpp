#include "inference/whitening.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/math/median.h"

namespace tread::inference {
namespace {

constexpr double kMedianOfNormal = 0.6745;  // of the absolute value, in standard deviations

}  // namespace

double noiseBehind(std::span<const double> values, std::span<const double> filter) {
    std::vector<double> left;
    for (std::size_t i = 0; i + filter.size() <= values.size(); ++i)
        left.push_back(std::abs(std::inner_product(filter.begin(), filter.end(), values.begin() + i, 0.0)));
    const double gain = std::sqrt(std::inner_product(filter.begin(), filter.end(), filter.begin(), 0.0));
    return median(std::move(left)) / (kMedianOfNormal * gain);
}

Eigen::MatrixXd binomial(const Eigen::MatrixXd& rows, const std::vector<Eigen::Index>& ends) {
    Eigen::MatrixXd smooth = rows;
    Eigen::Index first = 0;
    for (const Eigen::Index end : ends) {
        for (Eigen::Index i = first; i < end; ++i) {
            const Eigen::Index before = std::max(i - 1, first), after = std::min(i + 1, end - 1);
            smooth.row(i) = 0.5 * rows.row(i) + 0.25 * (rows.row(before) + rows.row(after));
        }
        first = end;
    }
    return smooth;
}

}  // namespace tread::inference
