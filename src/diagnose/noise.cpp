#include "diagnose/noise.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tread {
namespace {

constexpr double kMedianOfNormal = 0.6745;
constexpr double kModelError = 1e-3;  // of a channel's size: two step widths differ by about that
constexpr Eigen::Index kFewRows = 8;

// White noise from third differences (their variance is 20 times the noise's), by the median: what happens now and then
// is not noise.
double roughness(const Eigen::VectorXd& rows) {
    if (rows.size() < kFewRows) return kInfinity;
    std::vector<double> differences;
    for (Eigen::Index i = 3; i < rows.size(); ++i)
        differences.push_back(std::abs(rows(i) - 3 * rows(i - 1) + 3 * rows(i - 2) - rows(i - 3)));
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return *middle / (kMedianOfNormal * std::sqrt(20.0));
}

}  // namespace

std::vector<Eigen::VectorXd> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal) {
    std::map<std::string, std::vector<double>> seen;
    std::map<std::string, double> size;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        for (const ObservedChannel& channel : drives[d].channels) {
            const auto count = static_cast<Eigen::Index>(channel.times.size());
            const Eigen::VectorXd measured = drives[d].measured.segment(channel.first_row, count);
            const Eigen::VectorXd left = measured - nominal[d].segment(channel.first_row, count);
            seen[channel.name].push_back(std::min(roughness(measured), roughness(left)));
            size[channel.name] =
                std::max(size[channel.name], std::sqrt(measured.squaredNorm() / static_cast<double>(count)));
        }
    }
    std::vector<Eigen::VectorXd> noise;
    for (const RecordedDrive& drive : drives) {
        noise.push_back(Eigen::VectorXd(drive.rows()));
        for (const ObservedChannel& channel : drive.channels) {
            std::vector<double>& all = seen[channel.name];
            std::sort(all.begin(), all.end());
            const double shown = std::isfinite(all[all.size() / 2]) ? all[all.size() / 2] : 0;
            double sd = std::max({channel.noise, shown, kModelError * size[channel.name]});
            if (sd == 0) sd = 1;  // a channel that is zero throughout says nothing
            noise.back().segment(channel.first_row, static_cast<Eigen::Index>(channel.times.size())).setConstant(sd);
        }
    }
    return noise;
}

}  // namespace tread
