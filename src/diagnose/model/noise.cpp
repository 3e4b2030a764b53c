#include "diagnose/model/noise.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/math/median.h"
#include "diagnose/settings.h"
#include "inference/whitening.h"

namespace tread::diagnose::model {
namespace {

// Least noise of a channel, as a share of its root mean square: two step sizes of the simulation differ by this,
// measured. It acts on logs without noise; 0 changes none of the development cases.
constexpr double kModelError = 3e-4;
constexpr Eigen::Index kFewRows = 12;  // a channel with fewer rows gives no estimate of its noise
// Variance of the logarithm of an estimate from n rows, times n (computed).
constexpr double kScatter = 2.1;

double bandNoise(const Eigen::VectorXd& rows) {
    if (rows.size() < kFewRows) return kInfinity;
    return inference::noiseBehind(std::span<const double>(rows.data(), rows.size()), inference::kBand);
}

// Noise of a channel between 2 and 7 Hz in one drive, as its rows show it.
struct Band {
    double noise = kInfinity;  // infinite: too few rows
    double rows = 0;

    double scatter() const { return kScatter / rows; }
};

// One channel in all drives: its noise in each (infinite where it has none), and its largest root mean square.
struct Seen {
    std::vector<Band> band;
    double size = 0;
};

std::map<std::string, Seen> seenIn(Drives drives, const Rows& model) {
    std::map<std::string, Seen> channels;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        for (const recording::ObservedChannel& channel : drives[d].channels) {
            const Eigen::VectorXd measured = drives[d].measured.segment(channel.first_row, channel.rows());
            const Eigen::VectorXd left = measured - model[d].segment(channel.first_row, channel.rows());
            Seen& seen = channels[channel.name];
            seen.band.resize(drives.size());
            const auto rows = static_cast<double>(channel.rows());
            seen.band[d] = {std::min(bandNoise(measured), bandNoise(left)), rows};
            seen.size = std::max(seen.size, std::sqrt(measured.squaredNorm() / rows));
        }
    }
    return channels;
}

// Noise of a channel in each drive. Vibration grows with the speed, so that each drive has its own noise. Few rows tell
// it inexactly: each estimate is shrunk towards the median of all, the more so the fewer rows it has (D8a).
std::vector<double> noiseOf(const Seen& channel) {
    const double least = kModelError * channel.size;
    std::vector<double> all;
    for (const Band& one : channel.band) all.push_back(one.noise);
    const double usual = std::max(median(std::move(all)), least);
    const auto beyondUsual = [&](const Band& one) { return std::log(std::max(one.noise, least) / usual); };
    double squares = 0, scatter = 0, count = 0;
    for (const Band& one : channel.band) {
        if (!std::isfinite(one.noise) || usual == 0) continue;
        squares += beyondUsual(one) * beyondUsual(one), scatter += one.scatter(), ++count;
    }
    const double differs = count > 1 ? std::max(0.0, squares / (count - 1) - scatter / count) : 0;  // variance
    std::vector<double> noise(channel.band.size(), usual);
    for (std::size_t d = 0; d < noise.size(); ++d) {
        const Band& one = channel.band[d];
        if (std::isfinite(one.noise) && differs > 0)
            noise[d] *= std::exp(beyondUsual(one) * differs / (differs + one.scatter()));
    }
    return noise;
}

double deviationOf(const RecordedDrive& drive, const recording::ObservedChannel& channel, double seen) {
    const double deviation = std::max(std::sqrt(drive.runs) * channel.noise, seen);
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
    std::map<std::string, std::vector<double>> seen;  // noise of each channel in each drive
    for (const auto& [name, channel] : seenIn(drives, model)) seen[name] = noiseOf(channel);
    std::vector<RowNoise> noise;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        const RecordedDrive& drive = drives[d];
        const double inflation = referenceInflation(drive);
        RowNoise& here = noise.emplace_back();
        here.deviation.resize(drive.rows());
        for (const recording::ObservedChannel& channel : drive.channels) {
            const Eigen::Index rows = channel.rows();
            auto deviation = here.deviation.segment(channel.first_row, rows);
            deviation.setConstant(inflation * deviationOf(drive, channel, seen.at(channel.name)[d]));
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
