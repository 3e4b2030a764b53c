#include "recording/sliding.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "log/log_columns.h"
#include "log/resample.h"

namespace tread::recording {
namespace {

// Least speed by which lateral acceleration is divided: a share of the drive's largest speed, so that a car of any size
// is judged alike, but not more than kSlowestSlide.
constexpr double kSlowestShare = 0.5;
constexpr double kSlowestSlide = 5;  // m/s

// The compared channel of this name, or else of this quantity; null when there is none.
const ObservedChannel* find(const RecordedDrive& drive, std::string_view quantity) {
    const std::vector<ObservedChannel>& all = drive.channels;
    auto first = std::find_if(all.begin(), all.end(), [&](const ObservedChannel& one) { return one.name == quantity; });
    if (first == all.end())
        first = std::find_if(all.begin(), all.end(),
                             [&](const ObservedChannel& one) { return quantityOf(one.name) == quantity; });
    return first == all.end() || first->times.empty() ? nullptr : &*first;
}

}  // namespace

double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model) {
    const ObservedChannel *ay = find(drive, "chassis.ay"), *yaw_rate = find(drive, "chassis.yaw_rate");
    const Channel* speed = drive.log.find("chassis.vx");
    if (!ay || !yaw_rate || !speed || ay->times != yaw_rate->times) return kInfinity;
    const std::vector<double>& times = ay->times;
    const std::vector<double> measured = resample(drive.time, speed->values, times);
    // Not compared, or compared only later, where the model follows the measured speed.
    const ObservedChannel* compared = find(drive, "chassis.vx");
    const Eigen::Index followed = ay->rows() - (compared ? compared->rows() : 0);
    if (followed < 0 ||
        (compared && !std::equal(compared->times.begin(), compared->times.end(), times.begin() + followed)))
        return kInfinity;

    const double fastest = *std::max_element(measured.begin(), measured.end());
    const double slowest = std::min(kSlowestShare * fastest, kSlowestSlide);
    if (!(slowest > 0)) return kInfinity;  // the car never moves forward
    const auto rate = [&](const Eigen::VectorXd& rows, Eigen::Index i) {
        const double v = i < followed ? measured[i] : rows(compared->first_row + i - followed);
        return rows(ay->first_row + i) / std::max(v, slowest) - rows(yaw_rate->first_row + i);
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
