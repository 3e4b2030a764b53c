// From evidence to probabilities of the hypotheses: sets of effects of the catalogue, the empty set included. Each has
// its own remainder, so an unknown cause is not a rival of theirs.
#pragma once

#include <vector>

#include "diagnose/select/search.h"

namespace tread::diagnose::select {

struct Hypothesis {
    const Candidate* candidate = nullptr;
    double probability = 0;
};

struct Posterior {
    std::vector<Hypothesis> hypotheses;  // most probable first
    // Squared Birge ratio of what tells the best model from that without effects: multiplies variances.
    double variance_factor = 1;

    double of(std::size_t effect) const;  // that it is one of the causes
    // The same, and that the set is not what an unknown cause looks like (D32b).
    double genuinelyOf(std::size_t effect) const;
    double genuine() const;  // that the set, which may be empty, is not what an unknown cause looks like
    double ofNothing() const;

    // The most probable set that gains enough evidence, less the effects that it does not need because the set without
    // them is too probable.
    const Candidate* needed() const;
    // The most probable set with one more effect, if sets of so many effects are likelier; null when they are not.
    const Candidate* likelierWithOneMore(const Candidate& named) const;
    // Sets of as many effects that may be the answer instead of this one. None where it is sure among them. A set that
    // is less likely than both together acts beside it, not instead of it.
    std::vector<const Candidate*> alternativesTo(const Candidate& named) const;
};

// ln of the prior probability of one set of so many effects (D28).
double logPrior(const Problem& problem, std::size_t effects);

// `possible`: of each candidate of the search, whether it can be the answer (D28), (D29).
Posterior posterior(const Calibration& car, const Search& found, const std::vector<bool>& possible);

}  // namespace tread::diagnose::select
