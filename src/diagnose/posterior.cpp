#include "diagnose/posterior.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr std::size_t kMost = 4;  // effects of a candidate, none included

// Prior probabilities of none, one, two and three causes of the catalogue, each split evenly over its members.
constexpr std::array<double, kMost> kPrior{0.25, 0.45, 0.15, 0.05};
constexpr double kPriorUnknown = 0.1;
// Of the unknown causes, those that so many effects of the catalogue imitate, and that neither larger disturbances nor
// a law of forces give away.
constexpr std::array<double, kMost> kImitated{0, 0.05, 0.05, 0.3};

// Ways to choose so many of n effects.
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

}  // namespace

double Posterior::ofUnknown() const {
    return sumOf(hypotheses, [](const Hypothesis& one) { return one.unknown(); });
}

double Posterior::of(std::size_t effect) const {
    return sumOf(hypotheses, [&](const Hypothesis& one) { return !one.unknown() && holds(*one.candidate, effect); });
}

bool Posterior::shows(double log_evidence) const {
    return log_evidence >= kThresholds.effect * doubt;
}

double Posterior::ofNothingThatShows() const {
    return sumOf(hypotheses,
                 [&](const Hypothesis& one) { return !one.unknown() && !shows(one.candidate->log_evidence); });
}

Posterior posterior(const Study& study, const Search& found, double outside) {
    const auto n = static_cast<double>(study.effects.size());
    Posterior result;
    const double left_over = leftOver(study, found.best().fit.rows);
    result.doubt = left_over * left_over;
    std::vector<double> logs;
    const auto add = [&](const Candidate* candidate, bool imitated, double prior, double evidence) {
        result.hypotheses.push_back({candidate, imitated});
        logs.push_back(std::log(prior) + evidence / result.doubt);
    };
    double strongest = -kInfinity;
    for (const Candidate& one : found.candidates) {
        const std::size_t count = std::min(one.effects.size(), kMost - 1);
        const double ways = choices(n, count);
        const double evidence =
            one.log_evidence - kThresholds.doubt(count, found.best().log_evidence, study.bench.compared());
        strongest = std::max(strongest, evidence);
        add(&one, false, kPrior[count] / ways, evidence);
        result.constancy.push_back(one.fitted ? constancy(study, one.fit) : Constancy{});
        if (count > 0 && one.fitted)
            add(&one, true, kPriorUnknown * kImitated[count] / ways,
                evidence + imitationGain(one, result.constancy.back(), study.bench.compared()));
    }
    add(nullptr, false, kPriorUnknown, strongest + outside - kThresholds.unknown);

    const double most = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    for (double& one : logs) sum += one = std::exp(one - most);
    for (std::size_t i = 0; i < logs.size(); ++i) result.hypotheses[i].probability = logs[i] / sum;
    std::stable_sort(result.hypotheses.begin(), result.hypotheses.end(),
                     [](const Hypothesis& a, const Hypothesis& b) { return a.probability > b.probability; });
    return result;
}

}  // namespace tread
