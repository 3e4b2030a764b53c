// Search for the sets of effects that explain the recordings: fits of the most promising ones, alone and combined.
#pragma once

#include <vector>

#include "diagnose/select/candidate.h"
#include "diagnose/select/screen.h"

namespace tread::diagnose::select {

struct Search {
    std::vector<Candidate> candidates;  // best first; fitted ones before those that were only screened
    const Candidate& best() const { return candidates.front(); }
    const Candidate& none() const;
};
Search search(const Calibration& car, const Screen& screen, const Progress& progress);

// Fits one of the candidates that were only screened. False when the car cannot be driven with it.
bool fitScreened(const Calibration& car, Search& found, Candidate& screened);

}  // namespace tread::diagnose::select
