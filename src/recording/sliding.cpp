#include "recording/sliding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "log/log_columns.h"

namespace tread::recording {
namespace {

// Least speed by which lateral acceleration is divided: a share of the drive's largest speed, so that a car of any size
// is judged alike, but not more than kSlowestSlide.
constexpr double kSlowestShare = 0.5;
constexpr double kSlowestSlide = 5;  // m/s

const ObservedChannel* find(const RecordedDrive& drive, std::string_view quantity) {
    const auto first = std::find_if(drive.channels.begin(), drive.channels.end(),
                                    [&](const ObservedChannel& channel) { return channel.name == quantity; });
    if (first != drive.channels.end()) return &*first;
    const auto further =
        std::find_if(drive.channels.begin(), drive.channels.end(),
                     [&](const ObservedChannel& channel) { return quantityOf(channel.name) == quantity; });
    return further == drive.channels.end() ? nullptr : &*further;
}

// Row of the channel at the first time of vx, which begins later where the speed is followed at first; nothing without
// the channel, or when it has gaps.
std::optional<Eigen::Index> rowBeside(const ObservedChannel& vx, const ObservedChannel* channel) {
    if (!channel || channel->rows() < vx.rows()) return std::nullopt;
    const Eigen::Index skipped = channel->rows() - vx.rows();
    if (!std::equal(vx.times.begin(), vx.times.end(), channel->times.begin() + skipped)) return std::nullopt;
    return channel->first_row + skipped;
}

// Change of the sideslip angle since the start at the times of vx; empty when it was not measured. Lateral velocity
// shows it as it is; in the integral, an error of 0.25 m/s2 grows to 0.08 rad within 1.5 s at 5 m/s.
std::vector<double> sideslip(const RecordedDrive& drive, const Eigen::VectorXd& rows, double slowest) {
    const ObservedChannel& vx = *find(drive, "chassis.vx");
    const auto ay = rowBeside(vx, find(drive, "chassis.ay")), yaw_rate = rowBeside(vx, find(drive, "chassis.yaw_rate")),
               vy = rowBeside(vx, find(drive, "chassis.vy"));
    std::vector<double> angle(vx.times.size(), 0);
    if (!vy && !(ay && yaw_rate)) return {};
    for (Eigen::Index i = 0; i < vx.rows(); ++i) {
        const double speed = std::max(rows(vx.first_row + i), slowest);
        if (vy) angle[i] = rows(*vy + i) / speed;
        else if (i > 0)
            angle[i] = angle[i - 1] + (rows(*ay + i) / speed - rows(*yaw_rate + i)) * (vx.times[i] - vx.times[i - 1]);
    }
    return angle;
}

}  // namespace

double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model) {
    const ObservedChannel* vx = find(drive, "chassis.vx");
    if (!vx) return kInfinity;
    const double fastest = drive.measured.segment(vx->first_row, vx->rows()).maxCoeff();
    const double slowest = std::min(kSlowestShare * fastest, kSlowestSlide);
    if (!(slowest > 0)) return kInfinity;  // the car never moves forward
    const std::vector<double> measured = sideslip(drive, drive.measured, slowest),
                              modelled = sideslip(drive, model, slowest);
    const auto window = static_cast<std::size_t>(std::floor(kSlideWindow / kBlock));
    for (std::size_t i = 1; i < measured.size(); ++i) {
        const std::size_t before = i > window ? i - window : 0;
        if (std::abs(measured[i] - modelled[i] - measured[before] + modelled[before]) > kSlideAngle)
            return vx->times[before];
    }
    return kInfinity;
}

}  // namespace tread::recording
