#include "diagnose/fit.h"

#include <algorithm>
#include <cmath>

#include "identify/bounded_step.h"
#include "identify/parallel.h"

namespace tread {
namespace {

constexpr double kStartSpeed = 0.1;  // m/s, standard deviation of the speed at the start, as measured
constexpr int kMostTrials = 14, kTrialsBeforeRenewal = 6;
constexpr double kEnough = 0.05;     // nats: a step that promises less is not taken
constexpr double kFirstDamping = 1;  // of a step that did not help, as so many times the prior's information
constexpr double kDamped = 5, kEased = 0.2;
constexpr double kTooShort = 1e-6;  // squared units, of a step from which nothing is learnt

double logDeterminant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
    return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

DriveGram withColumns(const Uncertainty& uncertainty, std::size_t drive, const Eigen::MatrixXd& columns) {
    return extended(uncertainty.bare[drive], Eigen::MatrixXd(columns.rows(), 0), uncertainty.directions[drive],
                    columns);
}

struct Model {
    Bench& bench;
    const Uncertainty& uncertainty;
    std::vector<Eigen::Index> knobs, free;

    // Products at a point: the columns of the free parameters, then the residual.
    std::vector<DriveGram> grams(const Rows& rows, const std::vector<Eigen::MatrixXd>& columns) const {
        std::vector<DriveGram> all(rows.size());
        inParallel(rows.size(), bench.threads, [&](std::size_t d) {
            Eigen::MatrixXd further(rows[d].size(), columns[d].cols() + 1);
            further.leftCols(columns[d].cols()) = columns[d];
            further.rightCols(1) = residual(bench, uncertainty, rows, d);
            all[d] = withColumns(uncertainty, d, further);
        });
        return all;
    }

    double misfit(const Rows& rows, const Deviation& at) const {
        double sum = at(free).squaredNorm();
        for (std::size_t d = 0; d < rows.size(); ++d)
            sum += squaresOf(uncertainty, d, residual(bench, uncertainty, rows, d));
        return 0.5 * sum;
    }

    // The knobs' columns anew, by differences.
    void renewKnobs(std::vector<Eigen::MatrixXd>& columns, const Deviation& at) const {
        const Linearised here = linearised(bench, at, {.parameters = knobs, .step = kKnobStep});
        for (std::size_t d = 0; d < columns.size(); ++d) {
            auto last = columns[d].rightCols(static_cast<Eigen::Index>(knobs.size()));
            last = uncertainty.noise[d].over(here.columns[d](Eigen::all, knobs));
        }
    }

