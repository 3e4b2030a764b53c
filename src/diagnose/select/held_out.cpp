#include "diagnose/select/held_out.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/gap.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr int kDraws = 24;  // draws from the posterior, each one a replay of all these drives

Rows less(const Rows& one, const Rows& other) {
    Rows difference = one;
    for (std::size_t d = 0; d < one.size(); ++d) difference[d] -= other[d];
    return difference;
}

}  // namespace

HeldOut heldOut(const Calibration& car) {
    const Problem& problem = car.problem;
    HeldOut drives{problem, {}};
    if (problem.held_out.empty()) return drives;
    const Deviation& at = car.together ? car.together->at : car.fit.at;
    const std::optional<Rows> here = model::rowsAt(problem.replays, problem.held_out, at);
    if (!here) return drives;
    drives.uncertainty =
        model::uncertaintyAt(problem.replays, problem.held_out, at, *here, model::endsOf(problem.held_out));
    drives.uncertainty.sizes = car.uncertainty.sizes;
    return drives;
}

std::optional<std::vector<double>> HeldOut::gapOf(const Deviation& at) const {
    if (uncertainty.noise.empty()) return std::nullopt;
    const std::optional<Rows> rows = model::rowsAt(problem.replays, problem.held_out, at);
    if (!rows) return std::nullopt;
    return model::squaredGaps(problem.held_out, uncertainty, *rows);
}

double HeldOut::product(const Rows& one, const Rows& other) const {
    double sum = 0;
    for (std::size_t d = 0; d < one.size(); ++d) {
        const auto squares = [&](const Eigen::VectorXd& off) {
            return model::squaresOf(uncertainty, d, uncertainty.noise[d].over(off), uncertainty.sizes);
        };
        sum += 0.25 * (squares(one[d] + other[d]) - squares(one[d] - other[d]));
    }
    return sum;
}

bool HeldOut::speakAgainst(const Fit& with, const Deviation& without, double variance_factor) const {
    if (uncertainty.noise.empty()) return false;
    const std::optional<Rows> after = model::rowsAt(problem.replays, problem.held_out, with.at);
    const std::optional<Rows> before = model::rowsAt(problem.replays, problem.held_out, without);
    if (!after || !before) return !after;
    Rows left, was;
    double expected = 0;
    for (std::size_t d = 0; d < after->size(); ++d) {
        left.push_back(drives()[d].measured - (*after)[d]), was.push_back(drives()[d].measured - (*before)[d]);
        expected += uncertainty.noise[d].expected;
    }
    const Rows difference = less(*after, *before);
    HeldOutGap gap{product(left, left), product(was, was), product(difference, difference), 1};
    gap.variance = std::max(1.0, std::min(gap.with, gap.without) / expected);
    if (problem.compared()) gap.by_numbers = std::pow(kSettings.structure * gap.difference, 2);
    if (!speaksAgainst(gap)) return false;

    // Nor may the numbers of a true model be those of its fit.
    Random random(1);
    double squares = 0, count = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
        const std::optional<Rows> possible =
            model::rowsAt(problem.replays, problem.held_out, drawn(problem.replays, with, random));
        if (!possible) continue;
        const double change = product(difference, less(*possible, *after));
        squares += change * change, ++count;
    }
    if (count > 0) gap.by_numbers += variance_factor * squares / count;
    return speaksAgainst(gap);
}

bool speaksAgainst(const HeldOutGap& gap) {
    const double deviation = 2 * std::sqrt(gap.variance * gap.difference + gap.by_numbers);
    const double by_chance = 0.5 * std::erfc(std::sqrt(0.5) * gap.difference / deviation);
    return gap.with >= gap.without && by_chance < kSettings.false_alarm;
}

}  // namespace tread::diagnose::select
