#include "diagnose/select/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "diagnose/select/beside_unknown.h"
#include "diagnose/select/left_out.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

using answer::Diagnosis;
using answer::Estimate;
using answer::Verdict;

constexpr double kNinety = 1.645;  // standard deviations of a 90 % interval
// Fits of the answer, each linearised at the point of the one before, until one gains fewer nats.
constexpr int kMostAnswerFits = 3;
constexpr double kAnswerSettled = 8;

// The set of effects that is named, with the probabilities of all that can be.
struct Answer {
    Posterior posterior;
    const Candidate* named = nullptr;
    Fit fit;  // of the causes, their sizes free of the prior
    Closeness closeness;
    std::vector<std::pair<const Candidate*, std::string>> struck = {};  // with the reason
};

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

// Probability that an effect acts, if an unknown cause does. How much of the gap it closes is not known of an effect
// that is not named.
double probabilityBesideUnknown(std::size_t effect, const Calibration& car, const Judgement& judgement) {
    const std::vector<std::size_t>& named = judgement.named->effects;
    const auto place = std::find(named.begin(), named.end(), effect);
    if (place == named.end()) return actsBesideUnknown({0, 1}, std::max<std::size_t>(named.size(), 1));
    const Closest& without = judgement.closeness.without[place - named.begin()];
    return actsBesideUnknown(closedShare(gapBeyondNoise(car, judgement.closeness.with.rows),
                                         gapBeyondNoise(car, without.rows), scatterOfGap(car)),
                             named.size());
}

double probabilityOf(std::size_t effect, const Calibration& car, const Posterior& posterior,
                     const Judgement& judgement) {
    const double unknown = judgement.remains.probability();
    return (1 - unknown) * posterior.genuinelyOf(effect) +
           unknown * posterior.of(effect) * probabilityBesideUnknown(effect, car, judgement);
}

