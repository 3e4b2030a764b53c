// Figures of a blind check: hits out of a number of cases, claims or numbers. The key alone decides which questions a
// case answers (questions.h) and to which groups it belongs (groups.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "blind/answers/answer.h"
#include "blind/key/key.h"
#include "blind/score/reliability.h"

namespace tread::blind::score {

struct Count {
    int hits = 0, of = 0;

    void add(bool hit) {
        of += 1;
        hits += hit ? 1 : 0;
    }
    double share() const { return of > 0 ? static_cast<double>(hits) / of : 0; }
    Interval interval() const { return wilson(hits, of); }
    bool operator==(const Count&) const = default;
};

struct Figure : Count {
    std::string name;              // key in the JSON
    std::string words;             // for people
    std::string group;             // group of cases; empty: all
    Count largest_reduction, bic;  // the same for the answers of simpler methods; `of` is 0 where these give none
    double target = 0;             // required share; 0: none
    bool at_least = true;          // the target is a lower limit, else an upper limit

    bool missed() const { return target > 0 && of > 0 && (at_least ? share() < target : share() > target); }
};

// All figures: of all cases first, then group by group, each in the order of the questions. A failed answer counts as
// the answer "nothing". `answers` are in the order of `keys`. Throws LoadError when a key has no detectability.
std::vector<Figure> countFigures(const std::vector<key::CaseKey>& keys,
                                 const std::vector<answers::CaseAnswer>& answers);

}  // namespace tread::blind::score
