// Questions about the cases of a blind check; each yields a figure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "blind/answers/answer.h"
#include "blind/key/key.h"
#include "blind/score/bands.h"

namespace tread::blind::score {

// The key decides which cases a question concerns (`asked`). It yields one hit or miss per case; questions about
// claims, numbers, the force of an unknown cause, or the obtained closure yield one for each that the answer contains.
struct FigureQuestion {
    std::string name, words;
    std::function<bool(const key::CaseKey&)> asked;
    std::function<std::vector<bool>(const key::CaseKey&, const answers::CaseAnswer&)> hits;
    // Whether the claim of a simpler method, an effect or "none", is a hit; empty: such methods do not answer the
    // question.
    std::function<bool(const key::CaseKey&, const std::string& claim)> simpler = {};
    double target = 0;  // required share; 0: none
    bool at_least = true;
    std::string target_group = {};  // group to which the target applies; empty: all cases
    // The faults that the question concerns; they determine the groups of the case.
    std::function<std::vector<std::string>(const key::CaseKey&)> about = faultsOf;
};
const std::vector<FigureQuestion>& figureQuestions();

}  // namespace tread::blind::score
