#include "diagnose/select/fit.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "diagnose/model/remainder.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

// Trial steps of a fit, and those after which the columns of the knobs are computed again at the latest.
constexpr int kMostTrials = 14, kTrialsBeforeRenewal = 6;
constexpr double kEnough = 0.05;             // nats; the fit has converged when the next step promises less
constexpr double kFirstDamping = 1;          // least damping after a failed step, in units of the prior's information
constexpr double kDamped = 5, kEased = 0.2;  // factors on the damping after a failed and after a successful step
constexpr double kTooShort = 1e-6;  // squared units; a shorter step would amplify rounding errors in Broyden's update

// Information of the prior of an effect's size where it takes no part: a standard deviation of 20 typical sizes, so
// that what the data do not determine stays bounded.
constexpr double kLeastPrior = 1.0 / 400;

// Times that sizes and point are fitted in turn, steps towards the sizes in each, and the change of the logarithm of a
// size below which they have settled.
constexpr int kMostTurns = 6, kSizeSteps = 3;
constexpr double kSizesSettled = 0.1;

// The problem of one fit, apart from the point.
struct Fitter {
    const Replays& replays;
    Drives drives;
    const Uncertainty& uncertainty;
    std::vector<Eigen::Index> knobs, free;
    Eigen::VectorXd lowest, highest;  // bounds of `free`

    std::vector<DriveProducts> products(const Rows& rows, const std::vector<Eigen::MatrixXd>& columns) const {
        std::vector<DriveProducts> all(rows.size());
        inParallel(rows.size(), replays.threads, [&](std::size_t d) {
            Eigen::MatrixXd further(rows[d].size(), columns[d].cols() + 1);
            further.leftCols(columns[d].cols()) = columns[d];
            further.rightCols(1) = model::residual(drives, uncertainty, rows, d);
            all[d] = model::productsOf(uncertainty, d, further);
        });
        return all;
    }

    std::vector<inference::Metric> metrics(const Sizes& sizes) const {
        std::vector<inference::Metric> all(drives.size());
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            all[d] = inference::metricOf(uncertainty.bare[d].disturbances, uncertainty.sizesOf(d, sizes));
        });
        return all;
    }

    // Negative log posterior, up to constants (D20).
    double misfit(const Rows& rows, const Deviation& at, const std::vector<inference::Metric>& metric,
                  SizePrior prior) const {
        double sum = at(free).squaredNorm();
        if (prior == SizePrior::none) sum -= (1 - kLeastPrior) * at(knobs).squaredNorm();
        for (std::size_t d = 0; d < rows.size(); ++d) {
            const Eigen::VectorXd left = model::residual(drives, uncertainty, rows, d);
            sum += inference::squaresIn(metric[d], left, uncertainty.directions[d].transpose() * left);
        }
        return 0.5 * sum;
    }

    // Computes the columns of the knobs again by finite differences.
    void renewKnobs(std::vector<Eigen::MatrixXd>& columns, const Deviation& at) const {
        const model::Sensitivities here =
            model::sensitivities(replays, drives, at, {.parameters = knobs, .step = model::kEffectStep});
        for (std::size_t d = 0; d < columns.size(); ++d) {
            auto last = columns[d].rightCols(std::ssize(knobs));
            last = uncertainty.noise[d].over(here.columns[d](Eigen::all, knobs));
        }
    }

    // Broyden's update: corrects the columns along a step by the change of rows that it caused (D19).
    void learn(Fit& fit, const Rows& after, const Eigen::VectorXd& step) const {
        if (step.squaredNorm() < kTooShort) return;
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            const Eigen::VectorXd change = uncertainty.noise[d].over(after[d] - fit.rows[d]);
            const Eigen::VectorXd by = (change - fit.columns[d] * step) / step.squaredNorm();
            inference::updateByRankOne(fit.products[d], fit.columns[d],
                                       model::residual(drives, uncertainty, fit.rows, d), uncertainty.directions[d], by,
                                       step);
            fit.columns[d] += by * step.transpose();
        });
    }

    void moveTo(Fit& fit, const Deviation& at, Rows rows) const {
        fit.at = at, fit.rows = std::move(rows);
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            inference::replaceLast(fit.products[d], fit.columns[d], model::residual(drives, uncertainty, fit.rows, d),
                                   uncertainty.directions[d]);
        });
    }
};

Fitter fitterOf(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                const std::vector<Eigen::Index>& nuisances, const std::vector<Eigen::Index>& knobs) {
    Fitter fitter{replays, drives, uncertainty, knobs, model::joined(nuisances, knobs), {}, {}};
    const Eigen::Index n = std::ssize(fitter.free);
    fitter.lowest.resize(n), fitter.highest.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const model::Parameter& parameter = replays.parameters[fitter.free[i]];
        fitter.lowest(i) = parameter.lowest, fitter.highest(i) = parameter.highest;
    }
    return fitter;
}

inference::QuadraticModel quadraticIn(const Fit& fit, const std::vector<inference::Metric>& metric) {
    model::NormalEquations sum;
    for (std::size_t d = 0; d < metric.size(); ++d)
        sum = std::move(sum) + inference::normalEquations(fit.products[d], metric[d]);
    const Eigen::Index n = std::ssize(fit.free), knobs = std::ssize(fit.knobs);
    inference::QuadraticModel model{.information = sum.products.topLeftCorner(n, n),
                                    .gradient = sum.products.topRightCorner(n, 1),
                                    .at = fit.at(fit.free),
                                    .squared_residual = sum.products(n, n),
                                    .log_determinant = sum.log_determinant};
    if (fit.prior == SizePrior::none) {
        // Takes the prior of the knobs out of what the model adds to information and gradient.
        model.information.diagonal().tail(knobs).array() -= 1 - kLeastPrior;
        model.gradient.tail(knobs) += (1 - kLeastPrior) * model.at.tail(knobs);
    }
    return model;
}

