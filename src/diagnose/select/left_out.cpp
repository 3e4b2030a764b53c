#include "diagnose/select/left_out.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/gap.h"
#include "diagnose/select/doubt.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

double filteredGap(const Calibration& car, const Eigen::VectorXd& residual, std::size_t drive) {
    return residual.cwiseQuotient(model::filteredFloorOf(car.uncertainty, drive)).squaredNorm();
}

// Squared gap of the nominal car in each drive, filtered, then in the drives held out.
std::vector<double> gapsOfNominal(const Calibration& car, const HeldOut& held_out) {
    std::vector<double> gaps;
    for (std::size_t d = 0; d < car.drives().size(); ++d)
        gaps.push_back(filteredGap(car, model::residual(car.drives(), car.uncertainty, car.nominal, d), d));
    if (const auto further = held_out.gapOf(car.problem.replays.origin()))
        gaps.insert(gaps.end(), further->begin(), further->end());
    return gaps;
}

}  // namespace

std::vector<Eigen::VectorXd> residualsLeftOut(model::Drives drives, const model::Uncertainty& uncertainty,
                                              const std::vector<Parameter>& parameters, const Fit& fit, int threads) {
    const std::vector<model::NormalEquations> each =
        model::equationsOfEach(uncertainty, fit.products, fit.sizes, threads);
    const model::NormalEquations all = inference::sumOf(each);
    const inference::Bounds bounds = model::boundsOf(parameters, fit.free);
    std::vector<Eigen::VectorXd> left;
    for (std::size_t d = 0; d < each.size(); ++d) {
        const model::NormalEquations others{all.products - each[d].products};
        const inference::QuadraticModel told = inference::quadraticModel(others, fit.at(fit.free));
        const Eigen::VectorXd step = inference::boundedStep(told, 0, bounds);
        left.emplace_back(model::residual(drives, uncertainty, fit.rows, d) - fit.columns[d] * step);
    }
    return left;
}

bool isLarger(const std::vector<double>& after, const std::vector<double>& before) {
    const auto n = static_cast<double>(after.size());
    const auto grows = [&](std::size_t d) { return after[d] == before[d] ? 0 : std::log(after[d] / before[d]); };
    double sum = 0, squares = 0;
    for (std::size_t d = 0; d < after.size(); ++d) sum += grows(d);
    for (std::size_t d = 0; d < after.size(); ++d) squares += std::pow(grows(d) - sum / n, 2);
    return sum > std::sqrt(n / (n - 1) * squares);
}

LeftOut::LeftOut(const Calibration& car, const HeldOut& held_out)
    : car_(car), held_out_(held_out), within_(withinTolerances(car)), nominal_(gapsOfNominal(car, held_out)) {}

bool LeftOut::enlarges(const Candidate& set) {
    if (car_.drives().size() < 2) return false;
    const Fitted& with = fittedWith(set.effects, set.fit.at);
    if (!with.fit) return false;
    return std::any_of(set.effects.begin(), set.effects.end(), [&](std::size_t effect) {
        if (toldByOneDrive(explainedIn(car_, *with.fit, car_.problem.knobs[effect]))) return false;
        std::vector<std::size_t> others = set.effects;
        std::erase(others, effect);
        const Fitted& before = fittedWith(others, set.fit.at);
        return before.fit && isLarger(with.gaps, before.gaps);
    });
}

const LeftOut::Fitted& LeftOut::fittedWith(const std::vector<std::size_t>& effects, const Deviation& from) {
    const Problem& problem = car_.problem;
    const auto [place, is_new] = fitted_.try_emplace({effects.begin(), effects.end()});
    Fitted& result = place->second;
    if (!is_new) return result;
    const Start start{.at = clamped(problem.withOnly(effects, from), car_.about.nuisances, within_.parameters),
                      .is_end = true};
    result.fit = fitted(within_, problem.drives, car_.uncertainty, car_.about, problem.knobsOf(effects), start,
                        SizePrior::typical, Remainder::usual);
    if (!result.fit) return result;
    const std::vector<Eigen::VectorXd> left =
        residualsLeftOut(car_.drives(), car_.uncertainty, within_.parameters, *result.fit, problem.replays.threads);
    for (std::size_t d = 0; d < left.size(); ++d) result.gaps.push_back(filteredGap(car_, left[d], d));
    if (const std::optional<std::vector<double>> further = held_out_.gapOf(result.fit->at))
        result.gaps.insert(result.gaps.end(), further->begin(), further->end());
    else if (!held_out_.uncertainty.noise.empty()) result.fit.reset();  // it cannot be driven there
    for (std::size_t d = 0; d < std::min(result.gaps.size(), nominal_.size()); ++d)
        result.gaps[d] = std::min(result.gaps[d], nominal_[d]);
    return result;
}

}  // namespace tread::diagnose::select
