// How good the answers to a blind check are. Pure: keys and answers in, figures out.
#pragma once

#include <map>
#include <string>
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

// What an answer claims: of every effect that it names, also as an alternative, that it is a cause; that nothing shows;
// that something unknown acts.
std::vector<Claim> claimsOf(const CaseKey& key, const CaseAnswer& answer);

struct BlindScore {
    int cases = 0, failed = 0;
    std::vector<Figure> figures;
    std::vector<ReliabilityBin> reliability;
    double calibration_error = 0;
    std::map<std::string, std::map<std::string, int>> confusion;  // truth, answer
    std::vector<double> parameter_errors;                         // in standard deviations, of the causes named
    double median_closure = 0;                                    // obtained, single effects
    double median_credible_set = 0, mean_credible_set = 0;        // sizes, single effects
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
