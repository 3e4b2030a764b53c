// Outcome of every case, counted by kind and detectability.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/answers/answer.h"
#include "blind/key/key.h"

namespace tread::blind::score {

// right: the planted effect is named first (two effects: both and nothing else); the answer is "nothing" without a
// fault, "unknown" for an outsider, and both an effect and "unknown" for a mixed case. partly: some of the faults are
// named, or all and something else. wrong: effects are named, none of which is planted.
enum class Outcome { right, partly, nothing, unknown, wrong, no_answer };
constexpr auto enumNames(Outcome) {
    return std::array<std::string_view, 6>{"right", "partly", "nothing", "unknown", "wrong", "no_answer"};
}

Outcome outcomeOf(const key::CaseKey& key, const answers::CaseAnswer& answer);

// Cases of one kind and the same bands of detectability.
struct OutcomeRow {
    key::CaseKind kind = key::CaseKind::none;
    std::string bands;            // bandsInWords()
    std::array<int, 6> counts{};  // cases by Outcome

    int cases() const;
};

// Sorted by kind and bands. `answers` are in the order of `keys`.
std::vector<OutcomeRow> outcomes(const std::vector<key::CaseKey>& keys,
                                 const std::vector<answers::CaseAnswer>& answers);

// Bands of the faults: "22 to 100"; of two effects "6 to 22, 100 and more", the weaker first; of an effect and an
// outsider, the effect first.
std::string bandsInWords(const key::CaseKey& key);

// Number of cases by truth and answer, each in a few words.
using Confusion = std::map<std::string, std::map<std::string, int>>;
Confusion confusion(const std::vector<key::CaseKey>& keys, const std::vector<answers::CaseAnswer>& answers);
std::string wordsOf(const key::CaseKey& key);
std::string wordsOf(const answers::CaseAnswer& answer);

}  // namespace tread::blind::score
