#include "diagnose/model/birge_ratios.h"

#include <algorithm>

namespace tread::diagnose::model {

BirgeRatios::BirgeRatios(Drives drives, const Uncertainty& uncertainty, const ChannelSquares& squares, const Rows& rows)
    : drives_(drives), uncertainty_(uncertainty), squares_(squares) {
    Rows left;
    std::map<std::string, double> expected;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        left.push_back(residual(drives, uncertainty, rows, d));
        const auto compared = (uncertainty.noise[d].deviation.array() < kInfinity).cast<double>().eval();
        for (const recording::ObservedChannel& channel : drives[d].channels)
            expected[channel.name] += uncertainty.noise[d].expected / std::max(1.0, compared.sum()) *
                                      compared.segment(channel.first_row, channel.rows()).sum();
    }
    for (const auto& [channel, squared] : ofChannels(left))
        squared_[channel] = expected[channel] > 0 ? std::max(1.0, squared / expected[channel]) : 1;
}

double BirgeRatios::between(const Rows& one, const Rows& other) const {
    Rows off;
    for (std::size_t d = 0; d < one.size(); ++d) off.push_back(uncertainty_.noise[d].over(one[d] - other[d]));
    double sum = 0, weights = 0;
    for (const auto& [channel, squared] : ofChannels(off)) {
        const double weight = std::max(0.0, squared);
        sum += weight * squared_.at(channel), weights += weight;
    }
    return weights > 0 ? sum / weights : 1;
}

// Squares of whitened rows in each channel, of all drives together.
std::map<std::string, double> BirgeRatios::ofChannels(const Rows& whitened) const {
    std::map<std::string, double> sums;
    for (std::size_t d = 0; d < whitened.size(); ++d) {
        const std::vector<double> squares = squares_.in(d, whitened[d]);
        for (std::size_t c = 0; c < squares.size(); ++c) sums[drives_[d].channels[c].name] += squares[c];
    }
    return sums;
}

}  // namespace tread::diagnose::model
