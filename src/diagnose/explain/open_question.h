// What a diagnosis leaves open.
#pragma once

#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::explain {

// Two cars that the recordings leave open, and the fits whose free parameters may still move to make one car look like
// the other: whichever of them is true, the manoeuvre must tell.
struct Question {
    std::vector<std::string> causes_of_one, causes_of_other;  // without those of the other: the first from none
    model::Deviation one, other;
    std::vector<const select::Fit*> fits;
};

// The answer against those that come close to it; without an answer, the effects that could not be seen against none.
std::vector<Question> openQuestions(const answer::Diagnosis& diagnosis, const model::Problem& problem,
                                    const select::Search& found);

}  // namespace tread::diagnose::explain
