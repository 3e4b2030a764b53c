#include "blind/score/questions.h"

#include <algorithm>
#include <cmath>

#include "blind/score/bands.h"
#include "blind/score/claims.h"
#include "blind/score/groups.h"

namespace tread::blind::score {
namespace {

using answers::CaseAnswer;
using key::CaseKey;
using key::CaseKind;

using Names = std::vector<std::string>;

constexpr double kConfident = 0.9;  // stated probability
constexpr const char* kSaysNothing = "none";

std::function<bool(const CaseKey&)> ofKind(CaseKind kind) {
    return [kind](const CaseKey& key) { return key.kind == kind; };
}

// One hit or miss per case.
auto whether(bool (*hit)(const CaseKey&, const CaseAnswer&)) {
    return [hit](const CaseKey& key, const CaseAnswer& answer) { return std::vector<bool>{hit(key, answer)}; };
}

Names effectsOf(const CaseKey& key) {
    return key.effects;
}

Names outsiderOf(const CaseKey& key) {
    return {key.outsider};
}

bool claimsEffect(const CaseKey& key, const std::string& claim) {
    return has(key.effects, claim);
}

bool claimsAny(const CaseKey&, const std::string& claim) {
    return claim != kSaysNothing;
}

bool claimsWrong(const CaseKey& key, const std::string& claim) {
    return claim != kSaysNothing && !has(key.effects, claim);
}

bool claimsAll(const CaseKey& key, const std::string& claim) {
    return key.effects == Names{claim};
}

bool namesOnlyTrue(const CaseKey& key, const CaseAnswer& answer) {
    const std::set<std::string> named = namedIn(answer);
    return !named.empty() && !callsUnknown(answer) && hasAll(key.effects, {named.begin(), named.end()});
}

// If no fault is detectable, "none" is right as well.
bool truthInCredibleSet(const CaseKey& key, const CaseAnswer& answer) {
    return has(answer.credible_set, key.effects.front()) ||
           (!anyDetectable(key) && has(answer.credible_set, kSaysNothing));
}

std::vector<bool> forcesOfUnknown(const CaseKey& key, const CaseAnswer& answer) {
    if (!callsUnknown(answer)) return {};
    return {has(key.generalised_forces, answer.generalised_force)};
}

std::vector<bool> wrongAndConfident(const CaseKey& key, const CaseAnswer& answer) {
    std::vector<bool> hits;
    for (const Claim& claim : claimsOf(key, answer)) hits.push_back(!claim.right && claim.probability > kConfident);
    return hits;
}

std::vector<bool> numbersWithinTwo(const CaseKey& key, const CaseAnswer& answer) {
    std::vector<bool> hits;
    for (const EstimateError& error : numberErrors(key, answer)) hits.push_back(std::abs(error.in_sd) <= 2);
    return hits;
}

std::vector<bool> closureCovered(const CaseKey&, const CaseAnswer& answer) {
    if (!std::isfinite(answer.closure_obtained)) return {};
    return {answer.closure_low <= answer.closure_obtained && answer.closure_obtained <= answer.closure_high};
}

std::vector<FigureQuestion> questionsOfEffects() {
    const auto one = ofKind(CaseKind::one), two = ofKind(CaseKind::two), small = ofKind(CaseKind::small);
    return {
        {"named_first", "one effect: ranked first", one, whether(firstIsTrue), claimsEffect, 0.95, true,
         kTestableAndApart},
        {"named", "one effect: named, if only as an alternative", one, whether(namesAnyTrue), claimsEffect},
        {"in_credible_set", "one effect: in the 90 % credible set", one, whether(truthInCredibleSet), {}, 0.9},
        {"pair_both", "two effects: both named, nothing else", two, whether(namesExactly), claimsAll, 0.85, true,
         kTestableAndApart},
        {"pair_only_true", "two effects: one or both named, nothing wrong", two, whether(namesOnlyTrue), claimsEffect},
        {"pair_one_first", "two effects: one of them ranked first", two, whether(firstIsTrue), claimsEffect, 0.98, true,
         kOneTestable},
        {"false_alarm", "no fault: false alarm", ofKind(CaseKind::none),
         whether([](const CaseKey&, const CaseAnswer& a) { return alarms(a); }), claimsAny, 0.02, false},
        {"small_blamed", "small effect: wrong effect named, or unknown", small,
         whether([](const CaseKey& k, const CaseAnswer& a) { return alarms(a) && !mayBeTrue(k, a); }), claimsWrong,
         0.05, false},
    };
}

std::vector<FigureQuestion> questionsOfOutsiders() {
    const auto outside = ofKind(CaseKind::outside), mixed = ofKind(CaseKind::mixed);
    const auto force = [](const CaseKey& key) {
        return key.kind == CaseKind::outside && !key.generalised_forces.empty();
    };
    const auto unknown = whether([](const CaseKey&, const CaseAnswer& a) { return callsUnknown(a); });
    return {
        {"unknown", "outside the catalogue: reported as unknown", outside, unknown, {}, 0.9},
        {"unknown_force",
         "outside the catalogue, reported as unknown: right force named",
         force,
         forcesOfUnknown,
         {},
         0.8},
        {"outside_blamed", "outside the catalogue: an effect named", outside,
         whether([](const CaseKey&, const CaseAnswer& a) { return blames(a); }), claimsAny, 0.05, false},
        {"mixed_effect",
         "effect and outsider: the effect named",
         mixed,
         whether(namesAnyTrue),
         claimsEffect,
         0,
         true,
         {},
         effectsOf},
        {"mixed_remainder",
         "effect and outsider: reported as partly unknown",
         mixed,
         unknown,
         {},
         0,
         true,
         {},
         outsiderOf},
        {"mixed_both", "effect and outsider: both", mixed,
         whether([](const CaseKey& k, const CaseAnswer& a) { return namesAnyTrue(k, a) && callsUnknown(a); })},
    };
}

std::vector<FigureQuestion> questionsOfAll() {
    const auto any = [](const CaseKey&) { return true; };
    const auto wrong = [](const CaseKey& key) { return key.kind != CaseKind::none && key.kind != CaseKind::small; };
    return {
        {"detected", "anything wrong, not small: detected", wrong,
         whether([](const CaseKey&, const CaseAnswer& a) { return alarms(a); }), claimsAny},
        {"wrong_confident", "any claim: wrong, stated with more than 0.9", any, wrongAndConfident, {}, 0.01, false},
        {"numbers_2sd", "number of a right cause: truth within 2 sd", any, numbersWithinTwo, {}, 0.9},
        {"closure_covered", "one effect: closure within its interval", ofKind(CaseKind::one), closureCovered, {}, 0.85},
    };
}

}  // namespace

const std::vector<FigureQuestion>& figureQuestions() {
    static const std::vector<FigureQuestion> kQuestions = [] {
        std::vector<FigureQuestion> all = questionsOfEffects();
        for (const auto& more : {questionsOfOutsiders(), questionsOfAll()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return kQuestions;
}

}  // namespace tread::blind::score
