// What is asked of the cases of a blind check: each question is a figure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "blind/answer.h"
#include "blind/bands.h"
#include "blind/key.h"

namespace tread {

// Which cases are asked is decided by the key. One hit or miss for each case; where a question is about what is said
// (claims, numbers, the force named with "unknown", the closure where it was looked up), for each thing that is.
struct FigureQuestion {
    std::string name, words;
    std::function<bool(const CaseKey&)> asked;
    std::function<std::vector<bool>(const CaseKey&, const CaseAnswer&)> hits;
    // Whether a simpler method's claim, an effect or "none", is a hit; empty: it claims no such thing.
    std::function<bool(const CaseKey&, const std::string& claim)> simpler = {};
    double target = 0;  // a share that was asked for; 0: none
    bool at_least = true;
    std::string target_group = {};  // of which it was asked; empty: of all
    // What of all that is wrong the question means: by this the case falls into groups.
    std::function<std::vector<std::string>(const CaseKey&)> about = wrongWith;
};
const std::vector<FigureQuestion>& figureQuestions();

}  // namespace tread
