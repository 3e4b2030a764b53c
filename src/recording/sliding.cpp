#include "recording/sliding.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "log/log_columns.h"

namespace tread::recording {
namespace {

constexpr double kSlowestSlide = 5;  // m/s; least speed by which lateral acceleration is divided

}  // namespace

double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model) {
    const auto find = [&](std::string_view quantity) {
        const auto& all = drive.channels;
        const auto first = std::find_if(all.begin(), all.end(),
                                        [&](const ObservedChannel& channel) { return channel.name == quantity; });
        if (first != all.end()) return first;
        return std::find_if(all.begin(), all.end(),
                            [&](const ObservedChannel& channel) { return quantityOf(channel.name) == quantity; });
    };
    const auto ay = find("chassis.ay"), yaw_rate = find("chassis.yaw_rate"), vx = find("chassis.vx");
    const auto none = drive.channels.end();
    if (ay == none || yaw_rate == none || vx == none) return kInfinity;
    const std::vector<double>& times = ay->times;
    if (times != yaw_rate->times || times != vx->times) return kInfinity;

    const auto rate = [&](const Eigen::VectorXd& rows, Eigen::Index row) {
        const double speed = std::max(rows(vx->first_row + row), kSlowestSlide);
        return rows(ay->first_row + row) / speed - rows(yaw_rate->first_row + row);
    };
    const Eigen::Index window = std::lround(std::floor(kSlideWindow / kBlock));
    std::vector<double> apart(times.size(), 0);
    for (Eigen::Index i = 1; i < ay->rows(); ++i) {
        apart[i] = apart[i - 1] + (rate(drive.measured, i) - rate(model, i)) * (times[i] - times[i - 1]);
        const Eigen::Index before = std::max<Eigen::Index>(i - window, 0);
        if (std::abs(apart[i] - apart[before]) > kSlideAngle) return times[before];
    }
    return kInfinity;
}

}  // namespace tread::recording
