#include "blind/score.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/median.h"
#include "diagnose/answer/diagnosis.h"

namespace tread {
namespace {

using diagnose::answer::RankedEffect;

// The errors of the parameters of one effect, in standard deviations.
std::vector<double> errorsOf(const CaseKey& key, const RankedEffect& effect) {
    std::vector<double> errors;
    for (const auto& [path, estimate] : effect.parameters) {
        const auto truth = key.numbers.find(path);
        if (truth == key.numbers.end() || !(estimate.sd > 0) || estimate.at_bound) continue;
        errors.push_back((estimate.value - truth->second.value) / estimate.sd);
    }
    return errors;
}

}  // namespace

const Figure& BlindScore::figure(std::string_view name) const {
    for (const Figure& one : figures) {
        if (one.name == name) return one;
    }
    throw std::out_of_range("no figure " + std::string(name));
}

BlindScore score(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    BlindScore score;
    Counter counter;
    std::vector<Claim> claims;
    std::vector<double> closures, seconds, sets;
    for (const CaseKey& key : keys) {
        ++score.cases;
        const auto found =
            std::find_if(answers.begin(), answers.end(), [&](const CaseAnswer& a) { return a.name == key.name; });
        if (found == answers.end() || !found->failure.empty()) {
            ++score.failed;
            continue;
        }
        const CaseAnswer& answer = *found;
        counter.countCase(key, answer);
        for (const Claim& claim : claimsOf(key, answer)) claims.push_back(claim);
        ++score.confusion[wordsOf(key)][wordsOf(answer)];
        seconds.push_back(answer.seconds);
        for (const RankedEffect& effect : answer.effects) {
            if (!has(answer.causes, effect.name) || !has(key.effects, effect.name)) continue;
            for (const double error : errorsOf(key, effect)) {
                score.parameter_errors.push_back(error);
                counter.count("parameter_2sd", std::abs(error) <= 2);
            }
        }
        if (key.kind != CaseKind::one) continue;
        sets.push_back(static_cast<double>(answer.credible_set.size()));
        if (blames(answer) && std::isfinite(answer.closure_obtained)) closures.push_back(answer.closure_obtained);
    }
    score.figures = counter.figures;
    score.reliability = reliability(claims);
    score.calibration_error = calibrationError(score.reliability);
    if (!closures.empty()) score.median_closure = median(closures);
    if (!sets.empty()) {
        score.median_credible_set = median(sets);
        score.mean_credible_set = std::accumulate(sets.begin(), sets.end(), 0.0) / static_cast<double>(sets.size());
    }
    score.median_seconds = median(seconds);
    for (const double s : seconds) score.longest_seconds = std::max(score.longest_seconds, s);
    return score;
}

}  // namespace tread
