// Search for the sets of effects that explain the recordings: fits of the most promising ones, alone and combined.
#pragma once

#include <vector>

#include "diagnose/select/screen.h"

namespace tread::diagnose::select {

struct Candidate {
    std::vector<std::size_t> effects;  // indices of effects; empty: only nuisances
    double log_evidence = 0;           // nats over the model without effects
    Fit fit;                           // empty if not `fitted`; log_evidence is then that of the linear model
    bool fitted = false;
    answer::ForceLaw law = {.gain = -kInfinity};  // of a force of unknown cause beside the effects
};

struct Search {
    std::vector<Candidate> candidates;  // best first; fitted ones before those that were only screened
    const Candidate& best() const { return candidates.front(); }
    const Candidate& none() const;
};
Search search(const Calibration& car, const Screen& screen, const Progress& progress);

}  // namespace tread::diagnose::select
