// The set of effects that is named: the most probable one that predicts and stays plausible.
#pragma once

#include <string>
#include <utility>
#include <vector>

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

using Struck = std::vector<std::pair<const Candidate*, std::string>>;  // models that cannot be the answer, and why

struct Choice {
    Posterior posterior;  // of the models that can be the answer
    Judgement judgement;
    Struck struck;
};

// Chooses among the models of a search. Those that were only screened are fitted where they might be the answer.
// `vibration`: of the recordings, an unknown cause.
Choice chosen(const Calibration& car, Search& found, const HeldOut& held_out, answer::Vibration vibration);

// Probability that an effect acts.
double probabilityOf(std::size_t effect, const Calibration& car, const Posterior& posterior,
                     const Judgement& judgement);

}  // namespace tread::diagnose::select
