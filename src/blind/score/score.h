// Score of the answers to a blind check: a function of key and answers only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "blind/score/claims.h"
#include "blind/score/figures.h"
#include "blind/score/frozen.h"
#include "blind/score/outcomes.h"

namespace tread::blind::score {

struct BlindScore {
    int cases = 0, failed = 0;
    bool references = false;  // the diagnosis compared the drives with references
    Frozen frozen;
    std::vector<Figure> figures;
    std::vector<ReliabilityBin> reliability;
    double calibration_error = 0, calibration_error_by_chance = 0;
    std::vector<OutcomeRow> outcomes;
    Confusion confusion;
    std::vector<EstimateError> number_errors;     // of correctly named causes
    std::optional<double> median_relative_error;  // of number_errors
    std::optional<double> median_closure;         // obtained closure; cases of one effect where it is known
    std::optional<double> median_credible_set, mean_credible_set;  // number of members; cases of one effect
    double median_seconds = 0, longest_seconds = 0;

    // Figure of all cases or of a group. Throws std::out_of_range when there is none.
    const Figure& figure(std::string_view name, std::string_view group = {}) const;
};

// Matches answers to cases by name. A case without an answer has `failed` and counts as the answer "nothing". Throws
// LoadError when the key has no detectability, or when only one of key and answers is for drives with references.
BlindScore score(const key::SealedKey& key, const std::vector<answers::CaseAnswer>& answers,
                 const key::Program& own = key::programHash());

// One sentence.
std::string scoreInWords(const BlindScore& score);

std::string scoreText(const BlindScore& score);  // 110 columns wide
std::string scoreJson(const BlindScore& score);

}  // namespace tread::blind::score
