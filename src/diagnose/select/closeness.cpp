#include "diagnose/select/closeness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/parallel.h"
#include "diagnose/model/gap.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

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
    const double independent = independentErrors(car), with = squaredGapOf(car, closeness.with.rows);
    const double explained = std::max(0.0, squaredGapOf(car, car.closest.rows) - with);
    const double by_signature = car.structure_error * car.structure_error * explained;
    const double unrelated = std::max(gapBeyondNoise(car, closeness.with.rows), by_signature);
    if (unrelated == 0) return false;  // what the set leaves is noise, which the evidence takes into account
    return std::any_of(closeness.without.begin(), closeness.without.end(), [&](const Closest& less) {
        const double closed = squaredGapOf(car, less.rows) - with;
        return 0.5 * closed * independent <= kSettings.effect * unrelated;
    });
}

}  // namespace tread::diagnose::select
