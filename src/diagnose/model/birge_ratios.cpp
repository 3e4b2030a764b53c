#include "diagnose/model/birge_ratios.h"

#include <algorithm>

namespace tread::diagnose::model {

BirgeRatios::BirgeRatios(Drives drives, const Uncertainty& uncertainty, const Rows& rows, const Sizes& sizes)
    : drives_(drives), uncertainty_(uncertainty) {
    std::vector<Eigen::VectorXd> left;
    std::map<std::string, double> expected;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        metrics_.push_back(inference::metricOf(uncertainty.bare[d].disturbances, uncertainty.sizesOf(d, sizes)));
        left.push_back(residual(drives, uncertainty, rows, d));
        const auto compared = (uncertainty.noise[d].deviation.array() < kInfinity).cast<double>().eval();
        for (const recording::ObservedChannel& channel : drives[d].channels)
            expected[channel.name] += uncertainty.noise[d].expected / std::max(1.0, compared.sum()) *
                                      compared.segment(channel.first_row, channel.rows()).sum();
    }
    for (const auto& [channel, squares] : squaresOf(left))
        squared_[channel] = expected[channel] > 0 ? std::max(1.0, squares / expected[channel]) : 1;
}

double BirgeRatios::between(const Rows& one, const Rows& other) const {
    std::vector<Eigen::VectorXd> off;
    for (std::size_t d = 0; d < one.size(); ++d) off.push_back(uncertainty_.noise[d].over(one[d] - other[d]));
    double sum = 0, weights = 0;
    for (const auto& [channel, squares] : squaresOf(off)) {
        const double weight = std::max(0.0, squares);
        sum += weight * squared_.at(channel), weights += weight;
    }
    return weights > 0 ? sum / weights : 1;
}

// Squared length of rows in the metric beside the remainder, by the channels in which they lie.
std::map<std::string, double> BirgeRatios::squaresOf(const std::vector<Eigen::VectorXd>& off) const {
    std::map<std::string, double> squares;
    for (std::size_t d = 0; d < off.size(); ++d) {
        const Eigen::VectorXd weighted = inference::inMetric(metrics_[d], off[d], uncertainty_.directions[d]);
        for (const recording::ObservedChannel& channel : drives_[d].channels)
            squares[channel.name] += off[d]
                                         .segment(channel.first_row, channel.rows())
                                         .dot(weighted.segment(channel.first_row, channel.rows()));
    }
    return squares;
}

}  // namespace tread::diagnose::model
