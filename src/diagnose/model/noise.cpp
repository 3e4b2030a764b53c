#include "diagnose/model/noise.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/median.h"
#include "diagnose/settings.h"
#include "inference/whitening.h"

namespace tread::diagnose::model {
namespace {

// Least noise of a channel, as a share of its root mean square: two step sizes of the simulation differ by this,
// measured. It acts on logs without noise; 0 changes none of the development cases.
constexpr double kModelError = 3e-4;
constexpr Eigen::Index kFewRows = 12;  // a channel with fewer rows gives no estimate of its noise

double bandNoise(const Eigen::VectorXd& rows) {
    if (rows.size() < kFewRows) return kInfinity;
    return inference::noiseBehind(std::span<const double>(rows.data(), rows.size()), inference::kBand);
}

// One channel in all drives: its noise between 2 and 7 Hz in each, and its largest root mean square.
struct Seen {
    std::vector<double> band;
    double size = 0;
};

std::map<std::string, Seen> seenIn(Drives drives, const Rows& model) {
    std::map<std::string, Seen> channels;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        for (const recording::ObservedChannel& channel : drives[d].channels) {
            const Eigen::VectorXd measured = drives[d].measured.segment(channel.first_row, channel.rows());
            const Eigen::VectorXd left = measured - model[d].segment(channel.first_row, channel.rows());
            Seen& seen = channels[channel.name];
            seen.band.push_back(std::min(bandNoise(measured), bandNoise(left)));
            seen.size = std::max(seen.size, std::sqrt(measured.squaredNorm() / static_cast<double>(channel.rows())));
        }
    }
    return channels;
}

double deviationOf(const RecordedDrive& drive, const recording::ObservedChannel& channel, const Seen& seen) {
    const double told = std::sqrt(drive.runs) * channel.noise;
    const double deviation = std::max({told, median(seen.band), kModelError * seen.size});
    return deviation > 0 ? deviation : 1;  // a channel that is always zero carries no information
}

}  // namespace

double referenceInflation(const RecordedDrive& drive) {
    return drive.compared() ? kSettings.reference_inflation : 1;
}

double disturbanceScale(const RecordedDrive& drive) {
    return std::sqrt(drive.runs) * referenceInflation(drive);
}

Eigen::MatrixXd RowNoise::over(const Eigen::Ref<const Eigen::MatrixXd>& rows) const {
    Eigen::MatrixXd scaled = rows;
    scaled.array().colwise() /= deviation.array();
    return inference::binomial(scaled, ends);
}

std::vector<RowNoise> rowNoise(Drives drives, const Rows& model, const std::vector<double>& until) {
    const std::map<std::string, Seen> channels = seenIn(drives, model);
    std::vector<RowNoise> noise;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        const RecordedDrive& drive = drives[d];
        const double inflation = referenceInflation(drive);
        RowNoise& here = noise.emplace_back();
        here.deviation.resize(drive.rows());
        for (const recording::ObservedChannel& channel : drive.channels) {
            const Eigen::Index rows = channel.rows();
            auto deviation = here.deviation.segment(channel.first_row, rows);
            deviation.setConstant(inflation * deviationOf(drive, channel, channels.at(channel.name)));
            const auto silent = std::upper_bound(channel.times.begin(), channel.times.end(), until[d]);
            const Eigen::Index told = silent - channel.times.begin();
            deviation.tail(rows - told).setConstant(kInfinity);
            here.ends.push_back(channel.first_row + rows);
            here.expected += inference::kLeftByBinomial * static_cast<double>(told) / (inflation * inflation);
        }
    }
    return noise;
}

}  // namespace tread::diagnose::model
