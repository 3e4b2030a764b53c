#include "blind/detectability/hats.h"

#include <algorithm>
#include <cmath>

#include "blind/detectability/drive_replay.h"
#include "blind/world/reading_noise.h"

namespace tread::blind::detectability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Smallest share of a change of the initial speed that must remain in the speed to infer a loss of speed from it.
constexpr double kLeastSpeedShare = 0.02;

}  // namespace

Pushing hats(std::size_t kind, std::size_t first) {
    return [=](double time, const VehicleInput&, const VehicleOutput&) {
        const double since = time - static_cast<double>(first) * kHatSpacing;
        const double period = static_cast<double>(kHatsPerRun) * kHatSpacing;
        const double near = std::max(0.0, std::round(since / period)) * period;
        const double size = kUnitPush * std::max(0.0, 1 - std::abs(since - near) / kHatSpacing);
        Push push;
        (kind == 0   ? push.force.x()
         : kind == 1 ? push.force.y()
         : kind == 2 ? push.moment.x()
                     : push.moment.z()) = size;
        return push;
    };
}

void separateHats(VectorXd change, std::size_t first, const VectorXd& by_start_speed, MatrixXd& by_hat) {
    const auto [speed, count] = rowsOfChannel("chassis.vx", change.size());
    const auto blocks = [](double seconds) { return static_cast<Index>(std::lround(seconds / world::kBlock)); };
    for (auto hat = static_cast<Index>(first); hat < by_hat.cols(); hat += kHatsPerRun) {
        const Index begins = std::max<Index>(0, blocks((static_cast<double>(hat) - 1) * kHatSpacing));
        const Index over = std::min(count, begins + blocks(static_cast<double>(kHatsPerRun) * kHatSpacing));
        if (begins >= count) break;
        const double kept = by_start_speed(speed + over - 1);
        const double faster = std::abs(kept) > kLeastSpeedShare ? change(speed + over - 1) / kept : 0;
        for (Index channel = 0; channel < change.size(); channel += count) {
            by_hat.col(hat).segment(channel + begins, over - begins) = change.segment(channel + begins, over - begins);
            by_hat.col(hat).segment(channel + over, count - over) =
                faster * by_start_speed.segment(channel + over, count - over);
        }
        change -= by_hat.col(hat);
    }
}

}  // namespace tread::blind::detectability
