// Sets of effects in the linear model about a fit: which of them are worth a fit of their own?
#pragma once

#include <vector>

#include "diagnose/select/candidate.h"

namespace tread::diagnose::select {

struct PromisingSet {
    std::vector<std::size_t> effects;
    double promised = 0;  // nats of evidence and prior over the effects of the candidate, in the linear model
};

// The most probable sets of these effects, best first (D25), (D28): among all single effects, all pairs, and the
// triples that add an effect to one of the best pairs. `here`: linearised about the fit of the candidate.
std::vector<PromisingSet> promisingSets(const Calibration& car, const Linearisation& here, const Candidate& about,
                                        const std::vector<std::size_t>& some);

}  // namespace tread::diagnose::select
