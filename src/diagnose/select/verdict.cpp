#include "diagnose/select/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

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

using Struck = std::vector<std::pair<const Candidate*, std::string>>;  // models that cannot be the answer, and why

// The set of effects that is named, with the probabilities of all that can be.
struct Answer {
    Posterior posterior;
    Judgement judgement;
    Struck struck;
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

void rankEffects(Diagnosis& diagnosis, const Calibration& car, const Search& found, const Answer& chosen) {
    const Problem& problem = car.problem;
    const auto& [posterior, judgement, struck] = chosen;
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

// Nats by which the models that were struck off are likelier than all others (D33c). What an effect that closes too
// little stands for is not visible, and needs no cause.
double rejectedOver(const Calibration& car, const Search& found, const Struck& struck) {
    if (struck.empty()) return -kInfinity;
    const Posterior all = posterior(car, found, std::vector<bool>(found.candidates.size(), true));
    double rejected = 0, others = 0;
    for (const Hypothesis& one : all.hypotheses) {
        const auto off =
            std::find_if(struck.begin(), struck.end(), [&](const auto& each) { return each.first == one.candidate; });
        if (off == struck.end()) others += one.probability;
        else if (off->second != kClosesByChance) rejected += one.probability;
    }
    return std::log(rejected) - std::log(std::max(others, std::numeric_limits<double>::min()));
}

// Judges models of a search. Models that may not be the answer are struck off, and the others share their probability.
class Judge {
public:
    Judge(const Calibration& car, Search& found, const HeldOut& held_out, answer::Vibration vibration)
        : car_(car),
          found_(found),
          held_out_(held_out),
          vibration_(std::move(vibration)),
          left_out_(car, held_out),
          possible_(found.candidates.size(), true) {}

    // The most probable model that may be the answer, less the effects that it does not need, but with those that act
    // likelier than not. Where an effect that was only screened is the most probable now, it is fitted.
    Answer answer() {
        while (true) {
            Posterior probable = posterior(car_, found_, possible_);
            const std::ptrdiff_t first = probable.hypotheses.front().candidate - found_.candidates.data();
            if (Candidate& one = found_.candidates[first]; !one.fitted) {
                possible_[first] = fitScreened(car_, found_, one);
                continue;
            }
            const Candidate* named = probable.needed();
            std::string reason;
            std::optional<Judgement> judgement = judged(*named, probable, reason);
            if (!judgement) {
                struck_.emplace_back(named, std::move(reason));
                possible_[named - found_.candidates.data()] = false;
                continue;
            }
            while (std::optional<Judgement> more = withOneMore(*judgement, probable)) judgement = std::move(more);
            return {std::move(probable), std::move(*judgement), std::move(struck_)};
        }
    }

private:
    // Nothing, and the reason, when the model may not be the answer. The tests that cost least come first.
    std::optional<Judgement> judged(const Candidate& model, const Posterior& probable, std::string& reason) {
        reason = reasonInTheFit(car_, model, found_, held_out_, probable.variance_factor);
        if (!reason.empty()) return std::nullopt;
        Fit answer = released(car_, model);
        if (implausible(car_, answer)) {
            reason = kAtItsEnd;
            return std::nullopt;
        }
        Closeness closeness = closenessOf(car_, model.effects, answer.at);
        reason = reasonInTheGap(car_, model, closeness, left_out_);
        if (!reason.empty()) return std::nullopt;
        Remains remains = whatRemains(car_, model, closeness.with);
        remains.rejected = rejectedOver(car_, found_, struck_);
        remains.vibration = vibration_;
        return Judgement{&model, atClosest(car_, std::move(answer)), std::move(closeness), std::move(remains),
                         predicted(car_, model.fit, found_.none().fit)};
    }

    // The same with one more effect of a cause that is named, if that acts likelier than not and may be named.
    std::optional<Judgement> withOneMore(const Judgement& judgement, const Posterior& probable) {
        const Candidate& named = *judgement.named;
        const Candidate* more = named.effects.empty() ? nullptr : probable.likelierWithOneMore(named);
        std::string reason;
        std::optional<Judgement> result = more ? judged(*more, probable, reason) : std::nullopt;
        if (!result) return std::nullopt;
        const auto added = std::find_if(more->effects.begin(), more->effects.end(),
                                        [&](std::size_t effect) { return !named.holds(effect); });
        if (probabilityOf(*added, car_, probable, *result) < 0.5) return std::nullopt;
        return result;
    }

    const Calibration& car_;
    Search& found_;
    const HeldOut& held_out_;
    answer::Vibration vibration_;
    LeftOut left_out_;
    std::vector<bool> possible_;  // of each candidate
    Struck struck_;
};

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
    Answer chosen = Judge(car, found, held_out, std::move(vibration)).answer();
    const Candidate& named = *chosen.judgement.named;
    diagnosis.causes = problem.namesOf(named.effects);
    const double remains_ordinary = 1 - chosen.judgement.remains.probability();
    diagnosis.probability_of_unknown = 1 - remains_ordinary * chosen.posterior.genuine();
    diagnosis.probability_of_nothing = remains_ordinary * chosen.posterior.ofNothing();
    rankEffects(diagnosis, car, found, chosen);
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
    diagnosis.verdict = verdictOf(diagnosis, car, chosen.judgement);
    return std::move(chosen.judgement);
}

}  // namespace tread::diagnose::select
