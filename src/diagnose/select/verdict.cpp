#include "diagnose/select/verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

using answer::Diagnosis;
using answer::Estimate;
using answer::Verdict;

constexpr double kNinety = 1.645;  // standard deviations of a 90 % interval

// Estimate of a number from the parameter that moves it; `units` and `sd` are the fitted value of the parameter and its
// standard deviation (D42).
Estimate estimateOf(const Parameter& parameter, const Parameter::Move& move, double units, double sd) {
    Estimate one{.value = move.nominal + units * move.by,
                 .sd = sd * std::abs(move.by),
                 .neutral = move.nominal,
                 .at_bound = parameter.implausibleAt(units)};
    const double a = move.nominal + std::max(parameter.lowest, units - kNinety * sd) * move.by;
    const double b = move.nominal + std::min(parameter.highest, units + kNinety * sd) * move.by;
    one.low = std::min(a, b), one.high = std::max(a, b);
    return one;
}

std::map<std::string, Estimate> estimates(const Calibration& car, const Fit& fit,
                                          const std::vector<Eigen::Index>& knobs, double variance_factor) {
    std::map<std::string, Estimate> result;
    for (Eigen::Index i = 0; i < std::ssize(fit.free); ++i) {
        const Eigen::Index p = fit.free[i];
        if (std::find(knobs.begin(), knobs.end(), p) == knobs.end()) continue;
        const Parameter& parameter = car.problem.replays.parameters[p];
        const double units = fit.at(p), structure = car.problem.compared() ? kSettings.structure * units : 0;
        const double sd = std::sqrt(variance_factor * fit.covariance(i, i) + structure * structure);
        for (const Parameter::Move& move : parameter.moves) result[move.path] = estimateOf(parameter, move, units, sd);
    }
    return result;
}

// The fit from which the size of an effect is told: that of the answer if it holds the effect, otherwise that of the
// most probable model which does; null when none was fitted.
const Fit* fitWith(std::size_t effect, const Judgement& judgement, const Posterior& posterior) {
    if (judgement.named->holds(effect)) return &judgement.answer;
    for (const Hypothesis& one : posterior.hypotheses)
        if (one.candidate->fitted && one.candidate->holds(effect)) return &one.candidate->fit;
    return nullptr;
}

void rankEffects(Diagnosis& diagnosis, const Calibration& car, const Search& found, const Choice& choice) {
    const Problem& problem = car.problem;
    const auto& [posterior, judgement, struck] = choice;
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        answer::RankedEffect ranked{.name = problem.effects[e].name,
                                    .probability = probabilityOf(e, car, posterior, judgement),
                                    .parameters = {}};
        for (const Candidate& one : found.candidates) {
            if (one.effects != std::vector<std::size_t>{e}) continue;
            ranked.log_evidence = one.log_evidence;
            for (const auto& [model, reason] : struck)
                if (model == &one) ranked.against = reason;
        }
        if (const Fit* fit = fitWith(e, judgement, posterior))
            ranked.parameters = estimates(car, *fit, problem.knobs[e], posterior.variance_factor);
        diagnosis.effects.push_back(std::move(ranked));
    }
    std::stable_sort(diagnosis.effects.begin(), diagnosis.effects.end(), [](const auto& a, const auto& b) {
        return a.probability != b.probability ? a.probability > b.probability : a.log_evidence > b.log_evidence;
    });
}

// Names of the effects in the fewest hypotheses that together have the probability kSettings.sure.
std::set<std::string> credible(const Problem& problem, const Posterior& posterior) {
    std::set<std::string> names;
    double held = 0;
    for (const Hypothesis& one : posterior.hypotheses) {
        if (held >= kSettings.sure) break;
        held += one.probability;
        if (one.candidate->effects.empty()) names.insert("none");
        for (const std::size_t e : one.candidate->effects) names.insert(problem.effects[e].name);
    }
    return names;
}

// Whether an unknown cause is part of the answer. Alone, it must be as probable as what is sure; causes explain all
// only where they are more likely to.
bool claimsUnknown(const Diagnosis& diagnosis) {
    return diagnosis.probability_of_unknown >= (diagnosis.causes.empty() ? kSettings.sure : 0.5);
}

Verdict verdictOf(const Diagnosis& diagnosis, const Calibration& car, const Judgement& judgement) {
    if (judgement.named->effects.empty()) {
        if (claimsUnknown(diagnosis)) return Verdict::unknown;
        const bool seen = std::any_of(diagnosis.expected_evidence.begin(), diagnosis.expected_evidence.end(),
                                      [](const auto& one) { return one.second >= kSettings.clear; });
        return seen ? Verdict::nothing : Verdict::not_testable;
    }
    if (claimsUnknown(diagnosis)) {
        const double tolerances_leave = gapBeyondNoise(car, car.closest.rows),
                     left = gapBeyondNoise(car, judgement.closeness.with.rows);
        return left > 0.5 * tolerances_leave ? Verdict::unknown : Verdict::partly_explained;
    }
    return diagnosis.alternatives.empty() ? Verdict::explained : Verdict::ambiguous;
}

}  // namespace

Judgement judge(answer::Diagnosis& diagnosis, const Calibration& car, const std::vector<double>& expected_evidence,
                Search& found, const HeldOut& held_out, answer::Vibration vibration) {
    const Problem& problem = car.problem;
    Choice choice = chosen(car, found, held_out, std::move(vibration));
    const Candidate& named = *choice.judgement.named;
    diagnosis.causes = problem.namesOf(named.effects);
    const double remains_ordinary = 1 - choice.judgement.remains.probability();
    diagnosis.probability_of_unknown = 1 - remains_ordinary * choice.posterior.genuine();
    diagnosis.probability_of_nothing = remains_ordinary * choice.posterior.ofNothing();
    rankEffects(diagnosis, car, found, choice);
    for (const auto& [model, reason] : choice.struck)
        diagnosis.ruled_out.push_back({problem.namesOf(model->effects), model->log_evidence, reason});
    for (std::size_t e = 0; e < problem.effects.size(); ++e)
        diagnosis.expected_evidence[problem.effects[e].name] = expected_evidence[e];
    std::set<std::string> names = credible(problem, choice.posterior);
    if (claimsUnknown(diagnosis)) names.insert("unknown");
    diagnosis.credible_set.assign(names.begin(), names.end());
    for (const Candidate* one : choice.posterior.alternativesTo(named))
        diagnosis.alternatives.push_back(problem.namesOf(one->effects));
    std::sort(diagnosis.alternatives.begin(), diagnosis.alternatives.end());
    diagnosis.verdict = verdictOf(diagnosis, car, choice.judgement);
    return std::move(choice.judgement);
}

}  // namespace tread::diagnose::select
