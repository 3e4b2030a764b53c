// How good the answers to a blind check are. Pure: key and answers in, figures out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "blind/claims.h"
#include "blind/figures.h"
#include "blind/frozen.h"
#include "blind/outcomes.h"

namespace tread {

struct BlindScore {
    int cases = 0, failed = 0;
    bool references = false;  // the drives were compared with references
    Frozen frozen;
    std::vector<Figure> figures;
    std::vector<ReliabilityBin> reliability;
    double calibration_error = 0;
    std::vector<OutcomeRow> outcomes;
    Confusion confusion;
    std::vector<EstimateError> number_errors;       // of the causes rightly named
    std::optional<double> median_relative_error;  // of these numbers
    std::optional<double> median_closure;         // obtained, single effects where it could be looked up
    std::optional<double> median_credible_set, mean_credible_set;  // sizes, single effects
    double median_seconds = 0, longest_seconds = 0;

    // Of all cases, or of a group; throws std::out_of_range when there is no such figure.
    const Figure& figure(std::string_view name, std::string_view group = {}) const;
};

// Answers are found by the names of their cases. A case without one counts as answered with nothing; it has `failed`.
// Throws LoadError where the key does not say what the drives show, or says it of drives with references when the
// answers are without, or the other way round.
BlindScore score(const BlindKey& key, const std::vector<CaseAnswer>& answers, const Program& own = programHash());

// In one sentence.
std::string scoreInWords(const BlindScore& score);

std::string scoreText(const BlindScore& score);  // for people, 110 columns wide
std::string scoreJson(const BlindScore& score);

}  // namespace tread
