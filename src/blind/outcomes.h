// What became of the cases, by their kind and by what their drives show: every case in one column.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/answer.h"
#include "blind/key.h"

namespace tread {

// right: what acts is named first (of two effects: both, nothing else); nothing, where nothing acts; unknown, where
// something from outside of the catalogue does; for both at once, both. partly: of what acts some is named, or all
// beside something else. wrong: effects are named, and none of them acts.
enum class Outcome { right, partly, nothing, unknown, wrong, no_answer };
constexpr auto enumNames(Outcome) {
    return std::array<std::string_view, 6>{"right", "partly", "nothing", "unknown", "wrong", "no_answer"};
}

Outcome outcomeOf(const CaseKey& key, const CaseAnswer& answer);

// A kind of cases of which the drives show alike, with the number of cases of each outcome.
struct OutcomeRow {
    CaseKind kind = CaseKind::none;
    std::string shows;
    std::array<int, 6> counts{};  // by Outcome

    int cases() const;
};

// Answers stand in the order of the keys. Sorted by kind and by what the drives show.
std::vector<OutcomeRow> outcomes(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers);

// "22 to 100"; of two effects "6 to 22, 100 and more", the weaker first; of an effect and an outsider that of the
// effect first.
std::string bandsInWords(const CaseKey& key);

// What is so, and what was answered, in few words; and how often.
using Confusion = std::map<std::string, std::map<std::string, int>>;
Confusion confusion(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers);
std::string wordsOf(const CaseKey& key);
std::string wordsOf(const CaseAnswer& answer);

}  // namespace tread
