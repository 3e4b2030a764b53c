// Which effects explain the recordings: fits of the most promising ones, alone and together.
#pragma once

#include <vector>

#include "diagnose/select/screen.h"

namespace tread::diagnose::select {

struct Candidate {
    std::vector<std::size_t> effects;  // none: only nuisances
    double log_evidence = 0;           // nats over none
    Fit fit;                           // empty when it was judged by the linearisation alone
    bool fitted = false;
};

struct Search {
    std::vector<Candidate> candidates;  // best first; with and without effects
    const Candidate& best() const { return candidates.front(); }
    const Candidate& none() const;
};
Search search(const Calibration& car, const Screen& screen, const Progress& progress);

}  // namespace tread::diagnose::select
