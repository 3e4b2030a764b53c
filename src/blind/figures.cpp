#include "blind/figures.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "blind/claims.h"
#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr double kConfident = 0.9;

bool alike(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    return std::set<std::string>(a.begin(), a.end()) == std::set<std::string>(b.begin(), b.end());
}

}  // namespace

Counter::Counter() {
    add("named_first", "one effect, testable and told apart: named first", 0.95);
    add("largest_reduction_first", "  the same, by the largest reduction of the gap alone", 0);
    add("bic_first", "  the same, by the information criterion BIC with free tolerances", 0);
    add("named_alone", "one effect, testable: named, and nothing else", 0);
    add("among_first_two", "one effect, testable: among the first two", 0);
    add("named_first_faint", "one effect that may show, but is not testable: named first", 0);
    add("confusable_named", "one effect, testable, that resembles another: named, if only as an alternative", 0);
    add("named_first_any", "one effect, testable or not: named first", 0);
    add("in_credible_set", "one effect: in the set that holds 90 %", 0.9);
    add("false_alarm", "no effect: false alarm", 0.02, false);
    add("largest_reduction_false_alarm", "  the same, by the largest reduction of the gap alone", 0, false);
    add("bic_false_alarm", "  the same, by the information criterion BIC with free tolerances", 0, false);
    add("pair_exact", "two effects, both testable and told apart: both named, and nothing else", 0.85);
    add("pair_one_first", "two effects, one testable: one of them named first", 0.98);
    add("pair_exact_any", "two effects, testable or not: both named, and nothing else", 0);
    add("detected", "something is wrong and testable: detected", 0);
    add("unknown", "effect outside the catalogue: called unknown", 0.9);
    add("unknown_force", "effect outside the catalogue, called unknown: right generalised force", 0.8);
    add("wrongly_blamed", "effect outside the catalogue: blamed on the catalogue", 0.05, false);
    add("small_blamed", "effect too small: another one blamed, or unknown", 0.05, false);
    add("wrong_confident", "any claim: wrong, and stated with more than 0.9", 0.01, false);
    add("parameter_2sd", "parameter of a cause named: truth within 2 sd", 0.9);
    add("closure_covered", "one effect: stated interval of the closure covers what was obtained", 0.85);
}

void Counter::count(std::string_view name, bool hit) {
    Figure& figure = *std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.name == name; });
    figure.of += 1;
    figure.hits += hit ? 1 : 0;
}

void Counter::countCase(const CaseKey& key, const CaseAnswer& answer) {
    switch (key.kind) {
        case CaseKind::one:
            one(key, answer);
            break;
        case CaseKind::two:
            two(key, answer);
            break;
        case CaseKind::none:
            count("false_alarm", alarms(answer));
            baselines("_false_alarm", answer, [](const std::string& claim) { return claim != "none"; });
            break;
        case CaseKind::outside:
        case CaseKind::mixed:
            outside(key, answer);
            break;
        case CaseKind::small:
            small(key, answer);
            break;
    }
    if (key.kind == CaseKind::outside || testable(key, answer)) {
        if (key.kind != CaseKind::small) count("detected", alarms(answer));
    }
    for (const Claim& claim : claimsOf(key, answer))
        count("wrong_confident", !claim.right && claim.probability > kConfident);
}

void Counter::one(const CaseKey& key, const CaseAnswer& answer) {
    const std::string& truth = key.effects.front();
    const bool first = !answer.effects.empty() && answer.effects.front().name == truth;
    const bool named = blames(answer);
    count("named_first_any", first && named);
    count("in_credible_set",
          has(answer.credible_set, truth) || (!testable(key, answer) && has(answer.credible_set, "none")));
    if (!testable(key, answer)) {
        if (natsOf(answer, truth) >= kThresholds.shows) count("named_first_faint", first && named);
        return;
    }
    if (has(answer.confusable, truth)) {
        count("confusable_named", named && namedIn(answer).contains(truth));
        return;
    }
    count("named_first", first && named);
    baselines("_first", answer, [&](const std::string& claim) { return claim == truth; });
    count("named_alone", answer.verdict == Verdict::explained && alike(answer.causes, key.effects));
    count("among_first_two", named && (first || (answer.effects.size() > 1 && answer.effects[1].name == truth)));
    if (std::isfinite(answer.closure_obtained) && named) {
        count("closure_covered",
              answer.closure_low <= answer.closure_obtained && answer.closure_obtained <= answer.closure_high);
    }
}

void Counter::two(const CaseKey& key, const CaseAnswer& answer) {
    const bool exact = answer.verdict == Verdict::explained && alike(answer.causes, key.effects);
    count("pair_exact_any", exact);
    if (!testable(key, answer)) return;
    count("pair_one_first", blames(answer) && !answer.effects.empty() && has(key.effects, answer.effects.front().name));
    const bool both = std::all_of(key.effects.begin(), key.effects.end(), [&](const std::string& effect) {
        return testable(answer, effect) && !has(answer.confusable, effect);
    });
    if (both) count("pair_exact", exact);
}

void Counter::outside(const CaseKey& key, const CaseAnswer& answer) {
    const bool unknown = answer.verdict == Verdict::unknown;
    count("unknown", unknown);
    count("wrongly_blamed", blames(answer));
    if (unknown && !key.generalised_forces.empty())
        count("unknown_force", has(key.generalised_forces, answer.generalised_force));
}

void Counter::small(const CaseKey& key, const CaseAnswer& answer) {
    const bool right = blames(answer) && has(answer.causes, key.effects.front());
    count("small_blamed", alarms(answer) && !right);
}

void Counter::baselines(const std::string& figure, const CaseAnswer& answer,
                        const std::function<bool(const std::string& claim)>& hit) {
    const auto& [largest_reduction, bic] = answer.baselines;
    if (!largest_reduction.empty()) count("largest_reduction" + figure, hit(largest_reduction));
    if (!bic.empty()) count("bic" + figure, hit(bic));
}

void Counter::add(const std::string& name, const std::string& what, double target, bool at_least) {
    figures.push_back({name, what, 0, 0, target, at_least});
}

}  // namespace tread
