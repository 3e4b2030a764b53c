#include "diagnose/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnose/diagnosis_text.h"
#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr double kNinety = 1.645;  // standard deviations of a 90 % interval

std::map<std::string, Estimate> estimates(const Study& study, const Fit& fit, const std::vector<Eigen::Index>& knobs,
                                          double doubt) {
    std::map<std::string, Estimate> result;
    for (std::size_t i = 0; i < fit.free.size(); ++i) {
        const Eigen::Index p = fit.free[i];
        if (std::find(knobs.begin(), knobs.end(), p) == knobs.end()) continue;
        const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(p)];
        const double units = fit.at(p);
        const double structure = study.bench.compared() ? kThresholds.structure * units : 0;
        const double variance = doubt * fit.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
        const double sd = std::sqrt(variance + structure * structure);
        constexpr double kNear = 1e-6;
        for (const Parameter::Move& move : parameter.moves) {
            Estimate one{.value = move.nominal + units * move.by,
                         .sd = sd * std::abs(move.by),
                         .neutral = move.nominal,
                         .at_bound = units < parameter.lowest + kNear || units > parameter.highest - kNear};
            const double a = move.nominal + std::max(parameter.lowest, units - kNinety * sd) * move.by;
            const double b = move.nominal + std::min(parameter.highest, units + kNinety * sd) * move.by;
            one.low = std::min(a, b), one.high = std::max(a, b);
            result[move.path] = one;
        }
    }
    return result;
}

void rankEffects(Diagnosis& diagnosis, const Study& study, const Search& found, const Posterior& posterior) {
    for (std::size_t e = 0; e < study.effects.size(); ++e) {
        RankedEffect ranked{.name = study.effects[e].name, .probability = posterior.of(e), .parameters = {}};
        const Candidate* best = nullptr;
        for (const Candidate& one : found.candidates) {
            if (!best && std::find(one.effects.begin(), one.effects.end(), e) != one.effects.end()) best = &one;
            if (one.effects == std::vector<std::size_t>{e}) ranked.log_evidence = one.log_evidence;
        }
        if (best && best->fitted) {
            ranked.parameters = estimates(study, best->fit, study.knobs[e], posterior.doubt);
            const Constancy& same = posterior.constancy[static_cast<std::size_t>(best - found.candidates.data())];
            if (same.degrees_of_freedom > 0) diagnosis.constancy[ranked.name] = same.p;
        }
        diagnosis.effects.push_back(std::move(ranked));
    }
    std::stable_sort(diagnosis.effects.begin(), diagnosis.effects.end(), [](const auto& a, const auto& b) {
        return a.probability != b.probability ? a.probability > b.probability : a.log_evidence > b.log_evidence;
    });
}

// The fewest hypotheses that hold 90 % of what is left of them.
std::set<std::string> credible(const Study& study, const Posterior& posterior) {
    std::set<std::string> names;
    double held = 0;
    for (const Hypothesis& one : posterior.hypotheses) {
        if (held >= kThresholds.credible) break;
        held += one.probability;
        if (one.unknown()) names.insert("unknown");
        else if (one.candidate->effects.empty()) names.insert("none");
        else
            for (const std::size_t e : one.candidate->effects) names.insert(study.effects[e].name);
    }
    return names;
}

// The model of which every effect gains enough.
const Candidate& chosenOf(const Study& study, const Search& found, double surplus) {
    const auto merit = [&](const Candidate& one) {
        const std::size_t count = one.effects.size();
        return one.log_evidence - kThresholds.doubt(count, found.best().log_evidence, study.bench.compared()) -
               surplus * kThresholds.further_effect * static_cast<double>(count);
    };
    const Candidate* chosen = &found.best();
    for (const Candidate& one : found.candidates)
        if (one.fitted && !one.effects.empty() && merit(one) > merit(*chosen)) chosen = &one;
    return *chosen;
}

