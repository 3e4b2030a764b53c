// What a diagnosis leaves open.
#pragma once

#include <string>
#include <vector>

#include "diagnose/search.h"

namespace tread {

// Two cars that the recordings leave open, and the fits whose free parameters may still move to make one car look like
// the other: whichever of them is true, the manoeuvre must tell.
struct Question {
    std::string separates;
    Deviation one, other;
    std::vector<const Fit*> fits;
};

// The answer against those that come close to it; without an answer, the effects that could not be seen against none.
std::vector<Question> openQuestions(const Diagnosis& diagnosis, const Study& study, const Search& found);

}  // namespace tread
