// The figures of a blind check, counted case by case.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "blind/answer.h"
#include "blind/key.h"
#include "blind/reliability.h"

namespace tread {

struct Figure {
    std::string name;  // in the JSON
    std::string what;  // in words
    int hits = 0, of = 0;
    double target = 0;
    bool at_least = true;  // the target is a least share, else a most

    double share() const { return of > 0 ? static_cast<double>(hits) / of : 0; }
    Interval interval() const { return wilson(hits, of); }
};

// The figures that are asked for, with what was counted so far.
class Counter {
public:
    Counter();

    void count(std::string_view name, bool hit);
    // Everything that a case has to say, but for the errors of its parameters.
    void countCase(const CaseKey& key, const CaseAnswer& answer);

    std::vector<Figure> figures;

private:
    void add(const std::string& name, const std::string& what, double target, bool at_least = true);
    void one(const CaseKey& key, const CaseAnswer& answer);
    void two(const CaseKey& key, const CaseAnswer& answer);
    void outside(const CaseKey& key, const CaseAnswer& answer);
    void small(const CaseKey& key, const CaseAnswer& answer);
    // What simpler methods claim, where the answer tells it.
    void baselines(const std::string& figure, const CaseAnswer& answer,
                   const std::function<bool(const std::string& claim)>& hit);
};

}  // namespace tread
