#include "diagnose/select/held_out.h"

#include "diagnose/model/gap.h"

namespace tread::diagnose::select {

HeldOut heldOut(const Calibration& car) {
    const Problem& problem = car.problem;
    HeldOut drives{problem, {}};
    if (problem.held_out.empty()) return drives;
    const std::optional<Rows> here = model::rowsAt(problem.replays, problem.held_out, car.fit.at);
    if (!here) return drives;
    drives.uncertainty =
        model::uncertaintyAt(problem.replays, problem.held_out, car.fit.at, *here, model::endsOf(problem.held_out));
    drives.uncertainty.sizes = car.uncertainty.sizes;
    return drives;
}

std::optional<std::vector<double>> HeldOut::gapOf(const Deviation& at) const {
    if (uncertainty.noise.empty()) return std::nullopt;
    const std::optional<Rows> rows = model::rowsAt(problem.replays, problem.held_out, at);
    if (!rows) return std::nullopt;
    return model::squaredGaps(problem.held_out, uncertainty, *rows);
}

}  // namespace tread::diagnose::select
