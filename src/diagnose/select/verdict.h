// From probabilities to a verdict: the causes are the most probable set that predicts and stays plausible.
#pragma once

#include "diagnose/select/closeness.h"
#include "diagnose/select/held_out.h"
#include "diagnose/select/posterior.h"
#include "diagnose/select/prediction.h"
#include "diagnose/select/what_remains.h"

namespace tread::diagnose::select {

// What is known about the answer besides what the diagnosis tells of it.
struct Judgement {
    const Candidate* named = nullptr;  // the model without effects when no cause is named
    Fit answer;                        // of the causes, their sizes free of the prior that ranked them
    Closeness closeness;               // of cars with the causes
    Remains remains;
    Prediction prediction;
};

// Fills verdict, causes, alternatives, effects, probabilities, expected evidence and credible set. Candidates that were
// only screened are fitted where they might be the answer. `vibration`: of the recordings, an unknown cause.
Judgement judge(answer::Diagnosis& diagnosis, const Calibration& car, const std::vector<double>& expected_evidence,
                Search& found, const HeldOut& held_out, answer::Vibration vibration);

}  // namespace tread::diagnose::select
