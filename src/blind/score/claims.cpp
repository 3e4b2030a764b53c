#include "blind/score/claims.h"

#include <algorithm>
#include <cmath>

#include "blind/score/bands.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"

namespace tread::blind::score {
namespace {

using answers::CaseAnswer;
using diagnose::answer::Estimate;
using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;
using key::CaseKey;
using key::PlantedNumber;

double probabilityOf(const CaseAnswer& answer, const std::string& effect) {
    for (const RankedEffect& ranked : answer.effects) {
        if (ranked.name == effect) return ranked.probability;
    }
    return 0;
}

// By how much an effect of typical size changes a number that has this value before; NaN if it does not move it.
double typicalChange(const std::string& effect, const std::string& path, double before) {
    for (const Effect& known : diagnose::catalogue::effectCatalogue()) {
        if (known.name != effect) continue;
        for (const Knob& knob : known.knobs) {
            const auto moved = std::find(knob.paths.begin(), knob.paths.end(), path);
            if (moved != knob.paths.end()) return knob.typicalChange(moved - knob.paths.begin(), before);
        }
    }
    return std::nan("");
}

// The error of an estimate, and of what. Drives with references show the change of a number. What it was before is that
// of a model of another structure that moves like the car.
struct Off {
    double by, of;
};
Off errorOf(const Estimate& estimate, const PlantedNumber& truth, const std::string& effect, const std::string& path,
            bool compared) {
    const double change = compared ? truth.change * typicalChange(effect, path, estimate.neutral) : std::nan("");
    if (std::isfinite(change)) return {estimate.value - estimate.neutral - change, change};
    return {estimate.value - truth.value, truth.value - truth.nominal};
}

}  // namespace

std::set<std::string> namedIn(const CaseAnswer& answer) {
    std::set<std::string> names(answer.causes.begin(), answer.causes.end());
    for (const auto& alternative : answer.alternatives) names.insert(alternative.begin(), alternative.end());
    return names;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool hasAll(const std::vector<std::string>& names, const std::vector<std::string>& of) {
    return std::all_of(of.begin(), of.end(), [&](const std::string& one) { return has(names, one); });
}

bool blames(const CaseAnswer& answer) {
    return !answer.causes.empty();
}

bool callsUnknown(const CaseAnswer& answer) {
    return answer.verdict == Verdict::unknown || answer.verdict == Verdict::partly_explained;
}

bool alarms(const CaseAnswer& answer) {
    return blames(answer) || callsUnknown(answer);
}

bool firstIsTrue(const CaseKey& key, const CaseAnswer& answer) {
    return blames(answer) && !answer.effects.empty() && has(key.effects, answer.effects.front().name);
}

bool namesExactly(const CaseKey& key, const CaseAnswer& answer) {
    return answer.alternatives.empty() && hasAll(answer.causes, key.effects) && hasAll(key.effects, answer.causes);
}

bool namesAnyTrue(const CaseKey& key, const CaseAnswer& answer) {
    const std::set<std::string> named = namedIn(answer);
    return std::any_of(named.begin(), named.end(), [&](const std::string& name) { return has(key.effects, name); });
}

bool mayBeTrue(const CaseKey& key, const CaseAnswer& answer) {
    const auto is_true = [&](const std::vector<std::string>& causes) { return hasAll(key.effects, causes); };
    return blames(answer) &&
           (is_true(answer.causes) || std::any_of(answer.alternatives.begin(), answer.alternatives.end(), is_true));
}

std::vector<Claim> claimsOf(const CaseKey& key, const CaseAnswer& answer) {
    std::vector<Claim> claims;
    for (const std::string& name : namedIn(answer))
        claims.push_back({probabilityOf(answer, name), has(key.effects, name)});
    if (answer.verdict == Verdict::nothing) claims.push_back({answer.probability_of_nothing, !anyDetectable(key)});
    if (callsUnknown(answer)) claims.push_back({answer.probability_of_unknown, !key.outsider.empty()});
    return claims;
}

std::vector<EstimateError> numberErrors(const CaseKey& key, const CaseAnswer& answer) {
    std::vector<EstimateError> errors;
    for (const RankedEffect& effect : answer.effects) {
        if (!has(answer.causes, effect.name) || !has(key.effects, effect.name)) continue;
        for (const auto& [path, estimate] : effect.parameters) {
            const auto found = key.numbers.find(path);
            if (found == key.numbers.end()) continue;
            const Off off = errorOf(estimate, found->second, effect.name, path, answer.compared);
            const double relative = std::abs(off.by / off.of);
            const bool determined = estimate.sd > 0 && !estimate.at_bound && std::isfinite(off.by);
            errors.push_back(
                {determined ? off.by / estimate.sd : kInfinity, std::isnan(relative) ? kInfinity : relative});
        }
    }
    return errors;
}

}  // namespace tread::blind::score
