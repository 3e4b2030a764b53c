#include "diagnose/search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr std::size_t kFewestRefits = 4, kMostRefits = 8;
constexpr double kHopeless = 25;           // nats behind the best of the screen: not refitted beyond the fewest
constexpr double kUncertain = 3;           // nats that a new linearisation can add
constexpr double kBehind = 15;             // nats behind the best single: it will not come first
constexpr int kMostRounds = 3;             // of linearising anew about one of them
constexpr double kSettled = 8;             // nats: a fit that gained less needs no new linearisation
constexpr std::size_t kRelinearised = 2;   // best singles about which the nuisances are linearised anew
constexpr std::size_t kFurtherRefits = 3;  // effects tried beside each of these
constexpr std::size_t kMostEffects = 3;
constexpr double kStuck = 0.02;  // units: a knob that the fit left where it was

using Progress = std::function<void(double, const std::string&)>;

std::vector<Eigen::Index> knobsOf(const Study& study, const std::vector<std::size_t>& effects) {
    std::vector<Eigen::Index> knobs;
    for (const std::size_t e : effects) knobs.insert(knobs.end(), study.knobs[e].begin(), study.knobs[e].end());
    return knobs;
}

std::vector<std::size_t> bestFirst(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    return order;
}

void sort(std::vector<Candidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        if (a.fitted != b.fitted) return a.fitted;
        return a.log_evidence > b.log_evidence;
    });
}

// Starts of a knob: where the linear screen sees it, and, where it may only grow, also from well inside.
std::vector<Deviation> starts(const Study& study, const std::vector<Eigen::Index>& knobs, const Deviation& from) {
    std::vector<Deviation> points{from};
    Deviation inside = from;
    bool one_sided = false;
    for (const Eigen::Index k : knobs) {
        const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(k)];
        if (from(k) != 0 || (parameter.lowest < 0 && parameter.highest > 0)) continue;
        inside(k) = parameter.lowest == 0 ? std::min(1.0, parameter.highest) : std::max(-1.0, parameter.lowest);
        one_sided = true;
    }
    if (one_sided) points.push_back(inside);
    return points;
}

// What the nuisances did in place of these knobs is given to them: the same car, by the likelier way.
Deviation handedOver(const Study& study, const std::vector<Eigen::Index>& knobs, Deviation at) {
    for (const Eigen::Index k : knobs) {
        if (at(k) != 0) continue;
        const Parameter& knob = study.bench.parameters[static_cast<std::size_t>(k)];
        double both = 0, squares = 1;
        const std::vector<Share> shares = study.asNuisances(knob);
        for (const Share& share : shares) {
            both += share.units * at(static_cast<Eigen::Index>(share.of));
            squares += share.units * share.units;
        }
        at(k) = std::clamp(both / squares, knob.lowest, knob.highest);
        for (const Share& share : shares) at(static_cast<Eigen::Index>(share.of)) -= at(k) * share.units;
    }
    return at;
}

std::optional<Candidate> refit(Study& study, const Ground& ground, const std::vector<std::size_t>& effects,
                               const Deviation& from, double none) {
    std::optional<Candidate> best;
    const std::vector<Eigen::Index> knobs = knobsOf(study, effects);
    for (const Deviation& start : starts(study, knobs, handedOver(study, knobs, from))) {
        // A second start is for knobs that did not get off their limit.
        if (best && (best->fit.at(knobs) - from(knobs)).cwiseAbs().minCoeff() > kStuck) break;
        std::optional<Fit> fit = fitted(study.bench, study.uncertainty, ground, knobs, start);
        if (!fit || (best && fit->log_evidence <= best->fit.log_evidence)) continue;
        best = Candidate{effects, fit->log_evidence - none, std::move(*fit), true};
    }
    return best;
}

// Nuisances linearised about a fit; the knobs keep their columns.
Ground groundAt(Study& study, const Fit& fit, const std::function<void(double)>& progress) {
    return ground(nuisancesAt(study, fit.at, progress), study.calibrated.nuisances, study.uncertainty);
}

// The fit again, nuisances linearised where it is, until it stays. Gives them as linearised last.
Ground settle(Study& study, Candidate& candidate, double none) {
    Ground here;
    for (int round = 0; round < kMostRounds; ++round) {
        here = groundAt(study, candidate.fit, [](double) {});
        std::optional<Candidate> again = refit(study, here, candidate.effects, candidate.fit.at, none);
        if (!again) break;
        candidate = std::move(*again);
        if (candidate.fit.gained < kSettled) break;
    }
    return here;
}

