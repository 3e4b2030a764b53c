// From evidence to probabilities: what can be the case, and how probable each is.
#pragma once

#include <vector>

#include "diagnose/select/search.h"
#include "inference/heterogeneity.h"

namespace tread::diagnose::select {

// These effects (or none) are the cause; or something else is, that merely looks like them; or, without a candidate,
// something that looks like no effect.
struct Hypothesis {
    const Candidate* candidate = nullptr;
    bool look_alike = false;
    double probability = 0;

    bool unknown() const { return !candidate || look_alike; }
};

struct Posterior {
    std::vector<Hypothesis> hypotheses;                   // the most probable first
    std::vector<inference::Heterogeneity> heterogeneity;  // of each candidate of the search
    double birge_ratio = 1;  // of the best model, squared: evidence is divided and variances are multiplied by it

    double ofUnknown() const;
    double of(std::size_t effect) const;  // that it is one of the causes
    // Is so much evidence enough to blame an effect?
    bool shows(double log_evidence) const;
    // That no effect is the cause, or one that has not shown. One of which enough evidence was to be expected and that
    // has not shown is smaller than typical: at its typical size it is expected 6.6 standard deviations from none or
    // more, and was found within 3.7 or so.
    double ofNothingThatShows() const;
};

// `unknown_gain`: nats that something which is not in the catalogue gains over the best model (D28) to (D32).
Posterior posterior(const Calibration& car, const Search& found, double unknown_gain);

}  // namespace tread::diagnose::select
