#include "diagnose/select/visible_gap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/threads/parallel.h"
#include "diagnose/model/gap.h"
#include "inference/whitening.h"

namespace tread::diagnose::select {
namespace {

// Rows of a channel of one drive, each in units of its floor. Their covariance is noise + D D' - J J'.
struct Block {
    Eigen::VectorXd gap;
    Eigen::MatrixXd noise, disturbances, explained;  // the last two are D and J
};

// A squared gap, with the terms of its mean and variance.
struct Gap {
    double squares = 0, mean = 0;
    double of_noise = 0, crossed = 0;  // parts of the sum of squares of the covariance
    Eigen::MatrixXd dd, dj, jj;        // products of D and J

    void add(const Block& block) {
        const Eigen::MatrixXd &noise = block.noise, &d = block.disturbances, &j = block.explained;
        squares += block.gap.squaredNorm();
        mean += noise.trace() + d.squaredNorm() - j.squaredNorm();
        of_noise += noise.squaredNorm();
        crossed += d.cwiseProduct(noise * d).sum() - j.cwiseProduct(noise * j).sum();
        add(dd, d.transpose() * d), add(dj, d.transpose() * j), add(jj, j.transpose() * j);
    }
    // Twice the squares of the covariance.
    double variance() const {
        return 2 * (of_noise + 2 * crossed + dd.squaredNorm() + jj.squaredNorm() - 2 * dj.squaredNorm());
    }

private:
    static void add(Eigen::MatrixXd& sum, Eigen::MatrixXd product) {
        if (sum.size() == 0) sum = std::move(product);
        else sum += product;
    }
};

// Sum of the squared gaps of one channel in several drives, and of its moments.
struct Moments {
    double squares = 0, mean = 0, variance = 0;

    void add(const Gap& gap) { squares += gap.squares, mean += gap.mean, variance += gap.variance(); }

    // Probability of such a gap, or a larger one: a multiple of chi squared has the same mean and variance, and its
    // cube root is nearly normal (Satterthwaite 1946; Wilson & Hilferty 1931).
    double chance() const {
        if (!(mean > 0 && variance > 0)) return 1;
        const double spread = variance / (9 * mean * mean);  // 2/9 over the degrees of freedom
        const double normal = (std::cbrt(squares / mean) - (1 - spread)) / std::sqrt(spread);
        return 0.5 * std::erfc(normal * std::sqrt(0.5));
    }
};

// Covariance of white noise of variance 1 behind the filter, for the rows of one channel.
Eigen::MatrixXd filteredNoise(const model::RowNoise& noise, Eigen::Index first, Eigen::Index rows) {
    std::vector<Eigen::Index> ends;
    for (const Eigen::Index end : noise.ends)
        if (end > first && end <= first + rows) ends.push_back(end - first);
    const Eigen::VectorXd known = noise.deviation.segment(first, rows).array().isFinite().cast<double>();
    const Eigen::MatrixXd filter = inference::binomial(known.asDiagonal(), ends);
    return filter * filter.transpose();
}

// The channels of a drive. `root`: of the covariance of the parameters.
std::vector<Block> blocksOf(const Calibration& car, const Fit& fit, const Rows& rows, const Eigen::MatrixXd& root,
                            std::size_t drive) {
    const Eigen::VectorXd scale = model::filteredFloorOf(car.uncertainty, drive).cwiseInverse();
    const Eigen::VectorXd gap = scale.cwiseProduct(model::residual(car.drives(), car.uncertainty, rows, drive));
    const Eigen::MatrixXd disturbances = scale.asDiagonal() * model::usualDisturbances(car.uncertainty, drive);
    const Eigen::MatrixXd explained = scale.asDiagonal() * fit.columns[drive] * root;
    std::vector<Block> blocks;
    for (const recording::ObservedChannel& channel : car.drives()[drive].channels) {
        const Eigen::Index first = channel.first_row, n = channel.rows();
        const auto units = scale.segment(first, n).asDiagonal();
        blocks.push_back({gap.segment(first, n), units * filteredNoise(car.uncertainty.noise[drive], first, n) * units,
                          disturbances.middleRows(first, n), explained.middleRows(first, n)});
    }
    return blocks;
}

}  // namespace

double chanceOfGap(const Calibration& car, const Fit& fit, const Rows& rows) {
    const Eigen::MatrixXd root = fit.covariance.llt().matrixL();
    std::vector<Moments> drives(rows.size());
    std::vector<std::vector<Gap>> of_channels(rows.size());
    inParallel(rows.size(), car.problem.replays.threads, [&](std::size_t d) {
        Gap all;
        for (const Block& block : blocksOf(car, fit, rows, root, d)) {
            of_channels[d].emplace_back().add(block);
            all.add(block);
        }
        drives[d].add(all);
    });
    std::map<std::string, Moments> channels;
    for (std::size_t d = 0; d < rows.size(); ++d)
        for (std::size_t c = 0; c < of_channels[d].size(); ++c)
            channels[car.drives()[d].channels[c].name].add(of_channels[d][c]);
    double least = 1;
    for (const Moments& one : drives) least = std::min(least, one.chance());
    for (const auto& [name, one] : channels) least = std::min(least, one.chance());
    return std::min(1.0, least * static_cast<double>(drives.size() + channels.size()));
}

}  // namespace tread::diagnose::select