    // What a step really changed corrects the columns along it.
    void learn(std::vector<Eigen::MatrixXd>& columns, const Rows& before, const Rows& after,
               const Eigen::VectorXd& step) const {
        if (step.squaredNorm() < kTooShort) return;
        for (std::size_t d = 0; d < columns.size(); ++d) {
            const Eigen::VectorXd change = uncertainty.noise[d].over(after[d] - before[d]);
            columns[d] += (change - columns[d] * step) * step.transpose() / step.squaredNorm();
        }
    }
};

}  // namespace

Eigen::VectorXd Uncertainty::sizesOf(std::size_t drive, const std::array<double, kDisturbances>& with) const {
    const std::vector<Disturbed>& kinds = disturbing[drive].kinds;
    Eigen::VectorXd all(static_cast<Eigen::Index>(kinds.size()) + 1);
    for (std::size_t i = 0; i < kinds.size(); ++i)
        all(static_cast<Eigen::Index>(i)) = with[static_cast<std::size_t>(kinds[i])];
    all(all.size() - 1) = kStartSpeed;
    return all;
}

Ground ground(Linearised about, const std::vector<Eigen::Index>& nuisances, const Uncertainty& uncertainty) {
    Ground ground{std::move(about), nuisances, {}, {}};
    for (std::size_t d = 0; d < uncertainty.noise.size(); ++d) {
        Eigen::MatrixXd columns = uncertainty.noise[d].over(ground.about.columns[d](Eigen::all, nuisances));
        ground.grams.push_back(driveGram(columns, uncertainty.directions[d]));
        ground.columns.push_back(std::move(columns));
    }
    return ground;
}

Eigen::VectorXd residual(const Bench& bench, const Uncertainty& uncertainty, const Rows& rows, std::size_t drive) {
    return uncertainty.noise[drive].over(bench.drives[drive].measured - rows[drive]);
}

double squaresOf(const Uncertainty& uncertainty, std::size_t drive, const Eigen::VectorXd& off) {
    return whitened(withColumns(uncertainty, drive, off), uncertainty.sizesOf(drive, uncertainty.sizes)).products(0, 0);
}

Gram total(const std::vector<DriveGram>& grams, const Uncertainty& uncertainty,
           const std::array<double, kDisturbances>& sizes) {
    Gram sum;
    for (std::size_t d = 0; d < grams.size(); ++d) sum = sum + whitened(grams[d], uncertainty.sizesOf(d, sizes));
    return sum;
}

double logEvidenceOf(const Fit& fit, const Uncertainty& uncertainty, const std::array<double, kDisturbances>& sizes) {
    // About the fitted point: the parameters are there, and may move on as far as the evidence with these sizes asks.
    const Gram gram = total(fit.grams, uncertainty, sizes);
    const Eigen::Index n = gram.products.cols() - 1;
    const Eigen::MatrixXd hessian = Eigen::MatrixXd::Identity(n, n) + gram.products.topLeftCorner(n, n);
    const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
    const Eigen::VectorXd slope = gram.products.topRightCorner(n, 1) - fit.at(fit.free);
    const double misfit = gram.products(n, n) + fit.at(fit.free).squaredNorm() - slope.dot(factor.solve(slope));
    return -0.5 * (misfit + gram.log_determinant + logDeterminant(factor));
}

std::optional<Fit> fitted(Bench& bench, const Uncertainty& uncertainty, const Ground& ground,
                          const std::vector<Eigen::Index>& knobs, const Deviation& start) {
    Model model{bench, uncertainty, knobs, ground.nuisances};
    model.free.insert(model.free.end(), knobs.begin(), knobs.end());
    const auto n = static_cast<Eigen::Index>(model.free.size());
    Eigen::VectorXd lowest(n), highest(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Parameter& parameter =
            bench.parameters[static_cast<std::size_t>(model.free[static_cast<std::size_t>(i)])];
        lowest(i) = parameter.lowest, highest(i) = parameter.highest;
    }

    Fit fit{.free = model.free, .knobs = knobs, .at = start, .rows = {}, .columns = {}, .grams = {}, .covariance = {}};
    std::optional<Rows> rows = rowsAt(bench, start);
    if (!rows) return std::nullopt;
    for (std::size_t d = 0; d < rows->size(); ++d)
        fit.columns.push_back(uncertainty.noise[d].over(ground.about.columns[d](Eigen::all, model.free)));
    double misfit = model.misfit(*rows, start), damping = 0;
    const double at_start = misfit;
    bool renewed = knobs.empty();
    for (int trial = 0;; ++trial) {
        fit.grams = model.grams(*rows, fit.columns);
        const Gram gram = total(fit.grams, uncertainty, uncertainty.sizes);
        const Eigen::MatrixXd information = gram.products.topLeftCorner(n, n);
        const Eigen::VectorXd gradient = gram.products.topRightCorner(n, 1), x = fit.at(fit.free);
        const Eigen::VectorXd step = boundedStep(information, gradient, x, damping, lowest, highest);
        const double promised = step.dot(gradient - x) - 0.5 * (step.squaredNorm() + step.dot(information * step));
        fit.converged = promised < kEnough;
        const bool settled = fit.converged || trial >= kMostTrials;
        if (settled && renewed) break;
        if (settled || (!renewed && trial == kTrialsBeforeRenewal)) {
            model.renewKnobs(fit.columns, fit.at);
            renewed = true, damping = 0;
            continue;
        }
        Deviation next = fit.at;
        next(fit.free) = x + step;
        std::optional<Rows> there = rowsAt(bench, next);
        if (there) model.learn(fit.columns, *rows, *there, step);
        const double now = there ? model.misfit(*there, next) : kInfinity;
        if (now < misfit) {
            fit.at = next, rows = std::move(there), misfit = now;
            damping *= kEased;
        } else {
            damping = std::max(kFirstDamping, kDamped * damping);
        }
    }
    fit.gained = at_start - misfit;
    fit.rows = std::move(*rows);
    const Gram gram = total(fit.grams, uncertainty, uncertainty.sizes);
    const Eigen::MatrixXd hessian = Eigen::MatrixXd::Identity(n, n) + gram.products.topLeftCorner(n, n);
    const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
    fit.covariance = factor.solve(Eigen::MatrixXd::Identity(n, n));
    fit.log_evidence = -misfit - 0.5 * (gram.log_determinant + logDeterminant(factor));
    return fit;
}

}  // namespace tread
