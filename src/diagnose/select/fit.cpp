#include "diagnose/select/fit.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

// Trial steps of a fit, and those after which the columns of the knobs are computed again at the latest.
constexpr int kMostTrials = 14, kTrialsBeforeRenewal = 6;
constexpr double kEnough = 0.05;             // nats; the fit has converged when the next step promises less
constexpr double kFirstDamping = 1;          // least damping after a failed step, in units of the prior's information
constexpr double kDamped = 5, kEased = 0.2;  // factors on the damping after a failed and after a successful step
constexpr double kTooShort = 1e-6;  // squared units; a shorter step would amplify rounding errors in Broyden's update

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

    // Negative log posterior, up to constants (D20).
    double misfit(const Rows& rows, const Deviation& at) const {
        const Eigen::VectorXd x = at(free);
        double sum = x.squaredNorm();
        for (std::size_t d = 0; d < rows.size(); ++d)
            sum += model::squaresOf(uncertainty, d, model::residual(drives, uncertainty, rows, d));
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
    void learn(std::vector<Eigen::MatrixXd>& columns, const Rows& before, const Rows& after,
               const Eigen::VectorXd& step) const {
        if (step.squaredNorm() < kTooShort) return;
        for (std::size_t d = 0; d < columns.size(); ++d) {
            const Eigen::VectorXd change = uncertainty.noise[d].over(after[d] - before[d]);
            columns[d] += (change - columns[d] * step) * step.transpose() / step.squaredNorm();
        }
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

// Moves the fit from its start to the maximum of the posterior: updates point, rows, columns and products.
void climb(Fit& fit, const Fitter& fitter) {
    double misfit = fitter.misfit(fit.rows, fit.at), damping = 0;
    const double at_start = misfit;
    bool renewed = fitter.knobs.empty();
    for (int trial = 0;; ++trial) {
        fit.products = fitter.products(fit.rows, fit.columns);
        const inference::QuadraticModel here = quadraticAt(fit, fitter.uncertainty, fitter.uncertainty.sizes);
        const Eigen::VectorXd step = inference::boundedStep(here, damping, fitter.lowest, fitter.highest);
        fit.converged = inference::gainOf(here, step) < kEnough;
        const bool settled = fit.converged || trial >= kMostTrials;
        if (settled && renewed) break;
        if (settled || (!renewed && trial == kTrialsBeforeRenewal)) {
            fitter.renewKnobs(fit.columns, fit.at);
            renewed = true, damping = 0;
            continue;
        }
        Deviation next = fit.at;
        next(fit.free) = here.at + step;
        std::optional<Rows> there = model::rowsAt(fitter.replays, fitter.drives, next);
        if (there) fitter.learn(fit.columns, fit.rows, *there, step);
        const double now = there ? fitter.misfit(*there, next) : kInfinity;
        if (now < misfit) {
            fit.at = next, fit.rows = std::move(*there), misfit = now;
            damping *= kEased;
        } else {
            damping = std::max(kFirstDamping, kDamped * damping);
        }
    }
    fit.gained = at_start - misfit;
}

}  // namespace

inference::QuadraticModel quadraticAt(const Fit& fit, const Uncertainty& uncertainty, const Sizes& sizes) {
    const model::NormalEquations sum = model::normalEquations(uncertainty, fit.products, sizes);
    const Eigen::Index n = std::ssize(fit.free);
    return {.information = sum.products.topLeftCorner(n, n),
            .gradient = sum.products.topRightCorner(n, 1),
            .at = fit.at(fit.free),
            .squared_residual = sum.products(n, n),
            .log_determinant = sum.log_determinant};
}

double logEvidence(const Fit& fit, const Uncertainty& uncertainty, const Sizes& sizes) {
    const inference::QuadraticModel here = quadraticAt(fit, uncertainty, sizes);
    return inference::logEvidence(here, inference::bestStep(here));
}

std::optional<Fit> fitted(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                          const Linearisation& linearisation, const std::vector<Eigen::Index>& knobs,
                          const Deviation& start) {
    std::optional<Rows> rows = model::rowsAt(replays, drives, start);
    if (!rows) return std::nullopt;
    const Fitter fitter = fitterOf(replays, drives, uncertainty, linearisation.nuisances, knobs);
    Fit fit;
    fit.free = fitter.free, fit.knobs = knobs, fit.at = start, fit.rows = std::move(*rows);
    for (std::size_t d = 0; d < drives.size(); ++d)
        fit.columns.push_back(uncertainty.noise[d].over(linearisation.about.columns[d](Eigen::all, fit.free)));
    climb(fit, fitter);
    const inference::QuadraticModel here = quadraticAt(fit, uncertainty, uncertainty.sizes);
    const Eigen::Index n = std::ssize(fit.free);
    fit.covariance = inference::factorOfPriorAnd(here.information).solve(Eigen::MatrixXd::Identity(n, n));
    fit.log_evidence = inference::logEvidence(here, Eigen::VectorXd::Zero(n));
    return fit;
}

}  // namespace tread::diagnose::select
