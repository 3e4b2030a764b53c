#include "inference/ornstein_uhlenbeck.h"

#include <cmath>

namespace tread::inference {

Eigen::MatrixXd correlationFactor(Eigen::Index count, double spacing, double correlation_time) {
    const double kept = std::exp(-spacing / correlation_time), fresh = std::sqrt(1 - kept * kept);
    Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index impulse = 0; impulse < count; ++impulse) {
        double left = impulse == 0 ? 1 : fresh;
        for (Eigen::Index value = impulse; value < count; ++value, left *= kept) factor(value, impulse) = left;
    }
    return factor;
}

}  // namespace tread::inference
