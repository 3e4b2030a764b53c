// The squared gap in parts: what tolerances explain, what each cause adds, what remains.
#pragma once

#include "diagnose/select/verdict.h"

namespace tread::diagnose::explain {

// Fills training and held_out of a diagnosis (D48a).
void decompose(answer::Diagnosis& diagnosis, const select::Calibration& car, const select::Judgement& judgement,
               const select::HeldOut& held_out);

}  // namespace tread::diagnose::explain
