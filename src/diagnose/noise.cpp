#include "diagnose/noise.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/median.h"

namespace tread {
namespace {

constexpr double kMedianOfNormal = 0.6745;
constexpr double kModelError = 3e-4;  // of a channel's size: two step widths differ by about that
// A model that needs a reference has another structure than the car, and answers to a change by so much more or less.
constexpr double kAnswersOtherwise = 0.1;
constexpr Eigen::Index kAround = 5;  // rows
constexpr Eigen::Index kFewRows = 12;
constexpr double kOfWhite = 0.375;  // of the variance of white noise, that the binomial filter leaves

constexpr std::array<double, 6> kBand{1, 1, -2, -2, 1, 1};  // passes 2 to 7 Hz of the rows

double shown(const Eigen::VectorXd& rows) {
    if (rows.size() < kFewRows) return kInfinity;
    return noiseBehind({rows.data(), static_cast<std::size_t>(rows.size())}, kBand);
}

// Root mean square over the rows around each: what passes through zero there is not small.
Eigen::VectorXd localSize(const Eigen::VectorXd& values) {
    Eigen::VectorXd size(values.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const Eigen::Index first = std::max<Eigen::Index>(i - kAround, 0);
        const Eigen::Index count = std::min(i + kAround + 1, values.size()) - first;
        size(i) = values.segment(first, count).norm() / std::sqrt(static_cast<double>(count));
    }
    return size;
}

// Of one channel in all drives.
struct Seen {
    std::vector<double> band;
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

Eigen::MatrixXd RowNoise::over(const Eigen::Ref<const Eigen::MatrixXd>& rows) const {
    Eigen::MatrixXd scaled = rows;
    scaled.array().colwise() /= deviation.array();
    Eigen::MatrixXd smooth = scaled;
    Eigen::Index first = 0;
    for (const Eigen::Index end : ends) {
        for (Eigen::Index i = first; i < end; ++i) {
            const Eigen::Index before = std::max(i - 1, first), after = std::min(i + 1, end - 1);
            smooth.row(i) = 0.5 * scaled.row(i) + 0.25 * (scaled.row(before) + scaled.row(after));
        }
        first = end;
    }
    return smooth;
}

std::vector<RowNoise> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal) {
    std::map<std::string, Seen> channels;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        for (const ObservedChannel& channel : drives[d].channels) {
            const auto count = static_cast<Eigen::Index>(channel.times.size());
            const Eigen::VectorXd measured = drives[d].measured.segment(channel.first_row, count);
            const Eigen::VectorXd left = measured - nominal[d].segment(channel.first_row, count);
            Seen& seen = channels[channel.name];
            seen.band.push_back(std::min(shown(measured), shown(left)));
            seen.size = std::max(seen.size, std::sqrt(measured.squaredNorm() / static_cast<double>(count)));
        }
    }
    std::vector<RowNoise> noise;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        const RecordedDrive& drive = drives[d];
        RowNoise& here = noise.emplace_back();
        here.deviation.resize(drive.rows());
        for (const ObservedChannel& channel : drive.channels) {
            const Seen& seen = channels[channel.name];
            double deviation =
                std::max({std::sqrt(drive.runs) * channel.noise, median(seen.band), kModelError * seen.size});
            if (deviation == 0) deviation = 1;  // a channel that is zero throughout says nothing
            const auto rows = static_cast<Eigen::Index>(channel.times.size());
            const auto telling = std::upper_bound(channel.times.begin(), channel.times.end(), drive.until);
            const Eigen::Index told = telling - channel.times.begin();
            here.deviation.segment(channel.first_row, rows).setConstant(drive.doubt() * deviation);
            if (drive.compared()) {
                const Eigen::VectorXd gap = (drive.measured - nominal[d]).segment(channel.first_row, rows);
                here.deviation.segment(channel.first_row, rows) += kAnswersOtherwise * drive.doubt() * localSize(gap);
            }
            here.deviation.segment(channel.first_row + told, rows - told).setConstant(kInfinity);
            here.ends.push_back(channel.first_row + rows);
            here.expected += kOfWhite * static_cast<double>(told) / (drive.doubt() * drive.doubt());
        }
    }
    return noise;
}

}  // namespace tread
