#include "blind/claims.h"

#include <algorithm>
#include <set>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/settings.h"

namespace tread {
namespace {

using diagnose::kSettings;

using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;

double probabilityOf(const CaseAnswer& answer, const std::string& effect) {
    for (const RankedEffect& ranked : answer.effects) {
        if (ranked.name == effect) return ranked.probability;
    }
    return 0;
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

bool blames(const CaseAnswer& answer) {
    return answer.verdict == Verdict::explained || answer.verdict == Verdict::ambiguous;
}

bool alarms(const CaseAnswer& answer) {
    return blames(answer) || answer.verdict == Verdict::unknown;
}

double natsOf(const CaseAnswer& answer, const std::string& effect) {
    const auto found = answer.testable.find(effect);
    return found == answer.testable.end() ? 0 : found->second;
}

bool testable(const CaseAnswer& answer, const std::string& effect) {
    return natsOf(answer, effect) >= kSettings.testable;
}

bool testable(const CaseKey& key, const CaseAnswer& answer) {
    return std::any_of(key.effects.begin(), key.effects.end(),
                       [&](const std::string& effect) { return testable(answer, effect); });
}

std::vector<Claim> claimsOf(const CaseKey& key, const CaseAnswer& answer) {
    std::vector<Claim> claims;
    for (const std::string& name : namedIn(answer))
        claims.push_back({probabilityOf(answer, name), has(key.effects, name)});
    if (answer.verdict == Verdict::nothing) {
        const bool shows = key.kind == CaseKind::outside || (key.kind != CaseKind::small && testable(key, answer));
        claims.push_back({answer.probability_of_nothing, !shows});
    }
    if (answer.verdict == Verdict::unknown)
        claims.push_back({answer.probability_of_unknown, key.kind == CaseKind::outside});
    return claims;
}

}  // namespace tread