bool contains(const std::vector<std::size_t>& list, std::size_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

bool tried(const std::vector<Candidate>& candidates, std::vector<std::size_t> effects) {
    std::sort(effects.begin(), effects.end());
    return std::any_of(candidates.begin(), candidates.end(), [&](Candidate one) {
        std::sort(one.effects.begin(), one.effects.end());
        return one.effects == effects;
    });
}

// Adds effects to a candidate as long as they gain enough, each about the point where those before it are.
void grow(Study& study, Ground ground, Candidate from, double none, std::vector<Candidate>& found) {
    while (from.effects.size() < kMostEffects) {
        const std::vector<double> gains = gainsOver(study, ground, from.fit);
        const double enough =
            kThresholds.further_effect + kThresholds.doubt(2, from.log_evidence, study.bench.compared());
        std::optional<Candidate> best;
        std::size_t refits = 0;
        for (const std::size_t e : bestFirst(gains)) {
            if (contains(from.effects, e)) continue;
            if (gains[e] < 0.5 * enough || refits++ == kFurtherRefits) break;
            std::vector<std::size_t> effects = from.effects;
            effects.push_back(e);
            if (tried(found, effects)) continue;
            std::optional<Candidate> more = refit(study, ground, effects, from.fit.at, none);
            if (!more) continue;
            found.push_back(*more);
            if (!best || more->log_evidence > best->log_evidence) best = more;
        }
        if (!best || best->log_evidence < from.log_evidence + enough) return;
        from = std::move(*best);
        if (from.effects.size() == kMostEffects) return;
        ground = settle(study, from, none);
        std::erase_if(found, [&](const Candidate& one) { return one.effects == from.effects; });
        found.push_back(from);
    }
}

// What the best three effects are without one of them: the first may have been found for what two others do together.
void prune(Study& study, double none, std::vector<Candidate>& found) {
    sort(found);
    if (found.empty() || found.front().effects.size() < kMostEffects) return;
    const Candidate from = found.front();
    for (const std::size_t out : from.effects) {
        std::vector<std::size_t> effects = from.effects;
        std::erase(effects, out);
        if (tried(found, effects)) continue;
        Deviation at = from.fit.at;
        for (const Eigen::Index k : study.knobs[out]) at(k) = 0;
        std::optional<Candidate> less = refit(study, study.calibrated, effects, at, none);
        if (!less) continue;
        if (less->log_evidence > from.log_evidence - kHopeless) settle(study, *less, none);
        found.push_back(std::move(*less));
    }
}

}  // namespace

const Candidate& Search::none() const {
    return *std::find_if(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.effects.empty(); });
}

Search search(Study& study, const Screen& screen, const Progress& progress) {
    const Deviation& origin = study.calibration.at;
    std::optional<Fit> none = study.calibration;
    double zero = none->log_evidence;

    // Every effect as the linearisation sees it, the most promising refitted.
    Search result;
    std::vector<Candidate> singles;
    const std::vector<std::size_t> order = bestFirst(screen.gain);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t e = order[i];
        const bool hopeless = screen.gain[e] < screen.gain[order.front()] - kHopeless || screen.gain[e] < -1;
        std::optional<Candidate> one;
        if (i < kFewestRefits || (i < kMostRefits && !hopeless))
            one = refit(study, study.calibrated, {e}, origin, zero);
        progress(0.3 * static_cast<double>(std::min(i, kMostRefits)) / kMostRefits, "fitting " + study.effects[e].name);
        if (!one) one = Candidate{{e}, screen.gain[e], {}, false};
        singles.push_back(std::move(*one));
    }
    sort(singles);

    // The best again, nuisances linearised where they are; then what could be beside them.
    std::vector<Candidate> grown;
    for (std::size_t i = 0; i < singles.size() && i < kRelinearised; ++i) {
        if (!singles[i].fitted) break;
        if (singles[i].log_evidence < kThresholds.effect - kUncertain) break;
        if (i > 0 && singles[i].log_evidence < singles[0].log_evidence - kBehind) break;
        progress(0.3 + 0.3 * static_cast<double>(i), "linearising at " + study.effects[singles[i].effects[0]].name);
        Ground here = settle(study, singles[i], zero);
        if (i == 0) {
            std::optional<Fit> again = fitted(study.bench, study.uncertainty, here, {}, none->at);
            if (again && again->log_evidence > none->log_evidence) none = std::move(again);
            zero = none->log_evidence;
            singles[i].log_evidence = singles[i].fit.log_evidence - zero;
        }
        if (singles[i].log_evidence > kThresholds.effect) grow(study, std::move(here), singles[i], zero, grown);
    }
    prune(study, zero, grown);
    result.candidates = std::move(singles);
    result.candidates.insert(result.candidates.end(), grown.begin(), grown.end());
    result.candidates.push_back({{}, 0, std::move(*none), true});
    for (Candidate& one : result.candidates) {
        if (one.fitted) one.log_evidence = one.fit.log_evidence - zero;
    }
    sort(result.candidates);
    return result;
}

}  // namespace tread