// Names the causes, and what they cannot be told from.
void blame(Diagnosis& diagnosis, const Study& study, const Search& found, const Posterior& posterior) {
    const Candidate& chosen = chosenOf(study, found, posterior.doubt);
    diagnosis.causes = study.namesOf(chosen.effects);
    double own = 0, rivals = 0;
    std::set<std::vector<std::string>> alternatives;
    for (const Hypothesis& one : posterior.hypotheses) {
        if (one.unknown() || one.candidate->effects.size() != chosen.effects.size()) continue;
        (one.candidate == &chosen ? own : rivals) += one.probability;
        if (one.candidate == &chosen || one.probability < 0.5 * (1 - kThresholds.sure)) continue;
        alternatives.insert(study.namesOf(one.candidate->effects));
    }
    diagnosis.alternatives.assign(alternatives.begin(), alternatives.end());
    const bool sure = own >= kThresholds.sure * (own + rivals) || alternatives.empty();
    diagnosis.verdict = sure ? Verdict::explained : Verdict::ambiguous;
}

std::string inWords(const Diagnosis& d) {
    double p = 1;  // of the least certain cause
    for (const RankedEffect& effect : d.effects) {
        if (std::find(d.causes.begin(), d.causes.end(), effect.name) != d.causes.end())
            p = std::min(p, effect.probability);
    }
    switch (d.verdict) {
        case Verdict::explained:
            return fmt::format("The gap is caused by {} ({})", together(d.causes), probabilityInWords(p));
        case Verdict::ambiguous:
            return fmt::format("The gap is caused by {} or {}: these drives cannot tell them apart", together(d.causes),
                               fmt::join(eachTogether(d.alternatives), " or "));
        case Verdict::nothing:
            return "Nothing beyond tolerance: the model explains the recordings with its parameters as known";
        case Verdict::unknown:
            return fmt::format("The cause is unknown: a {} force acts that no effect of the catalogue explains{}{}",
                               d.unexplained.generalised_force,
                               d.unexplained.law.follows.empty() ? "" : "; it follows ", d.unexplained.law.follows);
        case Verdict::not_testable:
            return "Not testable: none of the effects could be seen in these drives";
    }
    return {};
}

}  // namespace

void judge(Diagnosis& diagnosis, const Study& study, const Screen& screen, const Search& found, const Outside& outside,
           const MissingForce& missing) {
    const Posterior probable = posterior(study, found, outside.gain);
    diagnosis.probability_of_unknown = probable.ofUnknown();
    diagnosis.probability_of_nothing = probable.ofNothingThatShows();
    rankEffects(diagnosis, study, found, probable);
    for (std::size_t e = 0; e < study.effects.size(); ++e)
        diagnosis.testable[study.effects[e].name] = screen.detectability[e];
    const std::set<std::string> names = credible(study, probable);
    diagnosis.credible_set.assign(names.begin(), names.end());
    diagnosis.unexplained.generalised_force =
        std::max_element(missing.shares.begin(), missing.shares.end(), [](const auto& a, const auto& b) {
            return a.second < b.second;
        })->first;
    diagnosis.unexplained.when = missing.when;
    diagnosis.unexplained.law = outside.law;
    if (!outside.law.generalised_force.empty()) diagnosis.unexplained.generalised_force = outside.law.generalised_force;

    const Candidate& best = found.best();
    if (outside.gain > kThresholds.unknown || diagnosis.probability_of_unknown > 0.5) {
        diagnosis.verdict = Verdict::unknown;
    } else if (best.effects.empty() || !probable.shows(best.log_evidence)) {
        const bool seen = std::any_of(screen.detectability.begin(), screen.detectability.end(),
                                      [](double d) { return d >= kThresholds.shows; });
        diagnosis.verdict = seen ? Verdict::nothing : Verdict::not_testable;
    } else {
        blame(diagnosis, study, found, probable);
    }
    diagnosis.answer = inWords(diagnosis);
}

}  // namespace tread
