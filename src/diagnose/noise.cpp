#include "diagnose/noise.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/median.h"

namespace tread {
namespace {

constexpr double kMedianOfNormal = 0.6745;
constexpr double kModelError = 1e-3;  // of a channel's size: two step widths differ by about that
constexpr Eigen::Index kFewRows = 12;

// The first filter passes 2 to 7 Hz of the rows, the second what is faster.
constexpr std::array<double, 6> kBand{1, 1, -2, -2, 1, 1};
constexpr std::span<const double> kFast = kThirdDifference;
constexpr double kVibrationInFast = 2.3;  // of its variance at 8 Hz, against that of white noise

double shown(const Eigen::VectorXd& rows, std::span<const double> filter) {
    if (rows.size() < kFewRows) return kInfinity;
    return noiseBehind({rows.data(), static_cast<std::size_t>(rows.size())}, filter);
}

// Of one channel in all drives.
struct Seen {
    std::vector<double> band, fast;
    double size = 0;
};

}  // namespace

double noiseBehind(std::span<const double> values, std::span<const double> filter) {
    std::vector<double> left;
    for (std::size_t i = 0; i + filter.size() <= values.size(); ++i)
        left.push_back(std::abs(
            std::inner_product(filter.begin(), filter.end(), values.begin() + static_cast<std::ptrdiff_t>(i), 0.0)));
    const double gain = std::sqrt(std::inner_product(filter.begin(), filter.end(), filter.begin(), 0.0));
    return median(std::move(left)) / (kMedianOfNormal * gain);
}

std::vector<RowNoise> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal) {
    std::map<std::string, Seen> channels;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        for (const ObservedChannel& channel : drives[d].channels) {
            const auto count = static_cast<Eigen::Index>(channel.times.size());
            const Eigen::VectorXd measured = drives[d].measured.segment(channel.first_row, count);
            const Eigen::VectorXd left = measured - nominal[d].segment(channel.first_row, count);
            Seen& seen = channels[channel.name];
            seen.band.push_back(std::min(shown(measured, kBand), shown(left, kBand)));
            seen.fast.push_back(std::min(shown(measured, kFast), shown(left, kFast)));
            seen.size = std::max(seen.size, std::sqrt(measured.squaredNorm() / static_cast<double>(count)));
        }
    }
    std::vector<RowNoise> noise;
    for (const RecordedDrive& drive : drives) {
        RowNoise& here = noise.emplace_back(RowNoise{Eigen::VectorXd(drive.rows())});
        for (const ObservedChannel& channel : drive.channels) {
            const Seen& seen = channels[channel.name];
            const double white = median(seen.band), fast = median(seen.fast);
            double deviation = std::max({channel.noise, white, kModelError * seen.size});
            if (deviation == 0) deviation = 1;  // a channel that is zero throughout says nothing
            const double vibration = std::max(0.0, fast * fast - white * white) / kVibrationInFast;
            const auto rows = static_cast<Eigen::Index>(channel.times.size());
            here.deviation.segment(channel.first_row, rows).setConstant(deviation);
            here.expected += static_cast<double>(rows) * (1 + vibration / (deviation * deviation));
        }
    }
    return noise;
}

}  // namespace tread
