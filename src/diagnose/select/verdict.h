// From the chosen set of effects to a verdict.
#pragma once

#include "diagnose/select/choice.h"

namespace tread::diagnose::select {

// Fills verdict, causes, alternatives, effects, probabilities, expected evidence and credible set. Candidates that were
// only screened are fitted where they might be the answer. `vibration`: of the recordings, an unknown cause.
Judgement judge(answer::Diagnosis& diagnosis, const Calibration& car, const std::vector<double>& expected_evidence,
                Search& found, const HeldOut& held_out, answer::Vibration vibration);

}  // namespace tread::diagnose::select
