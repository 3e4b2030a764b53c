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
    // disturbances would, in squares, times the temperature.
    double doubt = 1;

    double ofUnknown() const;
    double of(std::size_t effect) const;  // that it is one of the causes
    // That no effect is the cause, or one that has not shown and that these drives could not show at its typical size.
    double ofNothingThatShows(const Screen& screen) const;
};

// `outside`: nats that something which is not in the catalogue gains over the best model.
Posterior posterior(const Study& study, const Search& found, double outside);

}  // namespace tread
