#include "blind/figures.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "blind/bands.h"
#include "blind/claims.h"

namespace tread {
namespace {

using Names = std::vector<std::string>;

constexpr double kConfident = 0.9;  // stated probability
constexpr const char* kSaysNothing = "none";

// What is asked of a case.
struct Question {
    std::string name, words;
    std::function<bool(const CaseKey&)> asked;
    std::function<std::vector<bool>(const CaseKey&, const CaseAnswer&)>
        hits;  // one, or one for each thing that is said
    // Whether a simpler method's claim, an effect or "none", is a hit; empty: it claims no such thing.
    std::function<bool(const CaseKey&, const std::string& claim)> simpler = {};
    double target = 0;
    bool at_least = true;
    std::string target_group = {};                           // for which the target was asked
    std::function<Names(const CaseKey&)> about = wrongWith;  // what is wrong and is meant
};

std::function<bool(const CaseKey&)> ofKind(CaseKind kind) {
    return [kind](const CaseKey& key) { return key.kind == kind; };
}

// One hit or none for each case.
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

// Where the drives show nothing, "none" is right, too.
bool truthInCredibleSet(const CaseKey& key, const CaseAnswer& answer) {
    return has(answer.credible_set, key.effects.front()) ||
           (!anythingShows(key) && has(answer.credible_set, kSaysNothing));
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
    for (const NumberError& error : numberErrors(key, answer)) hits.push_back(std::abs(error.in_sd) <= 2);
    return hits;
}

std::vector<bool> closureCovered(const CaseKey&, const CaseAnswer& answer) {
    if (!std::isfinite(answer.closure_obtained)) return {};
    return {answer.closure_low <= answer.closure_obtained && answer.closure_obtained <= answer.closure_high};
}

const char* const kTestableAndApart = "testable_told_apart";
const char* const kOneTestable = "one_testable";

std::vector<Question> questionsOfEffects() {
    const auto one = ofKind(CaseKind::one), two = ofKind(CaseKind::two), small = ofKind(CaseKind::small);
    return {
        {"named_first", "one effect: named first", one, whether(firstIsTrue), claimsEffect, 0.95, true,
         kTestableAndApart},
        {"named", "one effect: named, if only as an alternative", one, whether(namesAnyTrue), claimsEffect},
        {"in_credible_set", "one effect: in the set that holds 90 %", one, whether(truthInCredibleSet), {}, 0.9},
        {"pair_both", "two effects: both named, nothing else", two, whether(namesExactly), claimsAll, 0.85, true,
         kTestableAndApart},
        {"pair_only_true", "two effects: one or both named, nothing wrong", two, whether(namesOnlyTrue), claimsEffect},
        {"pair_one_first", "two effects: one of them named first", two, whether(firstIsTrue), claimsEffect, 0.98, true,
         kOneTestable},
        {"false_alarm", "no effect: false alarm", ofKind(CaseKind::none),
         whether([](const CaseKey&, const CaseAnswer& a) { return alarms(a); }), claimsAny, 0.02, false},
        {"small_blamed", "small effect: something wrong blamed, or unknown", small,
         whether([](const CaseKey& k, const CaseAnswer& a) { return alarms(a) && !mayBeTrue(k, a); }), claimsWrong,
         0.05, false},
    };
}

std::vector<Question> questionsOfOutsiders() {
    const auto outside = ofKind(CaseKind::outside), mixed = ofKind(CaseKind::mixed);
    const auto force = [](const CaseKey& key) {
        return key.kind == CaseKind::outside && !key.generalised_forces.empty();
    };
    const auto unknown = whether([](const CaseKey&, const CaseAnswer& a) { return callsUnknown(a); });
    return {
        {"unknown", "outside the catalogue: called unknown", outside, unknown, {}, 0.9},
        {"unknown_force", "outside, called unknown: right force named", force, forcesOfUnknown, {}, 0.8},
        {"outside_blamed", "outside the catalogue: an effect blamed", outside,
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
        {"mixed_remainder", "effect and outsider: something unknown said", mixed, unknown, {}, 0, true, {}, outsiderOf},
        {"mixed_both", "effect and outsider: both", mixed,
         whether([](const CaseKey& k, const CaseAnswer& a) { return namesAnyTrue(k, a) && callsUnknown(a); })},
    };
}

std::vector<Question> questionsOfAll() {
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

const std::vector<Question>& questions() {
    static const std::vector<Question> kQuestions = [] {
        std::vector<Question> all = questionsOfEffects();
        for (const auto& more : {questionsOfOutsiders(), questionsOfAll()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return kQuestions;
}

// Whether a case of which `about` is meant belongs to a group.
struct Membership {
    Group group;
    std::function<bool(const CaseKey&, const Names& about)> holds;
};

std::vector<Membership> groupsByEvidence() {
    std::vector<Membership> all;
    for (const Band band : kBands) {
        const std::string words(nameOf(band)), number = std::to_string(static_cast<int>(band));
        all.push_back({{"band_" + number, words + " nats"}, [band](const CaseKey& key, const Names& about) {
                           return !about.empty() && bandOf(weakest(key, about)) == band;
                       }});
        all.push_back({{"stronger_band_" + number, words + " nats, the stronger of two"},
                       [band](const CaseKey& key, const Names& about) {
                           return about.size() > 1 && bandOf(strongest(key, about)) == band;
                       }});
    }
    const auto testable = [](const CaseKey& key, const Names& about) {
        return !about.empty() && weakest(key, about) >= kTestable;
    };
    all.push_back(
        {{kTestableAndApart, "22 nats and more, told apart"},
         [testable](const CaseKey& key, const Names& about) { return testable(key, about) && toldApart(key, about); }});
    all.push_back(
        {{"testable_alike", "22 nats and more, resembles another"}, [testable](const CaseKey& key, const Names& about) {
             return testable(key, about) && !toldApart(key, about);
         }});
    all.push_back({{kOneTestable, "22 nats and more of one at least"}, [](const CaseKey& key, const Names& about) {
                       return !about.empty() && strongest(key, about) >= kTestable;
                   }});
    return all;
}

const std::vector<Membership>& memberships() {
    static const std::vector<Membership> kMemberships = [] {
        std::vector<Membership> all = groupsByEvidence();
        const auto family = [&](const char* name, const char* words, Family which) {
            all.push_back({{name, words}, [which](const CaseKey& key, const Names&) {
                               return !key.outsider.empty() && key.family == which;
                           }});
        };
        family("first_family", "first family", Family::first);
        family("second_family", "second family", Family::second);
        for (std::size_t i = 0; i < enumNames(CaseKind{}).size(); ++i) {
            const std::string name(enumNames(CaseKind{})[i]);
            all.push_back({{"kind_" + name, name},
                           [i](const CaseKey& key, const Names&) { return key.kind == static_cast<CaseKind>(i); }});
        }
        return all;
    }();
    return kMemberships;
}

void count(Figure& figure, const Question& question, const CaseKey& key, const CaseAnswer& answer) {
    for (const bool hit : question.hits(key, answer)) figure.add(hit);
    if (!question.simpler) return;
    const auto& [largest_reduction, bic] = answer.baselines;
    if (!largest_reduction.empty()) figure.largest_reduction.add(question.simpler(key, largest_reduction));
    if (!bic.empty()) figure.bic.add(question.simpler(key, bic));
}

}  // namespace

const std::vector<Group>& groups() {
    static const std::vector<Group> kGroups = [] {
        std::vector<Group> all;
        for (const Membership& one : memberships()) all.push_back(one.group);
        return all;
    }();
    return kGroups;
}

std::vector<Figure> countFigures(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    std::vector<Figure> figures;
    const auto add = [&](const std::string& group, const auto& holds) {
        for (const Question& question : questions()) {
            Figure figure;
            figure.name = question.name;
            figure.words = question.words;
            figure.group = group;
            figure.at_least = question.at_least;
            if (group == question.target_group) figure.target = question.target;
            for (std::size_t i = 0; i < keys.size(); ++i) {
                if (question.asked(keys[i]) && holds(keys[i], question.about(keys[i])))
                    count(figure, question, keys[i], answers[i]);
            }
            figures.push_back(std::move(figure));
        }
    };
    add("", [](const CaseKey&, const Names&) { return true; });
    for (const Membership& one : memberships()) add(one.group.name, one.holds);
    return figures;
}

std::vector<NumberError> numberErrors(const CaseKey& key, const CaseAnswer& answer) {
    std::vector<NumberError> errors;
    for (const RankedEffect& effect : answer.effects) {
        if (!has(answer.causes, effect.name) || !has(key.effects, effect.name)) continue;
        for (const auto& [path, estimate] : effect.parameters) {
            const auto found = key.numbers.find(path);
            if (found == key.numbers.end()) continue;
            const PlantedNumber& truth = found->second;
            const double off = estimate.value - truth.value, relative = std::abs(off / (truth.value - truth.nominal));
            const bool determined = estimate.sd > 0 && !estimate.at_bound && std::isfinite(off);
            errors.push_back({determined ? off / estimate.sd : kInfinity, std::isnan(relative) ? kInfinity : relative});
        }
    }
    return errors;
}

}  // namespace tread
