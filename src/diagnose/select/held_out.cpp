#include "diagnose/select/held_out.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/gap.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {

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

bool HeldOut::speakAgainst(const Deviation& with, const Deviation& without) const {
    if (uncertainty.noise.empty()) return false;
    const std::optional<Rows> after = model::rowsAt(problem.replays, problem.held_out, with);
    const std::optional<Rows> before = model::rowsAt(problem.replays, problem.held_out, without);
    if (!after || !before) return !after;
    double left = 0, was = 0, shown = 0, expected = 0;
    for (std::size_t d = 0; d < after->size(); ++d) {
        const auto squares = [&](const Eigen::VectorXd& off) {
            return model::squaresOf(uncertainty, d, uncertainty.noise[d].over(off), uncertainty.sizes);
        };
        left += squares(drives()[d].measured - (*after)[d]), was += squares(drives()[d].measured - (*before)[d]);
        shown += squares((*after)[d] - (*before)[d]);
        expected += uncertainty.noise[d].expected;
    }
    return speaksAgainst({left, was, shown, std::max(1.0, std::min(left, was) / expected)});
}

bool speaksAgainst(const HeldOutGap& gap) {
    const double by_chance = 0.5 * std::erfc(0.5 * std::sqrt(0.5 * gap.difference / gap.variance));
    return gap.with >= gap.without && by_chance < kSettings.false_alarm;
}

}  // namespace tread::diagnose::select
