// Questions that a diagnosis leaves open.
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::explain {

// Two cars that the recordings cannot tell apart, and the fits whose free parameters may make one look like the other.
// A manoeuvre must separate them whichever is true.
struct Question {
    std::vector<std::string> causes_of_one, causes_of_other;  // causes of each car; empty: the car without a cause
    model::Deviation one, other;
    std::vector<const select::Fit*> fits;
};

// The answer against its close rivals; without an answer, the effects that these drives could not show against no
// effect.
std::vector<Question> openQuestions(const answer::Diagnosis& diagnosis, const model::Problem& problem,
                                    const select::Search& found);

}  // namespace tread::diagnose::explain
