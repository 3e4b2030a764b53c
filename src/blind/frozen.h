// Whether a blind check is one: the program that made the cases, the one that answered and the one that scores are the
// same.
#pragma once

#include <string>
#include <vector>

#include "blind/answer.h"
#include "blind/program_hash.h"

namespace tread {

struct Frozen {
    bool frozen = false;   // all that decides a case or an answer is the same for key, answers and this program
    bool scoring = false;  // what counts the answers is that which the key records
    std::string words;     // a sentence, with the programs where they differ
};

Frozen frozen(const Program& key, const std::vector<CaseAnswer>& answers, const Program& own = programHash());

}  // namespace tread
