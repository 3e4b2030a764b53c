// From evidence to probabilities: what can be the case, and how probable each is.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnose/search.h"
#include "diagnose/unknown.h"

namespace tread {

// These effects (or none) are the cause; or something else is, that they merely imitate; or, without a candidate,
// something that nothing imitates.
struct Hypothesis {
    const Candidate* candidate = nullptr;
    bool imitated = false;
    double probability = 0;

    bool unknown() const { return !candidate || imitated; }
};

struct Posterior {
    std::vector<Hypothesis> hypotheses;  // the most probable first
    std::vector<Constancy> constancy;    // of each candidate of the search
    // By which evidence is divided and variances are multiplied: what the best model leaves over what noise and
    // disturbances would, in squares.
    double doubt = 1;

    double ofUnknown() const;
    double of(std::size_t effect) const;  // that it is one of the causes
    // Is so much evidence enough to blame an effect?
    bool shows(double log_evidence) const;
    // That no effect is the cause, or one that has not shown. A testable one that has not shown is smaller than
    // typical: at its typical size it is expected 6.6 standard deviations from none or more, and was found within 3.7
    // or so.
    double ofNothingThatShows() const;
};

// `outside`: nats that something which is not in the catalogue gains over the best model.
Posterior posterior(const Study& study, const Search& found, double outside);

}  // namespace tread
