#include "diagnose/select/visible_gap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/threads/parallel.h"
#include "diagnose/model/gap.h"
#include "diagnose/model/remainder.h"
#include "diagnose/select/doubt.h"
#include "inference/whitening.h"

namespace tread::diagnose::select {
namespace {

// Rows of a channel of one drive, each in units of its floor. Their covariance is noise + D D' - J J'. The last column
// of D is the error of the signatures.
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

// Probability that a sum of squares of this mean and variance is at least `squares`: a multiple of chi squared has the
// same mean and variance, and its cube root is nearly normal (Satterthwaite 1946; Wilson & Hilferty 1931).
double chanceOf(double squares, double mean, double variance) {
    const double spread = variance / (9 * mean * mean);  // 2/9 over the degrees of freedom
    const double normal = (std::cbrt(squares / mean) - (1 - spread)) / std::sqrt(spread);
    return 0.5 * std::erfc(normal * std::sqrt(0.5));
}

// Sum of the squared gaps of one channel in several drives, and of its moments.
struct Moments {
    double squares = 0, mean = 0, variance = 0;

    void add(const Gap& gap) { squares += gap.squares, mean += gap.mean, variance += gap.variance(); }

    double chance() const { return mean > 0 && variance > 0 ? chanceOf(squares, mean, variance) : 1; }
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

// The channels of a drive. `signature`: what the effects change. `root`: of the covariance of the parameters.
std::vector<Block> blocksOf(const Calibration& car, const Fit& fit, const Rows& rows, const Eigen::VectorXd& signature,
                            const Eigen::MatrixXd& root, std::size_t drive) {
    const Eigen::VectorXd scale = model::filteredFloorOf(car.uncertainty, drive).cwiseInverse();
    const Eigen::VectorXd gap = scale.cwiseProduct(model::residual(car.drives(), car.uncertainty, rows, drive));
    Eigen::MatrixXd disturbances = model::usualDisturbances(car.uncertainty, drive);
    disturbances.conservativeResize(Eigen::NoChange, disturbances.cols() + 1);
    disturbances.rightCols(1) = car.structure_error * signature;
    disturbances = scale.asDiagonal() * disturbances;
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

// What a fit leaves, by kind, at usual sizes.
model::Left leftAtUsualSizes(const Calibration& car, const std::vector<DriveProducts>& products) {
    Sizes usual;
    usual.fill(1);
    return model::leftBy(car.uncertainty, products, usual, car.problem.replays.threads);
}

// Products of a fit with the error of the signatures in place of the residual.
std::vector<DriveProducts> ofSignatureError(const Calibration& car, const Fit& fit) {
    std::vector<DriveProducts> products = fit.products;
    const Eigen::VectorXd error = car.structure_error * fit.at(fit.knobs);
    for (DriveProducts& one : products)
        one.mixed.rightCols(1) = one.mixed.middleCols(fit.nuisances(), error.size()) * error;
    return products;
}

// The same of the estimated errors of the readings, by kind (D33f): motion that the other channels show as well does
// not hide them. No eigenvalue of their covariance exceeds 1, so that the variance is at most twice the mean. The error
// of the signatures adds to both, as one normal number, which has the largest variance.
std::vector<double> chancesOfReadings(const Calibration& car, const Fit& fit) {
    const model::Left left = leftAtUsualSizes(car, fit.products),
                      by_signatures = leftAtUsualSizes(car, ofSignatureError(car, fit));
    std::vector<double> chances;
    for (const model::Disturbed kind : model::kAllDisturbed) {
        const std::size_t k = placeOf(kind);
        if (!model::isInstruments(kind) || left.determined[k] == 0) continue;
        const double by_chance = std::max(1.0, left.determined[k]), error = by_signatures.squares[k];
        chances.push_back(chanceOf(left.squares[k], by_chance + error, 2 * (by_chance + error * error)));
    }
    return chances;
}

}  // namespace

double chanceOfGap(const Calibration& car, const Fit& fit, const Rows& rows) {
    const std::vector<Eigen::VectorXd> signatures = changedByEffects(fit);
    const Eigen::MatrixXd root = fit.covariance.llt().matrixL();
    std::vector<Moments> drives(rows.size());
    std::vector<std::vector<Gap>> of_channels(rows.size());
    inParallel(rows.size(), car.problem.replays.threads, [&](std::size_t d) {
        Gap all;
        for (const Block& block : blocksOf(car, fit, rows, signatures[d], root, d)) {
            of_channels[d].emplace_back().add(block);
            all.add(block);
        }
        drives[d].add(all);
    });
    std::map<std::string, Moments> channels;
    for (std::size_t d = 0; d < rows.size(); ++d)
        for (std::size_t c = 0; c < of_channels[d].size(); ++c)
            channels[car.drives()[d].channels[c].name].add(of_channels[d][c]);
    std::vector<double> chances = chancesOfReadings(car, fit);
    for (const Moments& one : drives) chances.push_back(one.chance());
    for (const auto& [name, one] : channels) chances.push_back(one.chance());
    const double least = *std::min_element(chances.begin(), chances.end());
    return std::min(1.0, least * static_cast<double>(chances.size()));
}

}  // namespace tread::diagnose::select
