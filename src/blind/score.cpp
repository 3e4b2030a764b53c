#include "blind/score.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "base/median.h"
#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr double kConfident = 0.9;

bool has(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool alike(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    return std::set<std::string>(a.begin(), a.end()) == std::set<std::string>(b.begin(), b.end());
}

bool blames(const CaseAnswer& answer) {
    return answer.verdict == Verdict::explained || answer.verdict == Verdict::ambiguous;
}

bool alarms(const CaseAnswer& answer) {
    return blames(answer) || answer.verdict == Verdict::unknown;
}

double nats(const CaseAnswer& answer, const std::string& effect) {
    const auto found = answer.testable.find(effect);
    return found == answer.testable.end() ? 0 : found->second;
}

// What this case can show: nothing may be answered where the drives show nothing.
bool testable(const CaseKey& key, const CaseAnswer& answer) {
    return std::any_of(key.effects.begin(), key.effects.end(),
                       [&](const std::string& effect) { return nats(answer, effect) >= kThresholds.testable; });
}

double probabilityOf(const CaseAnswer& answer, const std::string& effect) {
    for (const RankedEffect& ranked : answer.effects) {
        if (ranked.name == effect) return ranked.probability;
    }
    return 0;
}

std::set<std::string> namedIn(const CaseAnswer& answer) {
    std::set<std::string> names(answer.causes.begin(), answer.causes.end());
    for (const auto& alternative : answer.alternatives) names.insert(alternative.begin(), alternative.end());
    return names;
}

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

// The figures of the issue, counted case by case.
class Counter {
public:
    Counter() {
        add("named_first", "one effect, testable: named first", 0.95);
        add("largest_reduction_first", "  the same, by the largest reduction of the gap alone", 0);
        add("bic_first", "  the same, by the information criterion BIC with free tolerances", 0);
        add("named_alone", "one effect, testable: named, and nothing else", 0);
        add("among_first_two", "one effect, testable: among the first two", 0);
        add("named_first_faint", "one effect that may show, but is not testable: named first", 0);
        add("named_first_any", "one effect, testable or not: named first", 0);
        add("in_credible_set", "one effect: in the set that holds 90 %", 0.9);
        add("false_alarm", "no effect: false alarm", 0.02, false);
        add("largest_reduction_false_alarm", "  the same, by the largest reduction of the gap alone", 0, false);
        add("bic_false_alarm", "  the same, by the information criterion BIC with free tolerances", 0, false);
        add("pair_exact", "two effects, both testable: both named, and nothing else", 0.85);
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

    void count(const std::string& name, bool hit) {
        Figure& figure = *std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.name == name; });
        figure.of += 1;
        figure.hits += hit ? 1 : 0;
    }

    void one(const CaseKey& key, const CaseAnswer& answer) {
        const std::string& truth = key.effects.front();
        const bool first = !answer.effects.empty() && answer.effects.front().name == truth;
        const bool named = alarms(answer);
        count("named_first_any", first && named);
        count("in_credible_set",
              has(answer.credible_set, truth) || (!testable(key, answer) && has(answer.credible_set, "none")));
        if (!testable(key, answer)) {
            if (nats(answer, truth) >= kThresholds.shows) count("named_first_faint", first && named);
            return;
        }
        count("named_first", first && named);
        baselines("_first", answer, [&](const std::string& claim) { return claim == truth; });
        count("named_alone", answer.verdict == Verdict::explained && alike(answer.causes, key.effects));
        count("among_first_two", named && (first || (answer.effects.size() > 1 && answer.effects[1].name == truth)));
        if (std::isfinite(answer.closure_obtained) && blames(answer)) {
            count("closure_covered",
                  answer.closure_low <= answer.closure_obtained && answer.closure_obtained <= answer.closure_high);
        }
    }

    void two(const CaseKey& key, const CaseAnswer& answer) {
        const bool exact = answer.verdict == Verdict::explained && alike(answer.causes, key.effects);
        count("pair_exact_any", exact);
        if (!testable(key, answer)) return;
        count("pair_one_first",
              alarms(answer) && !answer.effects.empty() && has(key.effects, answer.effects.front().name));
        const bool both = std::all_of(key.effects.begin(), key.effects.end(), [&](const std::string& effect) {
            return nats(answer, effect) >= kThresholds.testable;
        });
        if (both) count("pair_exact", exact);
    }

    void outside(const CaseKey& key, const CaseAnswer& answer) {
        const bool unknown = answer.verdict == Verdict::unknown;
        count("unknown", unknown);
        count("wrongly_blamed", blames(answer));
        if (unknown && !key.generalised_forces.empty())
            count("unknown_force", has(key.generalised_forces, answer.generalised_force));
    }

    void small(const CaseKey& key, const CaseAnswer& answer) {
        const bool right = blames(answer) && has(answer.causes, key.effects.front());
        count("small_blamed", alarms(answer) && !right);
    }

    // What simpler methods claim, where the answer tells it.
    template <class Hit>
    void baselines(const std::string& figure, const CaseAnswer& answer, Hit hit) {
        const auto& [largest_reduction, bic] = answer.baselines;
        if (!largest_reduction.empty()) count("largest_reduction" + figure, hit(largest_reduction));
        if (!bic.empty()) count("bic" + figure, hit(bic));
    }

    std::vector<Figure> figures;

private:
    void add(const std::string& name, const std::string& what, double target, bool at_least = true) {
        figures.push_back({name, what, 0, 0, target, at_least});
    }
};

void countCase(Counter& counter, const CaseKey& key, const CaseAnswer& answer) {
    switch (key.kind) {
        case CaseKind::one:
            counter.one(key, answer);
            break;
        case CaseKind::two:
            counter.two(key, answer);
            break;
        case CaseKind::none:
            counter.count("false_alarm", alarms(answer));
            counter.baselines("_false_alarm", answer, [](const std::string& claim) { return claim != "none"; });
            break;
        case CaseKind::outside:
            counter.outside(key, answer);
            break;
        case CaseKind::small:
            counter.small(key, answer);
            break;
    }
    if (key.kind == CaseKind::outside || testable(key, answer)) {
        if (key.kind != CaseKind::small) counter.count("detected", alarms(answer));
    }
    for (const Claim& claim : claimsOf(key, answer))
        counter.count("wrong_confident", !claim.right && claim.probability > kConfident);
}

}  // namespace

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
        countCase(counter, key, answer);
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
        if (blames(answer)) closures.push_back(answer.closure_obtained);
    }
    score.figures = counter.figures;
    score.reliability = reliability(claims);
    score.calibration_error = calibrationError(score.reliability);
    score.median_closure = median(closures);
    score.median_credible_set = median(sets);
    if (!sets.empty())
        score.mean_credible_set = std::accumulate(sets.begin(), sets.end(), 0.0) / static_cast<double>(sets.size());
    score.median_seconds = median(seconds);
    for (const double s : seconds) score.longest_seconds = std::max(score.longest_seconds, s);
    return score;
}

}  // namespace tread
