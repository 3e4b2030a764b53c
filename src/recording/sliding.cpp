#include "recording/sliding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "log/log_columns.h"
#include "log/resample.h"

namespace tread::recording {
namespace {

// Least speed by which lateral acceleration is divided: a share of the drive's largest speed, so that a car of any size
// is judged alike, but not more than kSlowestSlide.
constexpr double kSlowestShare = 0.5;
constexpr double kSlowestSlide = 5;  // m/s
// Largest zero error of an accelerometer that is taken out, m/s2: a mounting that is tilted by 3 degrees.
constexpr double kLargestZero = 0.5;

// The compared channel of this name, or else of this quantity; null when there is none.
const ObservedChannel* find(const RecordedDrive& drive, std::string_view quantity) {
    const std::vector<ObservedChannel>& all = drive.channels;
    auto first = std::find_if(all.begin(), all.end(), [&](const ObservedChannel& one) { return one.name == quantity; });
    if (first == all.end())
        first = std::find_if(all.begin(), all.end(),
                             [&](const ObservedChannel& one) { return quantityOf(one.name) == quantity; });
    return first == all.end() || first->times.empty() ? nullptr : &*first;
}

// Measured speed at these times; empty when it was not measured.
std::vector<double> measuredSpeed(const RecordedDrive& drive, const std::vector<double>& times) {
    const std::vector<Channel>& all = drive.log.channels;
    auto speed = std::find_if(all.begin(), all.end(), [](const Channel& one) { return one.name == "chassis.vx"; });
    if (speed == all.end())
        speed = std::find_if(all.begin(), all.end(),
                             [](const Channel& one) { return quantityOf(one.name) == "chassis.vx"; });
    return speed == all.end() ? std::vector<double>{} : resample(drive.time, speed->values, times);
}

// Channels of a drive that show the sideslip angle, with the speed at the same times.
struct Sideslip {
    const ObservedChannel *vy = nullptr, *ay = nullptr, *yaw_rate = nullptr, *vx = nullptr;
    std::vector<double> speed = {};
    Eigen::Index followed = 0;  // rows before vx is compared: the model follows the measured speed

    const std::vector<double>& times() const { return vy ? vy->times : ay->times; }
    double speedOf(const Eigen::VectorXd& rows, Eigen::Index i) const {
        return i < followed ? speed[static_cast<std::size_t>(i)] : rows(vx->first_row + i - followed);
    }
    // Lateral velocity, m/s, per time: what lateral acceleration does not turn into yaw.
    double drift(const Eigen::VectorXd& rows, Eigen::Index i, double v) const {
        return rows(ay->first_row + i) - v * rows(yaw_rate->first_row + i);
    }
    // By how much the drift of these rows is larger than that of others throughout, m/s2. Sideslip is bounded, so that
    // a difference that lasts is an error of the accelerometer's zero or of the road's bank. Of the middle fifth of all
    // differences the smallest counts, so that a slide of up to 0.6 of the drive is not taken for such an error.
    double zeroError(const Eigen::VectorXd& rows, const Eigen::VectorXd& others, double slowest) const {
        if (vy) return 0;
        std::vector<double> differences;
        for (Eigen::Index i = 0; i < std::ssize(times()); ++i)
            differences.push_back(drift(rows, i, std::max(speedOf(rows, i), slowest)) -
                                  drift(others, i, std::max(speedOf(others, i), slowest)));
        std::sort(differences.begin(), differences.end());
        const double last = static_cast<double>(differences.size() - 1);
        const double low = differences[std::lround(0.4 * last)], high = differences[std::lround(0.6 * last)];
        return std::clamp(std::clamp(0.0, low, high), -kLargestZero, kLargestZero);
    }
    // Angle since the start, whose speed counts as `slowest` at least. Lateral velocity shows it as it is; in the
    // integral, an error of 0.25 m/s2 grows to 0.08 rad within 1.5 s at 5 m/s.
    std::vector<double> angles(const Eigen::VectorXd& rows, double slowest, double zero_error) const {
        std::vector<double> angle(times().size(), 0);
        for (Eigen::Index i = 0; i < std::ssize(angle); ++i) {
            const double v = std::max(speedOf(rows, i), slowest);
            if (vy) angle[i] = rows(vy->first_row + i) / v;
            else if (i > 0)
                angle[i] = angle[i - 1] + (drift(rows, i, v) - zero_error) / v * (times()[i] - times()[i - 1]);
        }
        return angle;
    }
};

// Nothing when a channel is missing or has gaps.
std::optional<Sideslip> sideslipOf(const RecordedDrive& drive) {
    Sideslip slip{find(drive, "chassis.vy"), find(drive, "chassis.ay"), find(drive, "chassis.yaw_rate"),
                  find(drive, "chassis.vx")};
    if (!slip.vy && !(slip.ay && slip.yaw_rate && slip.ay->times == slip.yaw_rate->times)) return std::nullopt;
    const std::vector<double>& times = slip.times();
    slip.speed = measuredSpeed(drive, times);
    slip.followed = std::ssize(times) - (slip.vx ? slip.vx->rows() : 0);
    if (slip.speed.empty() || slip.followed < 0) return std::nullopt;
    if (slip.vx && !std::equal(slip.vx->times.begin(), slip.vx->times.end(), times.begin() + slip.followed))
        return std::nullopt;
    return slip;
}

}  // namespace

double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model) {
    const std::optional<Sideslip> slip = sideslipOf(drive);
    if (!slip) return kInfinity;
    const double fastest = *std::max_element(slip->speed.begin(), slip->speed.end());
    const double slowest = std::min(kSlowestShare * fastest, kSlowestSlide);
    if (!(slowest > 0)) return kInfinity;  // the car never moves forward
    const double zero_error = slip->zeroError(drive.measured, model, slowest);
    const std::vector<double> measured = slip->angles(drive.measured, slowest, zero_error);
    const std::vector<double> modelled = slip->angles(model, slowest, 0);
    const auto window = static_cast<std::size_t>(std::floor(kSlideWindow / kBlock));
    for (std::size_t i = 1; i < measured.size(); ++i) {
        const std::size_t before = i > window ? i - window : 0;
        if (std::abs(measured[i] - modelled[i] - measured[before] + modelled[before]) > kSlideAngle)
            return slip->times()[before];
    }
    return kInfinity;
}

}  // namespace tread::recording
