#include "blind/score/score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/math/median.h"
#include "tread/problem.h"

namespace tread::blind::score {
namespace {

using answers::CaseAnswer;
using key::CaseKey;
using key::CaseKind;
using key::Program;
using key::SealedKey;

// One answer for each key, in the order of the keys.
std::vector<CaseAnswer> inOrder(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    std::vector<CaseAnswer> ordered;
    for (const CaseKey& key : keys) {
        const auto found =
            std::find_if(answers.begin(), answers.end(), [&](const CaseAnswer& a) { return a.name == key.name; });
        CaseAnswer answer;
        if (found == answers.end()) answer.failure = "the case was not diagnosed";
        else if (found->failure.empty()) answer = *found;
        else answer.failure = found->failure;
        answer.name = key.name;
        ordered.push_back(std::move(answer));
    }
    return ordered;
}

// Detectability differs with and without references: key and diagnosis must agree.
void checkReferences(const SealedKey& key, const std::vector<CaseAnswer>& answers) {
    for (const CaseAnswer& answer : answers) {
        if (!answer.failure.empty() || answer.compared == key.references) continue;
        const auto words = [](bool with) { return with ? "with references" : "without references"; };
        throw LoadError(
            {{"", 0, 0, answer.name,
              fmt::format("found a case that was diagnosed {}, expected one {}: the key says what drives {} "
                          "show (see --no-references)",
                          words(answer.compared), words(key.references), words(key.references))}});
    }
}

std::optional<double> medianOf(const std::vector<double>& values) {
    return values.empty() ? std::nullopt : std::optional(median(values));
}

void addSingles(BlindScore& score, const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    std::vector<double> closures, sets;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].kind != CaseKind::one || !answers[i].failure.empty()) continue;
        sets.push_back(static_cast<double>(answers[i].credible_set.size()));
        if (std::isfinite(answers[i].closure_obtained)) closures.push_back(answers[i].closure_obtained);
    }
    score.median_closure = medianOf(closures);
    score.median_credible_set = medianOf(sets);
    if (!sets.empty())
        score.mean_credible_set = std::accumulate(sets.begin(), sets.end(), 0.0) / static_cast<double>(sets.size());
}

void addNumbersAndClaims(BlindScore& score, const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    std::vector<Claim> claims;
    std::vector<double> relative;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        for (const Claim& claim : claimsOf(keys[i], answers[i])) claims.push_back(claim);
        for (const EstimateError& error : numberErrors(keys[i], answers[i])) {
            score.number_errors.push_back(error);
            relative.push_back(error.relative);
        }
    }
    score.reliability = reliability(claims);
    score.calibration_error = calibrationError(score.reliability);
    score.calibration_error_by_chance = calibrationErrorByChance(score.reliability);
    score.median_relative_error = medianOf(relative);
}

}  // namespace

const Figure& BlindScore::figure(std::string_view name, std::string_view group) const {
    for (const Figure& one : figures) {
        if (one.name == name && one.group == group) return one;
    }
    throw std::out_of_range(fmt::format("no figure {} of the group \"{}\"", name, group));
}

BlindScore score(const SealedKey& key, const std::vector<CaseAnswer>& found, const Program& own) {
    checkReferences(key, found);
    const std::vector<CaseAnswer> answers = inOrder(key.cases, found);
    BlindScore score;
    score.cases = static_cast<int>(key.cases.size());
    score.references = key.references;
    score.frozen = frozen(key.program, found, own);
    score.figures = countFigures(key.cases, answers);
    score.outcomes = outcomes(key.cases, answers);
    score.confusion = confusion(key.cases, answers);
    addNumbersAndClaims(score, key.cases, answers);
    addSingles(score, key.cases, answers);
    std::vector<double> seconds;
    for (const CaseAnswer& answer : answers) {
        if (answer.failure.empty()) seconds.push_back(answer.seconds);
        else ++score.failed;
    }
    score.median_seconds = median(seconds);
    for (const double s : seconds) score.longest_seconds = std::max(score.longest_seconds, s);
    return score;
}

}  // namespace tread::blind::score
