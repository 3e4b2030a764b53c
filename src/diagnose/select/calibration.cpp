#include "diagnose/select/calibration.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/parallel.h"
#include "diagnose/model/gap.h"
#include "diagnose/model/remainder.h"
#include "run/simulate.h"

namespace tread::diagnose::select {
namespace {

constexpr int kMostFits = 2;        // fits after a new linearisation, which costs up to a replay per drive and nuisance
constexpr double kFitSettled = 15;  // nats; the linearisation is not renewed after a fit that gained less

const double kTolerance = std::sqrt(3.0);  // units; the half-width of the uniform distribution with variance 1

constexpr int kFreeSizeSteps = 12;          // steps of the iteration for the sizes with all parameters free
constexpr double kFreeSizesSettled = 0.05;  // change of the logarithm of a size at which it ends

// The best fit of the nuisances from these starts.
Fit fitFrom(const Problem& problem, const Uncertainty& uncertainty, const Linearisation& about,
            const std::vector<Start>& starts) {
    std::vector<std::optional<Fit>> found(starts.size());
    inParallel(starts.size(), problem.replays.threads, [&](std::size_t i) {
        found[i] = fitted(problem.replays, problem.drives, uncertainty, about, {}, starts[i]);
    });
    std::optional<Fit> best;
    for (std::optional<Fit>& one : found)
        if (one && (!best || one->log_evidence > best->log_evidence)) best = std::move(one);
    if (!best)
        throw SimulationError(
            "the simulation of the nominal car in the recordings fails; check the vehicle file and the recorded inputs",
            0);
    return std::move(*best);
}

// The evidence of a model may have two maxima: a large remainder, or numbers that moved far. A fit with the sizes of
// the uncertainty finds one, a fit with the usual sizes the other.
std::vector<Start> bothFrom(const Deviation& at) {
    Sizes usual;
    usual.fill(1);
    return {{at}, {at, usual}};
}

// The linearisation of the calibration with the columns of all knobs added. Knobs that move uncertain numbers only are
// mixtures of the nuisances' columns and need no replay.
model::Sensitivities withKnobs(const Calibration& car, const std::function<void(double)>& progress) {
    const Problem& problem = car.problem;
    std::vector<Eigen::Index> own, mixed;
    for (const Eigen::Index knob : problem.allKnobs())
        (car.asNuisances(problem.replays.parameters[knob]).empty() ? own : mixed).push_back(knob);
    model::Wanted wanted{
        .parameters = own, .step = model::kEffectStep, .elsewhere = &car.about.about, .rows = &car.fit.of_car};
    if (car.together) {
        std::vector<bool> others = car.together->further;
        others.flip();
        wanted.worth = model::onlyIn(others, own.size());
    }
    model::Sensitivities about = model::sensitivities(problem.replays, problem.drives, car.fit.at, wanted, progress);
    if (car.together) {
        wanted.worth = model::onlyIn(car.together->further, own.size());
        wanted.elsewhere = &about;
        wanted.rows = nullptr;
        about.columns =
            model::sensitivities(problem.replays, problem.drives, car.together->at, wanted, progress).columns;
    }
    for (Eigen::MatrixXd& columns : about.columns) {
        for (const Eigen::Index knob : mixed) {
            columns.col(knob).setZero();
            for (const model::Share& share : car.asNuisances(problem.replays.parameters[knob]))
                columns.col(knob) += share.units * columns.col(share.of);
        }
    }
    return about;
}

// The products of a model whose parameters are at their best point: the residual loses what the parameters explain.
// Bounds are ignored.
std::vector<DriveProducts> atBest(const Uncertainty& uncertainty, std::vector<DriveProducts> products,
                                  const Sizes& sizes, int threads) {
    const model::NormalEquations sum = model::normalEquations(uncertainty, products, sizes, threads);
    const Eigen::Index n = sum.products.cols() - 1;
    const Eigen::VectorXd best =
        inference::factorOfPriorAnd(sum.products.topLeftCorner(n, n)).solve(sum.products.topRightCorner(n, 1));
    for (DriveProducts& one : products) {
        // C' = M'C M and m' = m M for the identity M but for its last column (-best, 1).
        const Eigen::VectorXd all = one.columns.leftCols(n) * best;
        const Eigen::VectorXd explained = all.head(n);
        one.columns(n, n) += best.dot(explained) - 2 * all(n);
        one.columns.topRightCorner(n, 1) -= explained;
        one.columns.bottomLeftCorner(1, n) = one.columns.topRightCorner(n, 1).transpose();
        one.mixed.rightCols(1) -= one.mixed.leftCols(n) * best;
    }
    return products;
}

// Compares the drives until the car with the effect that keeps them together slides apart.
void compareFurther(Calibration& car) {
    const Problem& problem = car.problem;
    const Deviation& at = car.together->at;
    const std::vector<Eigen::Index> relevant = model::joined(car.about.nuisances, problem.of_both);
    model::Sensitivities about = model::sensitivities(problem.replays, problem.drives, at,
                                                      {.parameters = relevant,
                                                       .worth = model::onlyIn(car.together->further, relevant.size()),
                                                       .elsewhere = &car.about.about});
    for (std::size_t d = 0; d < about.rows.size(); ++d)
        if (!car.together->further[d]) about.rows[d] = car.fit.rows[d];
    car.uncertainty = model::uncertaintyAt(problem.replays, problem.drives, at, about.rows,
                                           model::endsOf(problem.drives), &car.uncertainty, car.together->further);
    car.uncertainty.sizes = car.fit.sizes;
    car.about = model::linearisation(std::move(about), relevant, {}, car.uncertainty, problem.replays.threads);
    car.fit = fitFrom(problem, car.uncertainty, car.about, bothFrom(car.fit.at));
}

// Finds the closest car: the nominal one where no other within its tolerances leaves a smaller gap.
void findClosest(Calibration& car) {
    const auto levelOf = [&](const Rows& rows) { return model::levelOf(car.drives(), car.uncertainty, rows); };
    car.of_gap = model::weightedAsTheGap(car.uncertainty, car.drives());
    car.closest = {car.problem.replays.origin(), car.nominal};
    std::optional<Closest> within = closestTo(car, car.fit.at, {});
    if (within && levelOf(within->rows) < levelOf(car.nominal)) car.closest = std::move(*within);
}

// Imperfections that can change an answer.
std::vector<Eigen::Index> relevantImperfections(const Calibration& car) {
    constexpr double kNegligible = 1;  // nats of an effect at its typical size
    const model::NormalEquations sum =
        model::normalEquations(car.uncertainty, car.products, car.uncertainty.sizes, car.problem.replays.threads);
    const Eigen::Index first = std::ssize(car.about.nuisances);
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < car.problem.imperfections.size(); ++i) {
        const Eigen::Index place = first + static_cast<Eigen::Index>(i);
        const Eigen::Index imperfection = car.problem.imperfections[i];
        const Parameter& knob =
            car.problem.replays.parameters[car.problem.replays.parameters[imperfection].imperfection_of];
        const bool there_or_not = knob.highest - knob.lowest <= 1;  // as a controller
        if (!there_or_not && 0.5 * sum.products(place, place) > kNegligible) kept.push_back(imperfection);
    }
    return kept;
}

}  // namespace

