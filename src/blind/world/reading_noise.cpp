#include "blind/world/reading_noise.h"

#include <cmath>
#include <numbers>

namespace tread::blind::world {
namespace {

constexpr double kTimeRounding = 1e-9;  // s

// Block index of each reading; empty blocks are not counted.
std::vector<Eigen::Index> blocksOf(std::span<const double> times) {
    std::vector<Eigen::Index> blocks;
    double last = -1;
    for (const double time : times) {
        const double block = std::floor((time + kTimeRounding) / kBlock);
        blocks.push_back(blocks.empty() ? 0 : blocks.back() + (block != last ? 1 : 0));
        last = block;
    }
    return blocks;
}

Eigen::Index countOf(const std::vector<Eigen::Index>& blocks) {
    return blocks.empty() ? 0 : blocks.back() + 1;
}

Eigen::VectorXd sizesOf(const std::vector<Eigen::Index>& blocks) {
    Eigen::VectorXd sizes = Eigen::VectorXd::Zero(countOf(blocks));
    for (const Eigen::Index block : blocks) sizes(block) += 1;
    return sizes;
}

// By lag, in readings.
std::vector<double> autocovariance(const ReadingNoise& noise, std::size_t count, double interval) {
    std::vector<double> by_lag(count);
    double kept = noise.level * noise.level;
    for (std::size_t lag = 0; lag < count; ++lag, kept *= noise.correlation) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(lag) * interval;
        const double spread = turn * noise.frequency_band;
        const double fading =
            spread == 0 ? 1 : std::sin(spread) / spread;  // mean over the uniformly distributed frequency
        by_lag[lag] = kept + 0.5 * noise.shaking * noise.shaking * std::cos(turn * noise.frequency) * fading;
    }
    return by_lag;
}

// Variance by quantisation and jitter, independent from reading to reading.
double ownVariance(const ReadingNoise& noise, std::span<const double> readings, std::size_t i, double interval) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, readings.size() - 1);
    const double apart = static_cast<double>(after - before) * interval;
    const double slope = apart > 0 ? (readings[after] - readings[before]) / apart : 0;
    return noise.resolution * noise.resolution / 12 + slope * slope * noise.jitter * noise.jitter;
}

}  // namespace

Eigen::VectorXd blockMeans(std::span<const double> times, std::span<const double> readings) {
    const std::vector<Eigen::Index> blocks = blocksOf(times);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(countOf(blocks));
    for (std::size_t i = 0; i < blocks.size(); ++i) sums(blocks[i]) += readings[i];
    return sums.cwiseQuotient(sizesOf(blocks));
}

Eigen::MatrixXd blockCovariance(const ReadingNoise& noise, std::span<const double> times,
                                std::span<const double> readings, std::span<const double> engine_phase) {
    const std::vector<Eigen::Index> blocks = blocksOf(times);
    const std::size_t count = times.size();
    const double interval = count > 1 ? (times.back() - times.front()) / static_cast<double>(count - 1) : kBlock;
    const std::vector<double> by_lag = autocovariance(noise, count, interval);
    const Eigen::VectorXd sizes = sizesOf(blocks);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(sizes.size(), sizes.size());
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) covariance(blocks[i], blocks[j]) += by_lag[i > j ? i - j : j - i];
        covariance(blocks[i], blocks[i]) += ownVariance(noise, readings, i, interval);
    }
    covariance = (sizes.cwiseInverse().asDiagonal() * covariance * sizes.cwiseInverse().asDiagonal()).eval();
    if (noise.engine == 0 || engine_phase.empty()) return covariance;

    // A sine of random phase is a sine and a cosine, each with half of its squared amplitude as variance. The error of
    // the engine speed decorrelates the phases of distant readings.
    std::vector<double> sine, cosine;
    for (const double phase : engine_phase) sine.push_back(std::sin(phase)), cosine.push_back(std::cos(phase));
    const Eigen::VectorXd phases = noise.engine_scatter * blockMeans(times, engine_phase);
    const Eigen::Index count_of_blocks = phases.size();
    const Eigen::ArrayXXd apart =
        phases.array().replicate(1, count_of_blocks) - phases.transpose().array().replicate(count_of_blocks, 1);
    const Eigen::MatrixXd alike = (-0.5 * apart.square()).exp().matrix();
    for (const std::vector<double>& wave : {sine, cosine}) {
        const Eigen::VectorXd mean = noise.engine / std::numbers::sqrt2 * blockMeans(times, wave);
        covariance += (mean * mean.transpose()).cwiseProduct(alike);
    }
    return covariance;
}

}  // namespace tread::blind::world
