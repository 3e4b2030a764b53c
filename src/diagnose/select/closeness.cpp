#include "diagnose/select/closeness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/parallel.h"
#include "diagnose/model/gap.h"
#include "diagnose/settings.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

constexpr double kSquaresOfANat = 2;  // that noise closes for each nat that it gains

double squaredGapOf(const Calibration& car, const Rows& rows) {
    const std::vector<double> gaps = model::squaredGaps(car.drives(), car.uncertainty, rows);
    return std::accumulate(gaps.begin(), gaps.end(), 0.0);
}

double comparedRowsOf(const Calibration& car) {
    double rows = 0;
    for (std::size_t d = 0; d < car.drives().size(); ++d) rows += model::comparedRows(car.uncertainty, d);
    return rows;
}

// Independent errors in what a model leaves: one per second of each channel, but not more than one per direction of the
// force. Drives that repeat another one have the same errors.
double independentErrors(const Calibration& car) {
    constexpr double kDirections = 4;  // longitudinal, lateral, yaw and roll
    double errors = 0;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        if (recording::firstLike(car.drives(), d) != d) continue;
        const double shown = std::min(1.0, kDirections / static_cast<double>(car.drives()[d].channels.size()));
        errors += shown * model::comparedRows(car.uncertainty, d) * kSettings.block / kErrorLasts;
    }
    return errors;
}

// Squared gap that the errors of the signatures of a set leave, whose closest car has these rows.
double leftBySignatures(const Calibration& car, const Rows& rows) {
    const double explained = std::max(0.0, squaredGapOf(car, car.closest.rows) - squaredGapOf(car, rows));
    return car.structure_error * car.structure_error * explained;
}

// The linear model of the gap about a car. Its columns are those of some numbers, then those of forces without bounds.
struct Near {
    std::vector<Eigen::MatrixXd> columns;  // changes of the rows, per drive
    inference::QuadraticModel model;
    inference::Bounds bounds;

    // Rows after the step of this many first columns that leaves the smallest gap.
    Rows closest(const Rows& rows, Eigen::Index some) const {
        const inference::QuadraticModel own{.information = model.information.topLeftCorner(some, some),
                                            .gradient = model.gradient.head(some),
                                            .at = model.at.head(some)};
        const Eigen::VectorXd step =
            inference::boundedStep(own, 0, {bounds.lowest.head(some), bounds.highest.head(some)});
        Rows moved = rows;
        for (std::size_t d = 0; d < moved.size(); ++d) moved[d] += columns[d].leftCols(some) * step;
        return moved;
    }
};

Near nearTo(const Calibration& car, const std::vector<Eigen::Index>& free, const Closest& here,
            const std::vector<Eigen::MatrixXd>& forces) {
    const Eigen::Index numbers = std::ssize(free), all = numbers + forces.front().cols();
    const inference::Bounds of_numbers = model::boundsOf(withinTolerances(car).parameters, free);
    Near near{.columns = {},
              .model = {},
              .bounds = {Eigen::VectorXd::Constant(all, -kInfinity), Eigen::VectorXd::Constant(all, kInfinity)}};
    near.bounds.lowest.head(numbers) = of_numbers.lowest;
    near.bounds.highest.head(numbers) = of_numbers.highest;
    std::vector<DriveProducts> products;
    for (std::size_t d = 0; d < forces.size(); ++d) {
        Eigen::MatrixXd& columns = near.columns.emplace_back(forces[d].rows(), all);
        columns << car.about.about.columns[d](Eigen::all, free), forces[d];
        Eigen::MatrixXd rows(columns.rows(), all + 1);
        rows << car.of_gap.noise[d].over(columns), model::residual(car.drives(), car.of_gap, here.rows, d);
        products.push_back(model::productsOf(car.of_gap, d, rows));
    }
    Eigen::VectorXd at = Eigen::VectorXd::Zero(all);
    at.head(numbers) = here.at(free);
    near.model = inference::quadraticModel(
        model::normalEquations(car.of_gap, products, car.of_gap.sizes, car.problem.replays.threads), std::move(at));
    return near;
}

}  // namespace

Closest closestWith(const Calibration& car, const std::vector<std::size_t>& effects, const Deviation& at) {
    const std::vector<Eigen::Index> knobs = car.problem.knobsOf(effects);
    const Deviation from = car.problem.withOnly(effects, at);
    Deviation from_closest = car.closest.at;
    from_closest(knobs) = at(knobs);
    std::optional<Closest> best = car.closest, found;
    inParallel(effects.empty() ? 1 : 2, car.problem.replays.threads, [&](std::size_t i) {
        if (i == 0) found = closestTo(car, from, knobs);
        else best = closestTo(car, from_closest, knobs);
    });
    if (found && (!best || squaredGapOf(car, found->rows) < squaredGapOf(car, best->rows))) best = std::move(found);
    if (best) return std::move(*best);
    const std::optional<Rows> rows = model::rowsAt(car.problem.replays, car.drives(), from);
    return rows ? Closest{from, *rows} : car.closest;
}

Closeness closenessOf(const Calibration& car, const std::vector<std::size_t>& effects, const Deviation& at) {
    Closeness result{closestWith(car, effects, at), std::vector<Closest>(effects.size())};
    inParallel(effects.size(), car.problem.replays.threads, [&](std::size_t i) {
        std::vector<std::size_t> others = effects;
        std::erase(others, effects[i]);
        result.without[i] = closestWith(car, others, result.with.at);
    });
    return result;
}

double gapBeyondNoise(const Calibration& car, const Rows& rows) {
    return std::max(0.0, squaredGapOf(car, rows) - comparedRowsOf(car));
}

double scatterOfGap(const Calibration& car) {
    return std::sqrt(2 * comparedRowsOf(car));
}

bool closesByChance(const Calibration& car, const Closeness& closeness) {
    const Rows& rows = closeness.with.rows;
    const double with = squaredGapOf(car, rows);
    const double of_errors = gapBeyondNoise(car, rows) / independentErrors(car);
    return std::any_of(closeness.without.begin(), closeness.without.end(), [&](const Closest& less) {
        const double by_chance = std::max(of_errors, leftBySignatures(car, less.rows));
        // Where nothing is left but noise, the evidence takes it into account.
        if (by_chance == 0) return false;
        return squaredGapOf(car, less.rows) - with <= kSettings.effect * kSquaresOfANat * by_chance;
    });
}

bool forcesCloseByChance(const Calibration& car, const std::vector<std::size_t>& effects, const Closest& with,
                         const std::vector<Eigen::MatrixXd>& changes) {
    const std::vector<Eigen::Index> free = model::joined(car.about.nuisances, car.problem.knobsOf(effects));
    const Near near = nearTo(car, free, with, changes);
    const Rows beside = near.closest(with.rows, near.model.at.size());
    const Rows own = near.closest(with.rows, std::ssize(free));
    const double closed = squaredGapOf(car, own) - squaredGapOf(car, beside);
    const double by_chance =
        std::max({1.0, gapBeyondNoise(car, beside) / independentErrors(car), leftBySignatures(car, own)});
    return closed <= kSettings.effect * kSquaresOfANat * by_chance;
}

}  // namespace tread::diagnose::select
