// How far the gap shrinks: nominal car, tolerances used up, and with the effect; on the drives from which it was
// learned and on those held out.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::explain {

// The stages of the gap: the nominal car at the origin, the calibrated one, and the answer.
struct Stages {
    model::Deviation calibrated;
    const select::Fit& answer;
};

// Fills how_far, unexplained.share and the overlays of a diagnosis, and warns of what is left out of the drives.
void howFar(answer::Diagnosis& diagnosis, const select::Calibration& car, const Stages& stages);

}  // namespace tread::diagnose::explain
