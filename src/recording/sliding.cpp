#include "recording/sliding.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "log/log_columns.h"

namespace tread::recording {
namespace {

// Least speed by which lateral acceleration is divided: a share of the drive's largest speed, so that a car of any size
// is judged alike, but not more than kSlowestSlide.
constexpr double kSlowestShare = 0.5;
constexpr double kSlowestSlide = 5;  // m/s

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
    if (ay->times != yaw_rate->times || ay->rows() < vx->rows()) return kInfinity;
    const std::vector<double>& times = vx->times;  // begin later where the speed is followed at first
    const Eigen::Index skipped = ay->rows() - vx->rows();
    if (!std::equal(times.begin(), times.end(), ay->times.begin() + skipped)) return kInfinity;

    const double fastest = drive.measured.segment(vx->first_row, vx->rows()).maxCoeff();
    const double slowest = std::min(kSlowestShare * fastest, kSlowestSlide);
    if (!(slowest > 0)) return kInfinity;  // the car never moves forward
    const auto rate = [&](const Eigen::VectorXd& rows, Eigen::Index row) {
        const double speed = std::max(rows(vx->first_row + row), slowest);
        return rows(ay->first_row + skipped + row) / speed - rows(yaw_rate->first_row + skipped + row);
    };
    const Eigen::Index window = std::lround(std::floor(kSlideWindow / kBlock));
    std::vector<double> apart(times.size(), 0);
    for (Eigen::Index i = 1; i < vx->rows(); ++i) {
        apart[i] = apart[i - 1] + (rate(drive.measured, i) - rate(model, i)) * (times[i] - times[i - 1]);
        const Eigen::Index before = std::max<Eigen::Index>(i - window, 0);
        if (std::abs(apart[i] - apart[before]) > kSlideAngle) return times[before];
    }
    return kInfinity;
}

}  // namespace tread::recording
