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
    std::vector<Eigen::Index> knobs, free, imperfections;
    Eigen::VectorXd lowest, highest;               // bounds of `free`
    std::vector<model::Part> parts;                // of each imperfection
    std::vector<Eigen::MatrixXd> by_imperfection;  // per drive: change of the rows per typical size

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

    std::size_t part(Eigen::Index i) const { return static_cast<std::size_t>(parts[i]); }
    Eigen::VectorXd each(const model::Imperfection& sizes) const {
        Eigen::VectorXd all(std::ssize(imperfections));
        for (Eigen::Index i = 0; i < all.size(); ++i) all(i) = sizes[part(i)];
        return all;
    }

    // Rows of the model with its imperfections (D16b).
    Rows imperfect(Rows rows, const Deviation& at, const model::Imperfection& sizes) const {
        const Eigen::VectorXd by = each(sizes).cwiseProduct(at(imperfections));
        for (std::size_t d = 0; d < rows.size(); ++d) rows[d] += by_imperfection[d] * by;
        return rows;
    }

    // Gives the imperfections of a fit other sizes; its rows stay.
    void scale(Fit& fit, const model::Imperfection& sizes) const {
        Eigen::VectorXd factor = Eigen::VectorXd::Ones(std::ssize(fit.free) + 1);  // of the columns and the residual
        factor.segment(fit.numbers(), std::ssize(imperfections)) = each(sizes).cwiseQuotient(each(fit.imperfection));
        const auto by = factor.asDiagonal();
        fit.imperfection = sizes;
        fit.at(fit.free).array() /= factor.head(std::ssize(fit.free)).array();
        for (std::size_t d = 0; d < fit.columns.size(); ++d) {
            fit.columns[d] = (fit.columns[d] * factor.head(std::ssize(fit.free)).asDiagonal()).eval();
            fit.products[d].columns = (by * fit.products[d].columns * by).eval();
            fit.products[d].mixed = (fit.products[d].mixed * by).eval();
        }
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
    void learn(Fit& fit, const Rows& after, Eigen::VectorXd step) const {
        step.segment(fit.numbers(), std::ssize(imperfections)).setZero();  // the model is linear in these
        if (step.squaredNorm() < kTooShort) return;
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            const Eigen::VectorXd change = uncertainty.noise[d].over(after[d] - fit.of_car[d]);
            const Eigen::VectorXd by = (change - fit.columns[d] * step) / step.squaredNorm();
            inference::updateByRankOne(fit.products[d], fit.columns[d],
                                       model::residual(drives, uncertainty, fit.rows, d), uncertainty.directions[d], by,
                                       step);
            fit.columns[d] += by * step.transpose();
        });
    }

    void moveTo(Fit& fit, const Deviation& at, Rows of_car) const {
        fit.at = at, fit.of_car = std::move(of_car);
        fit.rows = imperfect(fit.of_car, at, fit.imperfection);
        inParallel(drives.size(), replays.threads, [&](std::size_t d) {
            inference::replaceLast(fit.products[d], fit.columns[d], model::residual(drives, uncertainty, fit.rows, d),
                                   uncertainty.directions[d]);
        });
    }
};

