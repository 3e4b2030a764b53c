// How far the gap shrinks from the nominal car to the calibrated car and to the car with the causes, on training drives
// and on held-out drives.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/held_out.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::explain {

// Stages after the nominal car: the calibrated car and the answer.
struct Stages {
    model::Deviation calibrated;
    const select::Fit& answer;
};

// Fills how_far, the cuts and the overlays of a diagnosis, and adds warnings about parts of the drives that are left
// out.
void howFar(answer::Diagnosis& diagnosis, const select::Calibration& car, const select::HeldOut& held_out,
            const Stages& stages);

}  // namespace tread::diagnose::explain