std::vector<model::Share> Calibration::asNuisances(const Parameter& parameter) const {
    return model::mixture(parameter, problem.replays.parameters, about.nuisances);
}

SharedLinearisation linearisedAt(const Calibration& car, const Fit& fit) {
    return std::make_shared<const Linearisation>(model::relinearised(
        car.about,
        model::nuisancesAt(car.problem.replays, car.drives(), fit.at, &fit.of_car, car.about, car.uncertainty),
        car.uncertainty, car.problem.replays.threads));
}

Replays withinTolerances(const Calibration& car) {
    Replays within = car.problem.replays;
    for (const Eigen::Index i : car.about.nuisances) {
        Parameter& one = within.parameters[i];
        one.lowest = std::max(one.lowest, -kTolerance), one.highest = std::min(one.highest, kTolerance);
    }
    return within;
}

Deviation clamped(Deviation at, const std::vector<Eigen::Index>& some, const std::vector<Parameter>& parameters) {
    for (const Eigen::Index i : some) at(i) = std::clamp(at(i), parameters[i].lowest, parameters[i].highest);
    return at;
}

std::optional<Closest> closestTo(const Calibration& car, const Deviation& at, const std::vector<Eigen::Index>& knobs) {
    const Replays within = withinTolerances(car);
    const Start from{.at = clamped(at, car.about.nuisances, within.parameters), .is_end = true};
    const Linearisation about =
        model::linearisation(car.about.about, car.about.nuisances, knobs, car.of_gap, within.threads);
    std::optional<Fit> fit =
        fitted(within, car.drives(), car.of_gap, about, knobs, from, SizePrior::none, Remainder::usual);
    if (!fit) return std::nullopt;
    return Closest{std::move(fit->at), std::move(fit->rows)};
}

