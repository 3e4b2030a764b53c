#include "diagnose/select/verdict.h"

#include <algorithm>
#include <cmath>
#include <set>

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
    constexpr double kNear = 1e-6;  // units
    Estimate one{.value = move.nominal + units * move.by,
                 .sd = sd * std::abs(move.by),
                 .neutral = move.nominal,
                 .at_bound = units < parameter.lowest + kNear || units > parameter.highest - kNear};
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

void rankEffects(Diagnosis& diagnosis, const Calibration& car, const Search& found, const Posterior& posterior) {
    const Problem& problem = car.problem;
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        answer::RankedEffect ranked{.name = problem.effects[e].name, .probability = posterior.of(e), .parameters = {}};
        const Candidate* best = nullptr;
        for (const Candidate& one : found.candidates) {
            if (!best && std::find(one.effects.begin(), one.effects.end(), e) != one.effects.end()) best = &one;
            if (one.effects == std::vector<std::size_t>{e}) ranked.log_evidence = one.log_evidence;
        }
        if (best && best->fitted) {
            ranked.parameters = estimates(car, best->fit, problem.knobs[e], posterior.variance_factor);
            const inference::Heterogeneity& same = posterior.heterogeneity[best - found.candidates.data()];
            if (same.degrees_of_freedom > 0) diagnosis.constancy[ranked.name] = same.p;
        }
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
        if (one.unknown()) names.insert("unknown");
        else if (one.candidate->effects.empty()) names.insert("none");
        else
            for (const std::size_t e : one.candidate->effects) names.insert(problem.effects[e].name);
    }
    return names;
}

// The model of largest merit: each of its effects must gain the threshold (D41).
const Candidate& chosenOf(const Problem& problem, const Search& found, double variance_factor) {
    const auto merit = [&](const Candidate& one) {
        const std::size_t count = one.effects.size();
        return one.log_evidence - kSettings.structureAllowance(count, found.best().log_evidence, problem.compared()) -
               variance_factor * kSettings.effect * static_cast<double>(count);
    };
    const Candidate* chosen = &found.best();
    for (const Candidate& one : found.candidates)
        if (one.fitted && !one.effects.empty() && merit(one) > merit(*chosen)) chosen = &one;
    return *chosen;
}

// Names the causes and their alternatives, and decides between explained and ambiguous.
void blame(Diagnosis& diagnosis, const Problem& problem, const Search& found, const Posterior& posterior) {
    const Candidate& chosen = chosenOf(problem, found, posterior.variance_factor);
    diagnosis.causes = problem.namesOf(chosen.effects);
    double own = 0, rivals = 0;
    std::set<std::vector<std::string>> alternatives;
    for (const Hypothesis& one : posterior.hypotheses) {
        if (one.unknown() || one.candidate->effects.size() != chosen.effects.size()) continue;
        (one.candidate == &chosen ? own : rivals) += one.probability;
        if (one.candidate == &chosen || one.probability < 0.5 * (1 - kSettings.sure)) continue;
        alternatives.insert(problem.namesOf(one.candidate->effects));
    }
    diagnosis.alternatives.assign(alternatives.begin(), alternatives.end());
    const bool sure = own >= kSettings.sure * (own + rivals) || alternatives.empty();
    diagnosis.verdict = sure ? Verdict::explained : Verdict::ambiguous;
}

}  // namespace

void judge(Diagnosis& diagnosis, const Calibration& car, const std::vector<double>& expected_evidence,
           const Search& found, const UnknownCause& unknown) {
    const Problem& problem = car.problem;
    const Posterior probable = posterior(car, found, unknown.gain);
    diagnosis.probability_of_unknown = probable.ofUnknown();
    diagnosis.probability_of_nothing = probable.ofNothingThatShows();
    rankEffects(diagnosis, car, found, probable);
    for (std::size_t e = 0; e < problem.effects.size(); ++e)
        diagnosis.expected_evidence[problem.effects[e].name] = expected_evidence[e];
    const std::set<std::string> names = credible(problem, probable);
    diagnosis.credible_set.assign(names.begin(), names.end());

    const Candidate& best = found.best();
    if (unknown.gain > kSettings.clear || diagnosis.probability_of_unknown > 0.5) {
        diagnosis.verdict = Verdict::unknown;
    } else if (best.effects.empty() || !probable.shows(best.log_evidence)) {
        const bool seen = std::any_of(expected_evidence.begin(), expected_evidence.end(),
                                      [](double nats) { return nats >= kSettings.clear; });
        diagnosis.verdict = seen ? Verdict::nothing : Verdict::not_testable;
    } else {
        blame(diagnosis, problem, found, probable);
    }
}

}  // namespace tread::diagnose::select
