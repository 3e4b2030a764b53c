// Whether a blind check is frozen: the cases were made, diagnosed and scored by the same program.
#pragma once

#include <string>
#include <vector>

#include "blind/answers/answer.h"
#include "blind/key/program_hash.h"

namespace tread::blind::score {

struct Frozen {
    bool frozen = false;   // same Program::diagnosis in key, answers and this program
    bool scoring = false;  // same Program::scoring in key and this program
    std::string words;     // a sentence that names the programs where they differ
};

Frozen frozen(const key::Program& key, const std::vector<answers::CaseAnswer>& answers,
              const key::Program& own = key::programHash());

}  // namespace tread::blind::score