Calibration calibrate(const Problem& problem, model::NominalCar nominal, const Progress& progress) {
    progress(0, "fitting tolerances");
    Calibration car{problem,
                    nominal.about.about.rows,
                    std::move(nominal.allowed),
                    std::move(nominal.uncertainty),
                    std::move(nominal.about),
                    {},
                    {}};
    car.uncertainty.sizes = model::sizesAt(problem.drives, car.uncertainty, car.nominal, problem.replays.threads);
    car.fit = fitFrom(problem, car.uncertainty, car.about, bothFrom(problem.replays.origin()));
    std::vector<Eigen::Index> relevant = car.about.nuisances;
    for (int round = 0; round < kMostFits; ++round) {
        model::Sensitivities about = model::nuisancesAt(
            problem.replays, problem.drives, car.fit.at, &car.fit.of_car, car.about, car.uncertainty,
            [&](double share) {
                progress(0.5 * (round + share) / kMostFits, "sensitivities to tolerances at their fitted values");
            });
        car.uncertainty = model::uncertaintyAt(problem.replays, problem.drives, about.at, about.rows,
                                               car.uncertainty.until, round > 0 ? &car.uncertainty : nullptr);
        car.uncertainty.sizes = car.fit.sizes;
        car.about = model::linearisation(std::move(about), relevant, {}, car.uncertainty, problem.replays.threads);
        car.fit = fitFrom(problem, car.uncertainty, car.about, {endOf(car.fit)});
        if (car.fit.gained < kFitSettled) break;
    }
    car.together = keptTogether(car);
    if (car.together) {
        compareFurther(car);
        relevant = car.about.nuisances;
    }
    model::Sensitivities with_knobs =
        withKnobs(car, [&](double share) { progress(0.5 + 0.5 * share, "sensitivities to effects"); });
    car.about = model::linearisation(std::move(with_knobs), relevant, problem.allKnobs(), car.uncertainty,
                                     problem.replays.threads);
    car.products = model::productsWithResidual(problem.drives, car.about, car.uncertainty);
    car.uncertainty.sizes = car.fit.sizes;
    car.uncertainty.sizes = sizesWithAllFree(problem, car.uncertainty, car.products);
    findClosest(car);
    car.about.imperfections = relevantImperfections(car);
    car.fit = fitFrom(problem, car.uncertainty, car.about, bothFrom(car.fit.at));
    return car;
}

Calibration uncalibrated(const Problem& problem, model::NominalCar nominal, const Progress& progress) {
    Calibration car{problem,
                    nominal.about.about.rows,
                    std::move(nominal.allowed),
                    std::move(nominal.uncertainty),
                    std::move(nominal.about),
                    {},
                    {}};
    const std::vector<Eigen::Index> relevant = car.about.nuisances;
    car.fit.free = relevant;
    car.fit.at = problem.replays.origin();
    car.fit.rows = car.fit.of_car = car.nominal;
    car.fit.columns = car.about.columns, car.fit.products = car.about.products;
    model::Sensitivities with_knobs =
        withKnobs(car, [&](double share) { progress(share, "sensitivities to effects"); });
    car.about = model::linearisation(std::move(with_knobs), relevant, problem.allKnobs(), car.uncertainty,
                                     problem.replays.threads);
    car.products = model::productsWithResidual(problem.drives, car.about, car.uncertainty);
    return car;
}

Sizes sizesWithAllFree(const Problem& problem, const Uncertainty& uncertainty,
                       const std::vector<DriveProducts>& products) {
    const int threads = problem.replays.threads;
    Sizes sizes = uncertainty.sizes;
    for (int i = 0; i < kFreeSizeSteps; ++i) {
        const Sizes last = sizes;
        sizes = model::improvedSizes(uncertainty, atBest(uncertainty, products, last, threads), last, threads);
        if (model::changeOf(last, sizes) < kFreeSizesSettled) break;
    }
    return sizes;
}

}  // namespace tread::diagnose::select
