#include "diagnose/model/channel_squares.h"

namespace tread::diagnose::model {

ChannelSquares::ChannelSquares(Drives drives, const Uncertainty& uncertainty, const Sizes& sizes)
    : drives_(drives), uncertainty_(uncertainty) {
    for (std::size_t d = 0; d < drives.size(); ++d)
        metrics_.push_back(inference::metricOf(uncertainty.bare[d].disturbances, uncertainty.sizesOf(d, sizes)));
}

std::vector<double> ChannelSquares::in(std::size_t drive, const Eigen::VectorXd& rows) const {
    const Eigen::VectorXd weighted = inference::inMetric(metrics_[drive], rows, uncertainty_.directions[drive]);
    std::vector<double> squares;
    for (const recording::ObservedChannel& channel : drives_[drive].channels) {
        squares.push_back(
            rows.segment(channel.first_row, channel.rows()).dot(weighted.segment(channel.first_row, channel.rows())));
    }
    return squares;
}

}  // namespace tread::diagnose::model
