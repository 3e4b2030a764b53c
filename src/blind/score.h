// How good the answers to a blind check are. Pure: keys and answers in, figures out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blind/claims.h"
#include "blind/figures.h"

namespace tread {

struct BlindScore {
    int cases = 0, failed = 0;
    std::vector<Figure> figures;
    std::vector<ReliabilityBin> reliability;
    double calibration_error = 0;
    std::map<std::string, std::map<std::string, int>> confusion;   // truth, answer
    std::vector<double> parameter_errors;                          // in standard deviations, of the causes named
    std::optional<double> median_closure;                          // obtained, single effects that were blamed
    std::optional<double> median_credible_set, mean_credible_set;  // sizes, single effects
    double median_seconds = 0, longest_seconds = 0;

    const Figure& figure(std::string_view name) const;
};

// Answers are found by the names of their cases; cases without one count as failed.
BlindScore score(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers);

std::string scoreText(const BlindScore& score);  // for people
std::string scoreJson(const BlindScore& score);

// What is so, and what was answered, in few words: rows and columns of the confusion.
std::string wordsOf(const CaseKey& key);
std::string wordsOf(const CaseAnswer& answer);

}  // namespace tread
