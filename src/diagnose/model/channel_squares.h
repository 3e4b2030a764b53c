// Squared lengths of rows beside the remainder, by the channels of the drives in which the rows lie.
#pragma once

#include <vector>

#include "diagnose/model/uncertainty.h"

namespace tread::diagnose::model {

class ChannelSquares {
public:
    // Beside a remainder of these sizes.
    ChannelSquares(Drives drives, const Uncertainty& uncertainty, const Sizes& sizes);

    // Of whitened rows of a drive, one value per channel. The values sum to the squared length of all rows. One may be
    // negative, because the remainder correlates the channels.
    std::vector<double> in(std::size_t drive, const Eigen::VectorXd& rows) const;

private:
    Drives drives_;
    const Uncertainty& uncertainty_;
    std::vector<inference::Metric> metrics_;  // per drive
};

}  // namespace tread::diagnose::model
