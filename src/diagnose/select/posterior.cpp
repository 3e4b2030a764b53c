#include "diagnose/select/posterior.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/birge_ratios.h"
#include "diagnose/select/doubt.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

// Number of sets of this many out of n effects.
double choices(double n, std::size_t effects) {
    double ways = 1;
    for (std::size_t i = 0; i < effects; ++i)
        ways *= std::max(1.0, n - static_cast<double>(i)) / static_cast<double>(i + 1);
    return ways;
}

// Causes that gain too little are not named, however few rivals a catalogue has.
bool mayBeNamed(const Candidate& model) {
    return model.effects.empty() || (model.fitted && model.log_evidence >= kSettings.effect);
}

// The probability of all sets of at least so many effects: rivals of an effect do not make it needless.
double ofAtLeast(const std::vector<Hypothesis>& hypotheses, std::size_t effects) {
    double sum = 0;
    for (const Hypothesis& one : hypotheses)
        if (one.candidate->effects.size() >= effects) sum += one.probability;
    return sum;
}

// The most probable set without one of these effects, if it is too probable for that effect to be needed; null when it
// is not.
const Candidate* needsLess(const std::vector<Hypothesis>& hypotheses, const Candidate& named) {
    const auto less = std::find_if(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& one) {
        return mayBeNamed(*one.candidate) && one.candidate->lacksOneOf(named);
    });
    if (less == hypotheses.end()) return nullptr;
    const double with_or_without = less->probability + ofAtLeast(hypotheses, named.effects.size());
    return less->probability > kSettings.false_alarm * with_or_without ? less->candidate : nullptr;
}

// Turns logarithms of prior times evidence into probabilities, and sorts by them.
void normalise(std::vector<Hypothesis>& hypotheses, std::vector<double> logs) {
    const double most = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    for (double& one : logs) sum += one = std::exp(one - most);
    for (std::size_t i = 0; i < logs.size(); ++i) hypotheses[i].probability = logs[i] / sum;
    std::stable_sort(hypotheses.begin(), hypotheses.end(),
                     [](const Hypothesis& a, const Hypothesis& b) { return a.probability > b.probability; });
}

}  // namespace

double Posterior::of(std::size_t effect) const {
    double sum = 0;
    for (const Hypothesis& one : hypotheses) {
        if (one.candidate->holds(effect)) sum += one.probability;
    }
    return sum;
}

double Posterior::genuinelyOf(std::size_t effect) const {
    double sum = 0;
    for (const Hypothesis& one : hypotheses) {
        const Candidate& candidate = *one.candidate;
        if (candidate.holds(effect)) sum += one.probability * kSettings.genuine(candidate.effects.size());
    }
    return sum;
}

double Posterior::genuine() const {
    double sum = 0;
    for (const Hypothesis& one : hypotheses) sum += one.probability * kSettings.genuine(one.candidate->effects.size());
    return sum;
}

double Posterior::ofNothing() const {
    double sum = 0;
    for (const Hypothesis& one : hypotheses) {
        if (one.candidate->effects.empty()) sum += one.probability;
    }
    return sum;
}

const Candidate* Posterior::needed() const {
    const Candidate* named = std::find_if(hypotheses.begin(), hypotheses.end(), [](const Hypothesis& one) {
                                 return mayBeNamed(*one.candidate);
                             })->candidate;
    while (const Candidate* less = needsLess(hypotheses, *named)) named = less;
    return named;
}

const Candidate* Posterior::likelierWithOneMore(const Candidate& named) const {
    double own = 0;
    for (const Hypothesis& one : hypotheses)
        if (one.candidate == &named) own = one.probability;
    const auto more = std::find_if(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& one) {
        return mayBeNamed(*one.candidate) && named.lacksOneOf(*one.candidate);
    });
    const bool likelier = more != hypotheses.end() && ofAtLeast(hypotheses, named.effects.size() + 1) > own;
    return likelier ? more->candidate : nullptr;
}

std::vector<const Candidate*> Posterior::alternativesTo(const Candidate& named) const {
    const auto actsBeside = [&](const Hypothesis& other) {
        std::vector<std::size_t> both = named.effects;
        for (const std::size_t e : other.candidate->effects)
            if (!named.holds(e)) both.push_back(e);
        return std::any_of(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& one) {
            return one.probability > other.probability && one.candidate->of(both);
        });
    };
    std::vector<const Candidate*> alternatives;
    double own = 0, rivals = 0;
    for (const Hypothesis& one : hypotheses) {
        if (one.candidate == &named) {
            own = one.probability;
        } else if (one.candidate->effects.size() == named.effects.size() && !actsBeside(one)) {
            rivals += one.probability;
            if (one.probability >= 0.5 * (1 - kSettings.sure)) alternatives.push_back(one.candidate);
        }
    }
    if (own >= kSettings.sure * (own + rivals)) alternatives.clear();
    return alternatives;
}

double logPrior(const Problem& problem, std::size_t effects) {
    return std::log(kSettings.prior(effects) / choices(static_cast<double>(problem.effects.size()), effects));
}

Posterior posterior(const Calibration& car, const Search& found, const std::vector<bool>& possible) {
    double strongest = 0;
    for (std::size_t i = 0; i < found.candidates.size(); ++i) {
        if (possible[i]) strongest = std::max(strongest, found.candidates[i].log_evidence);
    }
    const Fit& best = found.best().fit;
    Posterior result;
    const model::ChannelSquares squares(car.drives(), car.uncertainty, best.sizes);
    const model::BirgeRatios ratios(car.drives(), car.uncertainty, squares, best.rows);
    result.variance_factor = ratios.between(best.rows, found.none().fit.rows);
    std::vector<double> logs;
    for (std::size_t i = 0; i < found.candidates.size(); ++i) {
        if (!possible[i]) continue;
        const Candidate& one = found.candidates[i];
        const double doubted = one.fitted ? doubt(car, squares, one.fit, best.rows) : 1;
        result.hypotheses.push_back({&one});
        const bool tells = one.fitted && &one != &found.best();
        const double variance = tells ? ratios.between(best.rows, one.fit.rows) : result.variance_factor;
        const double behind = (strongest - one.log_evidence) / (doubted * variance);
        logs.push_back(logPrior(car.problem, one.effects.size()) - behind);
    }
    normalise(result.hypotheses, std::move(logs));
    return result;
}

}  // namespace tread::diagnose::select
