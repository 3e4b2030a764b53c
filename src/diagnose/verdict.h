// From evidence to an answer: probabilities, and what may be said.
#pragma once

#include "diagnose/search.h"
#include "diagnose/unknown.h"

namespace tread {

// Fills verdict, causes, alternatives, effects, probabilities, credible set, constancy and the answer in words.
void judge(Diagnosis& diagnosis, const Study& study, const Screen& screen, const Search& found,
           const Inflation& inflation);

}  // namespace tread