void rankEffects(Diagnosis& diagnosis, const Calibration& car, const Search& found, const Answer& chosen,
                 const Judgement& judgement) {
    const Problem& problem = car.problem;
    const Posterior& posterior = chosen.posterior;
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        answer::RankedEffect ranked{.name = problem.effects[e].name,
                                    .probability = probabilityOf(e, car, posterior, judgement),
                                    .parameters = {}};
        for (const Candidate& one : found.candidates) {
            if (one.effects != std::vector<std::size_t>{e}) continue;
            ranked.log_evidence = one.log_evidence;
            for (const auto& [model, reason] : chosen.struck)
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

// True when a knob is at an end of its plausible range. If that end is within the usual sizes, the fit without it must
// also lie beyond it by more than the uncertainty of the knob.
bool implausible(const Calibration& car, const Fit& fit) {
    constexpr double kUsual = 2;   // typical sizes
    constexpr double kBeyond = 2;  // standard deviations
    const inference::QuadraticModel here = quadraticAt(fit, car.uncertainty);
    const Eigen::VectorXd slope = here.gradient - here.at;  // of the log posterior
    for (Eigen::Index i = std::ssize(fit.free) - std::ssize(fit.knobs); i < std::ssize(fit.free); ++i) {
        const Parameter& knob = car.problem.replays.parameters[fit.free[i]];
        const double units = fit.at(fit.free[i]);
        // A knob at 0 has found nothing, which is no reason against the others.
        if (units == 0 || !knob.implausibleAt(units)) continue;
        if (std::abs(units) > kUsual) return true;
        const double outwards = knob.highest - units < units - knob.lowest ? slope(i) : -slope(i);
        if (outwards * std::sqrt(fit.covariance(i, i)) > kBeyond) return true;
    }
    return false;
}

// The fit of a model in which the sizes of its effects are free of the prior that ranked it.
Fit released(const Calibration& car, const Candidate& named) {
    Fit fit = named.fit;
    if (named.effects.empty()) return fit;
    SharedLinearisation here = linearisationAbout(car, named);
    for (int round = 0; round < kMostAnswerFits; ++round) {
        if (round > 0) here = linearisedAt(car, fit);
        std::optional<Fit> again =
            fitted(car.problem.replays, car.drives(), car.uncertainty, *here, fit.knobs, endOf(fit), SizePrior::none);
        if (!again) break;
        fit = std::move(*again);
        if (fit.gained < kAnswerSettled) break;
    }
    return withColumnsOfItsPoint(car.problem.replays, car.drives(), car.uncertainty, *linearisedAt(car, fit), fit);
}

// The fit at the closest car with its causes, whose sizes stay.
Fit atClosest(const Calibration& car, Fit fit) {
    std::optional<Closest> closest = fit.knobs.empty() ? car.closest : closestTo(car, fit.at, {});
    if (closest) fit.at = std::move(closest->at), fit.rows = fit.of_car = std::move(closest->rows);
    return fit;
}

// True when the drive that tells most of one of the effects contradicts the others (D38a).
bool contradicted(const Calibration& car, const Candidate& model, const Search& found) {
    return std::any_of(found.candidates.begin(), found.candidates.end(), [&](const Candidate& less) {
        return less.fitted && less.lacksOneOf(model) && predicted(car, model.fit, less.fit).contradicts();
    });
}

constexpr const char *const kAtItsEnd = "a number is at the end of its plausible range",
                            *const kClosesByChance = "one of its effects closes no more of the gap than chance could";

// Why a model cannot be the answer, as far as its fit tells; empty when it can: its numbers are plausible, it predicts
// the drives that are left out, its effects have the same values in all drives, and those held out do not speak against
// it.
std::string reasonInTheFit(const Calibration& car, const Candidate& model, const Search& found, const HeldOut& held_out,
                           double variance_factor) {
    const Fit& none = found.none().fit;
    if (model.effects.empty()) return {};
    if (implausible(car, model.fit)) return kAtItsEnd;
    if (predicted(car, model.fit, none).fails()) return "it does not predict drives that are left out of the fit";
    if (contradicted(car, model, found)) return "one drive supports it and the others contradict it";
    if (held_out.speakAgainst(model.fit, none.at, variance_factor))
        return "it does not reduce the gap of the held-out drives";
    return {};
}

// The same as far as the gap tells: each effect closes more of it than chance may, and does not enlarge it in drives
// that it is not fitted to.
std::string reasonInTheGap(const Calibration& car, const Candidate& model, const Closeness& closeness,
                           LeftOut& left_out) {
    if (model.effects.empty()) return {};
    if (closesByChance(car, closeness)) return kClosesByChance;
    if (left_out.enlarges(model)) return "it enlarges the gap of drives that it is not fitted to";
    return {};
}

// The most probable model that may be the answer. Models that may not are struck off, and the others share their
// probability. The tests that cost least come first. Where an effect that was only screened is the most probable now,
// it is fitted.
Answer answerOf(const Calibration& car, Search& found, const HeldOut& held_out) {
    std::vector<bool> possible(found.candidates.size(), true);
    std::vector<std::pair<const Candidate*, std::string>> struck;
    LeftOut left_out(car, held_out);
    const auto strike = [&](const Candidate* model, std::string reason) {
        struck.emplace_back(model, std::move(reason));
        possible[model - found.candidates.data()] = false;
    };
    while (true) {
        Posterior probable = posterior(car, found, possible);
        const std::ptrdiff_t first = probable.hypotheses.front().candidate - found.candidates.data();
        if (Candidate& one = found.candidates[first]; !one.fitted) {
            possible[first] = fitScreened(car, found, one);
            continue;
        }
        const Candidate* named = probable.toBeNamed();
        if (std::string reason = reasonInTheFit(car, *named, found, held_out, probable.variance_factor);
            !reason.empty()) {
            strike(named, std::move(reason));
            continue;
        }
        Fit answer = released(car, *named);
        if (implausible(car, answer)) {
            strike(named, kAtItsEnd);
            continue;
        }
        Closeness closeness = closenessOf(car, named->effects, answer.at);
        if (std::string reason = reasonInTheGap(car, *named, closeness, left_out); !reason.empty()) {
            strike(named, std::move(reason));
            continue;
        }
        return {std::move(probable), named, atClosest(car, std::move(answer)), std::move(closeness), std::move(struck)};
    }
}

// Nats by which the models that were struck off are likelier than all others (D33c). What an effect that closes too
// little stands for is not visible, and needs no cause.
double rejectedOver(const Calibration& car, const Search& found, const Answer& chosen) {
    if (chosen.struck.empty()) return -kInfinity;
    const Posterior all = posterior(car, found, std::vector<bool>(found.candidates.size(), true));
    double rejected = 0, others = 0;
    for (const Hypothesis& one : all.hypotheses) {
        const auto struck = std::find_if(chosen.struck.begin(), chosen.struck.end(),
                                         [&](const auto& off) { return off.first == one.candidate; });
        if (struck == chosen.struck.end()) others += one.probability;
        else if (struck->second != kClosesByChance) rejected += one.probability;
    }
    return std::log(rejected) - std::log(std::max(others, std::numeric_limits<double>::min()));
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
    Answer chosen = answerOf(car, found, held_out);
    const Candidate& named = *chosen.named;
    Remains remains = whatRemains(car, named, chosen.closeness.with);
    remains.rejected = rejectedOver(car, found, chosen);
    remains.vibration = std::move(vibration);
    Judgement judgement{&named, std::move(chosen.fit), std::move(chosen.closeness), std::move(remains),
                        predicted(car, named.fit, found.none().fit)};
    diagnosis.causes = problem.namesOf(named.effects);
    const double remains_ordinary = 1 - judgement.remains.probability();
    diagnosis.probability_of_unknown = 1 - remains_ordinary * chosen.posterior.genuine();
    diagnosis.probability_of_nothing = remains_ordinary * chosen.posterior.ofNothing();
    rankEffects(diagnosis, car, found, chosen, judgement);
    for (const auto& [model, reason] : chosen.struck)
        diagnosis.ruled_out.push_back({problem.namesOf(model->effects), model->log_evidence, reason});
    for (std::size_t e = 0; e < problem.effects.size(); ++e)
        diagnosis.expected_evidence[problem.effects[e].name] = expected_evidence[e];
    std::set<std::string> names = credible(problem, chosen.posterior);
    if (claimsUnknown(diagnosis)) names.insert("unknown");
    diagnosis.credible_set.assign(names.begin(), names.end());
    for (const Candidate* one : chosen.posterior.alternativesTo(named))
        diagnosis.alternatives.push_back(problem.namesOf(one->effects));
    std::sort(diagnosis.alternatives.begin(), diagnosis.alternatives.end());
    diagnosis.verdict = verdictOf(diagnosis, car, judgement);
    return judgement;
}

}  // namespace tread::diagnose::select