Fitter fitterOf(const Replays& replays, Drives drives, const Uncertainty& uncertainty,
                const Linearisation& linearisation, const std::vector<Eigen::Index>& knobs) {
    Fitter fitter{replays, drives, uncertainty, knobs, {}, {}, {}, {}, {}, {}};
    std::vector<Eigen::Index> moving;  // knobs along which the model is imperfect
    for (const Eigen::Index i : linearisation.imperfections) {
        const Eigen::Index knob = replays.parameters[i].imperfection_of;
        if (std::find(knobs.begin(), knobs.end(), knob) != knobs.end()) continue;
        fitter.imperfections.push_back(i), moving.push_back(knob);
        fitter.parts.push_back(model::partOf(replays.parameters[knob].path()));
    }
    for (const Eigen::MatrixXd& columns : linearisation.about.columns)
        fitter.by_imperfection.emplace_back(columns(Eigen::all, moving));
    fitter.free = model::joined(model::joined(linearisation.nuisances, fitter.imperfections), knobs);
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
        const double now =
            there ? fitter.misfit(fitter.imperfect(*there, next, fit.imperfection), next, metric, fit.prior)
                  : kInfinity;
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

// Sizes of the imperfections closer to the largest evidence (D26b).
model::Imperfection improved(const Fit& fit, const Fitter& fitter, const inference::QuadraticModel& here) {
    const Eigen::Index all = std::ssize(fit.free);
    const Eigen::MatrixXd covariance =
        inference::factorOfPriorAnd(here.information).solve(Eigen::MatrixXd::Identity(all, all));
    model::ImperfectionsLeft left;
    for (Eigen::Index i = 0; i < std::ssize(fit.imperfections); ++i) {
        const Eigen::Index place = fit.numbers() + i;
        const std::size_t part = fitter.part(i);
        left.squares[part] += here.at(place) * here.at(place);
        left.determined[part] += 1 - covariance(place, place);
        left.present[part] = true;
    }
    return model::improved(fit.imperfection, left);
}

// Moves the imperfections of a fit to their best point beside its numbers. The model is linear in them.
void moveImperfections(Fit& fit, const Fitter& fitter, const inference::QuadraticModel& here) {
    const Eigen::Index first = fit.numbers(), n = std::ssize(fit.imperfections);
    const Eigen::VectorXd gradient = (here.gradient - here.at).segment(first, n);
    Deviation at = fit.at;
    at(fit.imperfections) += inference::factorOfPriorAnd(here.information.block(first, first, n, n)).solve(gradient);
    fitter.moveTo(fit, at, std::move(fit.of_car));
}

// Moves the sizes of the imperfections towards the largest evidence. True when they have settled.
bool resizeImperfections(Fit& fit, const Fitter& fitter) {
    if (fit.imperfections.empty()) return true;
    const std::vector<inference::Metric> metric = fitter.metrics(fit.sizes);
    const model::Imperfection before = fit.imperfection;
    for (int i = 0; i < kSizeSteps; ++i) {
        const model::Imperfection last = fit.imperfection;
        fitter.scale(fit, improved(fit, fitter, quadraticIn(fit, metric)));
        moveImperfections(fit, fitter, quadraticIn(fit, metric));
        if (model::changeOf(last, fit.imperfection) < kSizesSettled) break;
    }
    return model::changeOf(before, fit.imperfection) < kSizesSettled;
}

// Moves the sizes towards what the fit leaves at its point. True when they have settled.
bool resize(Fit& fit, const Fitter& fitter) {
    const Sizes before = fit.sizes;
    const bool settled = resizeImperfections(fit, fitter);
    for (int i = 0; i < kSizeSteps; ++i) {
        const Sizes last = fit.sizes;
        fit.sizes = model::improvedSizes(fitter.uncertainty, fit.products, last, fitter.replays.threads);
        if (model::changeOf(last, fit.sizes) < kSizesSettled) break;
    }
    return settled && model::changeOf(before, fit.sizes) < kSizesSettled;
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
    const Fitter fitter = fitterOf(replays, drives, uncertainty, linearisation, knobs);
    Fit fit;
    fit.free = fitter.free, fit.knobs = knobs, fit.imperfections = fitter.imperfections;
    fit.imperfection = model::usualImperfection();
    fit.at = start;
    for (const Eigen::Index i : linearisation.imperfections)
        if (std::find(fit.imperfections.begin(), fit.imperfections.end(), i) == fit.imperfections.end()) fit.at(i) = 0;
    fit.of_car = std::move(*rows);
    fit.rows = fitter.imperfect(fit.of_car, fit.at, fit.imperfection);
    for (std::size_t d = 0; d < drives.size(); ++d) {
        fit.columns.push_back(uncertainty.noise[d].over(linearisation.about.columns[d](Eigen::all, fit.free)));
        fit.columns[d].middleCols(fit.numbers(), std::ssize(fit.imperfections)) =
            uncertainty.noise[d].over(fitter.by_imperfection[d]) * fitter.each(fit.imperfection).asDiagonal();
    }
    fit.sizes = uncertainty.sizes, fit.prior = prior;
    if (remainder == Remainder::usual) fit.sizes.fill(1);
    fit.products = fitter.products(fit.rows, fit.columns);
    climb(fit, fitter, knobs.empty());
    if (remainder == Remainder::estimated)
        for (int turn = 0; turn < kMostTurns && !resize(fit, fitter); ++turn) climb(fit, fitter, true);
    const inference::QuadraticModel here = quadraticAt(fit, uncertainty);
    const Eigen::Index n = std::ssize(fit.free);
    fit.covariance = inference::factorOfPriorAnd(here.information).solve(Eigen::MatrixXd::Identity(n, n));
    fit.log_evidence = inference::logEvidence(here, Eigen::VectorXd::Zero(n)) +
                       model::logPrior(fit.sizes, model::kWidePrior) + model::logPrior(fit.imperfection);
    return fit;
}

}  // namespace tread::diagnose::select
