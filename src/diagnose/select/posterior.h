// From evidence to probabilities of the hypotheses.
#pragma once

#include <vector>

#include "diagnose/select/search.h"
#include "inference/heterogeneity.h"

namespace tread::diagnose::select {

// The effects of the candidate, or none, are the cause. With `look_alike`: an unknown cause that resembles these
// effects. Without a candidate: an unknown cause that resembles no effect.
struct Hypothesis {
    const Candidate* candidate = nullptr;
    bool look_alike = false;
    double probability = 0;

    bool unknown() const { return !candidate || look_alike; }
};

struct Posterior {
    std::vector<Hypothesis> hypotheses;                   // most probable first
    std::vector<inference::Heterogeneity> heterogeneity;  // of each candidate of the search
    double variance_factor = 1;  // squared Birge ratio of the best model: divides evidence and multiplies variances

    double ofUnknown() const;
    double of(std::size_t effect) const;  // that it is one of the causes
    // True when this evidence is enough to name an effect as a cause.
    bool shows(double log_evidence) const;
    // Probability of all sets below that threshold, the empty set included. An effect with enough expected evidence
    // that stays below it is smaller than typical: at its typical size its expected signature is at least 6.6 standard
    // deviations from zero, and it was found within about 3.7.
    double ofNothingThatShows() const;
};

// `unknown_gain`: nats of an unknown cause over the best model (D28) to (D32).
Posterior posterior(const Calibration& car, const Search& found, double unknown_gain);

}  // namespace tread::diagnose::select
