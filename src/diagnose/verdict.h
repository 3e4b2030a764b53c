// From probabilities to an answer: what may be said.
#pragma once

#include "diagnose/missing_force.h"
#include "diagnose/posterior.h"

namespace tread {

// Fills verdict, causes, alternatives, effects, probabilities, credible set, constancy and the answer in words.
void judge(Diagnosis& diagnosis, const Study& study, const Screen& screen, const Search& found, const Outside& outside,
           const MissingForce& missing);

}  // namespace tread
