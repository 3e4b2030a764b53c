// The figures of a blind check: of so many cases (claims, numbers), how many were so. What is asked of a case, and into
// which groups it falls, is decided by the key alone (questions.h, groups.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "blind/answer.h"
#include "blind/key.h"
#include "blind/reliability.h"

namespace tread {

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
    std::string name;              // in the JSON
    std::string words;             // for people
    std::string group;             // of the cases that are counted; empty: all
    Count largest_reduction, bic;  // the same, by what simpler methods answer; `of` 0: they answer no such thing
    double target = 0;             // a share that was asked for; 0: none
    bool at_least = true;          // the target is a least share, else a most

    bool missed() const { return target > 0 && of > 0 && (at_least ? share() < target : share() > target); }
};

// All figures, those of all cases first, then group by group; each in the order of the questions. A case whose answer
// has failed is counted as one that says nothing. Answers stand in the order of the keys. Throws LoadError where a key
// does not say what its drives show.
std::vector<Figure> countFigures(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers);

}  // namespace tread
