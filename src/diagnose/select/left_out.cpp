#include "diagnose/select/left_out.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/gap.h"
#include "diagnose/select/doubt.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {

std::vector<double> gapsLeftOut(const Calibration& car, const std::vector<Parameter>& parameters, const Fit& fit) {
    std::vector<model::NormalEquations> each;
    model::NormalEquations all;
    for (std::size_t d = 0; d < fit.products.size(); ++d) {
        each.push_back(model::normalEquations(car.uncertainty, d, fit.products[d], fit.sizes));
        all = std::move(all) + each.back();
    }
    const Eigen::Index n = std::ssize(fit.free);
    Eigen::VectorXd lowest(n), highest(n);
    for (Eigen::Index i = 0; i < n; ++i)
        lowest(i) = parameters[fit.free[i]].lowest, highest(i) = parameters[fit.free[i]].highest;
    std::vector<double> gaps;
    for (std::size_t d = 0; d < each.size(); ++d) {
        const Eigen::MatrixXd others = all.products - each[d].products;
        const inference::QuadraticModel told{
            .information = others.topLeftCorner(n, n), .gradient = others.topRightCorner(n, 1), .at = fit.at(fit.free)};
        const Eigen::VectorXd step = inference::boundedStep(told, 0, lowest, highest);
        const Eigen::VectorXd left =
            model::residual(car.drives(), car.uncertainty, fit.rows, d) - fit.columns[d] * step;
        gaps.push_back(left.cwiseQuotient(model::filteredFloorOf(car.uncertainty, d)).squaredNorm());
    }
    return gaps;
}

bool isLarger(const std::vector<double>& after, const std::vector<double>& before) {
    const auto n = static_cast<double>(after.size());
    double sum = 0, squares = 0;
    for (std::size_t d = 0; d < after.size(); ++d) sum += after[d] - before[d];
    for (std::size_t d = 0; d < after.size(); ++d) squares += std::pow(after[d] - before[d] - sum / n, 2);
    return sum > std::sqrt(n / (n - 1) * squares);
}

LeftOut::LeftOut(const Calibration& car, const HeldOut& held_out)
    : car_(car), held_out_(held_out), within_(withinTolerances(car)) {}

bool LeftOut::enlarges(const Candidate& set) {
    if (car_.drives().size() < 2) return false;
    const Fitted& with = without(set, nullptr);
    if (!with.fit) return false;
    return std::any_of(set.effects.begin(), set.effects.end(), [&](const std::size_t& effect) {
        if (toldByOneDrive(explainedIn(car_, *with.fit, car_.problem.knobs[effect]))) return false;
        const Fitted& before = without(set, &effect);
        return before.fit && isLarger(with.gaps, before.gaps);
    });
}

// The set without one of its effects; whole if `effect` is null.
const LeftOut::Fitted& LeftOut::without(const Candidate& set, const std::size_t* effect) {
    const Problem& problem = car_.problem;
    std::set<std::size_t> effects(set.effects.begin(), set.effects.end());
    Deviation start = set.fit.at;
    if (effect) {
        effects.erase(*effect);
        start(problem.knobs[*effect]).setZero();
    }
    const auto [place, is_new] = fitted_.try_emplace(effects);
    if (!is_new) return place->second;
    std::vector<Eigen::Index> knobs;
    for (const std::size_t e : effects) knobs = model::joined(knobs, problem.knobs[e]);
    Fitted& result = place->second;
    result.fit = fitted(within_, problem.drives, car_.uncertainty, car_.about, knobs,
                        clamped(start, car_.about.nuisances, within_.parameters), SizePrior::typical, Remainder::usual);
    if (!result.fit) return result;
    result.gaps = gapsLeftOut(car_, within_.parameters, *result.fit);
    if (const std::optional<std::vector<double>> further = held_out_.gapOf(result.fit->at))
        result.gaps.insert(result.gaps.end(), further->begin(), further->end());
    else if (!held_out_.uncertainty.noise.empty()) result.fit.reset();  // it cannot be driven there
    return result;
}

}  // namespace tread::diagnose::select
