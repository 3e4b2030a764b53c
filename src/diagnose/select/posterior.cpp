#include "diagnose/select/posterior.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/select/unknown_cause.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr std::size_t kMost = 4;  // numbers of effects in a candidate, from none to three

// Shares of the unknown causes that resemble this many effects and are revealed neither by larger disturbances nor by a
// force law.
constexpr std::array<double, kMost> kLookAlike{0, kSettings.look_alike, kSettings.look_alike,
                                               kSettings.three_look_alike};

// Number of sets of this many out of n effects.
double choices(double n, std::size_t effects) {
    double ways = 1;
    for (std::size_t i = 0; i < effects; ++i)
        ways *= std::max(1.0, n - static_cast<double>(i)) / static_cast<double>(i + 1);
    return ways;
}

bool holds(const Candidate& candidate, std::size_t effect) {
    return std::find(candidate.effects.begin(), candidate.effects.end(), effect) != candidate.effects.end();
}

template <class Of>
double sumOf(const std::vector<Hypothesis>& hypotheses, Of&& of) {
    double sum = 0;
    for (const Hypothesis& one : hypotheses) {
        if (of(one)) sum += one.probability;
    }
    return sum;
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

double Posterior::ofUnknown() const {
    return sumOf(hypotheses, [](const Hypothesis& one) { return one.unknown(); });
}

double Posterior::of(std::size_t effect) const {
    return sumOf(hypotheses, [&](const Hypothesis& one) { return !one.unknown() && holds(*one.candidate, effect); });
}

bool Posterior::shows(double log_evidence) const {
    return log_evidence >= kSettings.effect * variance_factor;
}

double Posterior::ofNothingThatShows() const {
    return sumOf(hypotheses,
                 [&](const Hypothesis& one) { return !one.unknown() && !shows(one.candidate->log_evidence); });
}

Posterior posterior(const Calibration& car, const Search& found, double unknown_gain) {
    const bool compared = car.problem.compared();
    const auto n = static_cast<double>(car.problem.effects.size());
    Posterior result;
    result.variance_factor = std::pow(model::birgeRatio(car.drives(), car.uncertainty, found.best().fit.rows), 2);
    std::vector<double> logs;
    const auto add = [&](const Candidate* candidate, bool look_alike, double prior, double evidence) {
        result.hypotheses.push_back({candidate, look_alike});
        logs.push_back(std::log(prior) + evidence / result.variance_factor);
    };
    double strongest = -kInfinity;
    for (const Candidate& one : found.candidates) {
        const std::size_t count = std::min(one.effects.size(), kMost - 1);
        const double ways = choices(n, count);
        const double evidence =
            one.log_evidence - kSettings.structureAllowance(count, found.best().log_evidence, compared);
        strongest = std::max(strongest, evidence);
        add(&one, false, kSettings.prior(count) / ways, evidence);
        result.heterogeneity.push_back(one.fitted ? heterogeneity(car, one.fit) : inference::Heterogeneity{});
        if (count > 0 && one.fitted)
            add(&one, true, kSettings.unknown_cause * kLookAlike[count] / ways,
                evidence + lookAlikeGain(result.heterogeneity.back(), compared));
    }
    add(nullptr, false, kSettings.unknown_cause, strongest + unknown_gain - kSettings.clear);
    normalise(result.hypotheses, std::move(logs));
    return result;
}

}  // namespace tread::diagnose::select