// Moves the fit from its start to the maximum of the posterior with its sizes: updates point, rows, columns and
// products.
void climb(Fit& fit, const Fitter& fitter, bool renewed) {
    const std::vector<inference::Metric> metric = fitter.metrics(fit.sizes);
    double misfit = fitter.misfit(fit.rows, fit.at, metric, fit.prior), damping = 0;
    const double at_start = misfit;
    for (int trial = 0;; ++trial) {
        const inference::QuadraticModel here = quadraticIn(fit, metric);
        const Eigen::VectorXd step = inference::boundedStep(here, damping, fitter.lowest, fitter.highest);
        fit.converged = inference::gainOf(here, step) < kEnough;
        const bool settled = fit.converged || trial >= kMostTrials;
        if (settled && renewed) break;
        if (settled || (!renewed && trial == kTrialsBeforeRenewal)) {
            fitter.renewKnobs(fit.columns, fit.at);
            fit.products = fitter.products(fit.rows, fit.columns);
            renewed = true, damping = 0;
            continue;
        }
        Deviation next = fit.at;
        next(fit.free) = here.at + step;
        std::optional<Rows> there = model::rowsAt(fitter.replays, fitter.drives, next);
        if (there) fitter.learn(fit, *there, step);
        const double now = there ? fitter.misfit(*there, next, metric, fit.prior) : kInfinity;
        if (now < misfit) {
            fitter.moveTo(fit, next, std::move(*there));
            misfit = now;
            damping *= kEased;
        } else {
            damping = std::max(kFirstDamping, kDamped * damping);
        }
    }
    fit.gained += at_start - misfit;
}

// Moves the sizes towards what the fit leaves at its point. True when they have settled.
bool resize(Fit& fit, const Fitter& fitter) {
    const Sizes before = fit.sizes;
    for (int i = 0; i < kSizeSteps; ++i) {
        const Sizes last = fit.sizes;
        fit.sizes = model::improvedSizes(fitter.uncertainty, fit.products, last, fitter.replays.threads);
        if (model::changeOf(last, fit.sizes) < kSizesSettled) break;
    }
    return model::changeOf(before, fit.sizes) < kSizesSettled;
}

}  // namespace

Deviation withoutNuisances(const Fit& fit) {
    Deviation at = fit.at;
    for (Eigen::Index i = 0; i < fit.nuisances(); ++i) at(fit.free[i]) = 0;
    return at;
}

answer::NuisanceEstimate numberOf(const Fit& fit, const Replays& replays, Eigen::Index i) {
    constexpr double kNear = 1e-6;  // units
    const Eigen::Index p = fit.free[i];
    const model::Parameter& parameter = replays.parameters[p];
    const model::Parameter::Move& move = parameter.moves.front();
    const double units = fit.at(p), by = std::abs(move.by);
    return {.value = move.nominal + units * move.by,
            .sd = std::sqrt(fit.covariance(i, i)) * by,
            .nominal = move.nominal,
            .prior_sd = by,
            .z = units,
            .at_bound = units < parameter.lowest + kNear || units > parameter.highest - kNear};
}

inference::QuadraticModel quadraticAt(const Fit& fit, const Uncertainty& uncertainty) {
    std::vector<inference::Metric> metric;
    for (std::size_t d = 0; d < fit.products.size(); ++d)
        metric.push_back(inference::metricOf(fit.products[d].disturbances, uncertainty.sizesOf(d, fit.sizes)));
    return quadraticIn(fit, metric);
}

std::optional<Fit> fitted(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& linearisation, const std::vector<Eigen::Index>& knobs,
                          const Deviation& start, SizePrior prior, Remainder remainder) {
    std::optional<Rows> rows = model::rowsAt(replays, drives, start);
    if (!rows) return std::nullopt;
    const Fitter fitter = fitterOf(replays, drives, uncertainty, linearisation.nuisances, knobs);
    Fit fit;
    fit.free = fitter.free, fit.knobs = knobs, fit.at = start, fit.rows = std::move(*rows);
    for (std::size_t d = 0; d < drives.size(); ++d)
        fit.columns.push_back(uncertainty.noise[d].over(linearisation.about.columns[d](Eigen::all, fit.free)));
    fit.sizes = uncertainty.sizes, fit.prior = prior;
    if (remainder == Remainder::usual) fit.sizes.fill(1);
    fit.products = fitter.products(fit.rows, fit.columns);
    climb(fit, fitter, knobs.empty());
    if (remainder == Remainder::estimated)
        for (int turn = 0; turn < kMostTurns && !resize(fit, fitter); ++turn) climb(fit, fitter, true);
    const inference::QuadraticModel here = quadraticAt(fit, uncertainty);
    const Eigen::Index n = std::ssize(fit.free);
    fit.covariance = inference::factorOfPriorAnd(here.information).solve(Eigen::MatrixXd::Identity(n, n));
    fit.log_evidence =
        inference::logEvidence(here, Eigen::VectorXd::Zero(n)) + model::logPrior(fit.sizes, model::kWidePrior);
    return fit;
}

}  // namespace tread::diagnose::select
