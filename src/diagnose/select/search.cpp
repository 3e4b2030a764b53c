#include "diagnose/select/search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/settings.h"

namespace tread::diagnose::select {
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

using Effects = std::vector<std::size_t>;

std::vector<Eigen::Index> knobsOf(const Problem& problem, const Effects& effects) {
    std::vector<Eigen::Index> knobs;
    for (const std::size_t e : effects) knobs.insert(knobs.end(), problem.knobs[e].begin(), problem.knobs[e].end());
    return knobs;
}

Effects bestFirst(const std::vector<double>& values) {
    Effects order(values.size());
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

bool contains(const Effects& list, std::size_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

bool tried(const std::vector<Candidate>& candidates, Effects effects) {
    std::sort(effects.begin(), effects.end());
    return std::any_of(candidates.begin(), candidates.end(), [&](Candidate one) {
        std::sort(one.effects.begin(), one.effects.end());
        return one.effects == effects;
    });
}

// Where fits of these knobs start: where the point has them, and, where a knob may only grow, also from well inside.
std::vector<Deviation> starts(const Problem& problem, const std::vector<Eigen::Index>& knobs, const Deviation& from) {
    std::vector<Deviation> points{from};
    Deviation inside = from;
    bool one_sided = false;
    for (const Eigen::Index k : knobs) {
        const Parameter& parameter = problem.replays.parameters[k];
        if (from(k) != 0 || (parameter.lowest < 0 && parameter.highest > 0)) continue;
        inside(k) = parameter.lowest == 0 ? std::min(1.0, parameter.highest) : std::max(-1.0, parameter.lowest);
        one_sided = true;
    }
    if (one_sided) points.push_back(inside);
    return points;
}

// The search while it goes on.
class Searcher {
public:
    Searcher(const Calibration& car, const Progress& progress)
        : car_(car), problem_(car.problem), progress_(progress), none_(car.fit) {}

    Search run(const Screen& screen) {
        std::vector<Candidate> singles = refittedSingles(screen);
        std::vector<Candidate> grown = growFrom(singles);
        prune(grown);
        Search result;
        result.candidates = std::move(singles);
        result.candidates.insert(result.candidates.end(), grown.begin(), grown.end());
        result.candidates.push_back({{}, 0, none_, true});
        for (Candidate& one : result.candidates) {
            if (one.fitted) one.log_evidence = one.fit.log_evidence - none_.log_evidence;
        }
        sort(result.candidates);
        return result;
    }

private:
    // Every effect as the linearisation sees it, the most promising refitted.
    std::vector<Candidate> refittedSingles(const Screen& screen) const {
        std::vector<Candidate> singles;
        const Effects order = bestFirst(screen.gain);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::size_t e = order[i];
            const bool hopeless = screen.gain[e] < screen.gain[order.front()] - kHopeless || screen.gain[e] < -1;
            std::optional<Candidate> one;
            if (i < kFewestRefits || (i < kMostRefits && !hopeless)) one = refit(car_.about, {e}, car_.fit.at);
            progress_(0.3 * static_cast<double>(std::min(i, kMostRefits)) / kMostRefits,
                      "fitting " + problem_.effects[e].name);
            if (!one) one = Candidate{{e}, screen.gain[e], {}, false};
            singles.push_back(std::move(*one));
        }
        sort(singles);
        return singles;
    }

    // The best singles again, nuisances linearised where they are; then what could be beside them.
    std::vector<Candidate> growFrom(std::vector<Candidate>& singles) {
        std::vector<Candidate> grown;
        for (std::size_t i = 0; i < singles.size() && i < kRelinearised; ++i) {
            Candidate& single = singles[i];
            if (!single.fitted || single.log_evidence < kSettings.effect - kUncertain) break;
            if (i > 0 && single.log_evidence < singles[0].log_evidence - kBehind) break;
            progress_(0.3 + 0.3 * static_cast<double>(i), "linearising at " + problem_.effects[single.effects[0]].name);
            const Linearisation here = settle(single);
            if (i == 0) {
                refitNone(here);
                single.log_evidence = single.fit.log_evidence - none_.log_evidence;
            }
            if (single.log_evidence > kSettings.effect) grow(here, single, grown);
        }
        return grown;
    }

    // The car without effects, from the linearisation about the best effect, where that finds a better fit.
    void refitNone(const Linearisation& about) {
        std::optional<Fit> again = fitted(problem_.replays, problem_.drives, car_.uncertainty, about, {}, none_.at);
        if (again && again->log_evidence > none_.log_evidence) none_ = std::move(*again);
    }

    std::optional<Candidate> refit(const Linearisation& about, const Effects& effects, const Deviation& from) const {
        std::optional<Candidate> best;
        const std::vector<Eigen::Index> knobs = knobsOf(problem_, effects);
        for (const Deviation& start : starts(problem_, knobs, handedOver(knobs, from))) {
            // A second start is for knobs that did not get off their limit.
            if (best && (best->fit.at(knobs) - from(knobs)).cwiseAbs().minCoeff() > kStuck) break;
            std::optional<Fit> fit = fitted(problem_.replays, problem_.drives, car_.uncertainty, about, knobs, start);
            if (!fit || (best && fit->log_evidence <= best->fit.log_evidence)) continue;
            best = Candidate{effects, fit->log_evidence - none_.log_evidence, std::move(*fit), true};
        }
        return best;
    }

    // What the nuisances did in place of these knobs is given to them: the same car, by the likelier way (D17).
    Deviation handedOver(const std::vector<Eigen::Index>& knobs, Deviation at) const {
        for (const Eigen::Index k : knobs) {
            if (at(k) != 0) continue;
            const Parameter& knob = problem_.replays.parameters[k];
            double both = 0, squares = 1;
            const std::vector<model::Share> shares = car_.asNuisances(knob);
            for (const model::Share& share : shares) {
                both += share.units * at(share.of);
                squares += share.units * share.units;
            }
            at(k) = std::clamp(both / squares, knob.lowest, knob.highest);
            for (const model::Share& share : shares) at(share.of) -= at(k) * share.units;
        }
        return at;
    }

    // The fit of a candidate again and again, each time with the nuisances linearised where it is, until it gains
    // little. Gives the last linearisation; the knobs keep the columns of the calibrated car.
    Linearisation settle(Candidate& candidate) const {
        Linearisation here;
        for (int round = 0; round < kMostRounds; ++round) {
            here = model::linearisation(model::nuisancesAt(problem_.replays, problem_.drives, candidate.fit.at,
                                                           car_.about, car_.uncertainty, [](double) {}),
                                        car_.about.nuisances, car_.uncertainty);
            std::optional<Candidate> again = refit(here, candidate.effects, candidate.fit.at);
            if (!again) break;
            candidate = std::move(*again);
            if (candidate.fit.gained < kSettled) break;
        }
        return here;
    }

    // Adds effects to a candidate as long as they gain enough, each about the point where those before it are.
    void grow(Linearisation about, Candidate from, std::vector<Candidate>& found) const {
        while (from.effects.size() < kMostEffects) {
            const double enough =
                kSettings.effect + kSettings.structureAllowance(2, from.log_evidence, problem_.compared());
            std::optional<Candidate> best = bestBeside(from, about, enough, found);
            if (!best || best->log_evidence < from.log_evidence + enough) return;
            from = std::move(*best);
            if (from.effects.size() == kMostEffects) return;
            about = settle(from);
            std::erase_if(found, [&](const Candidate& one) { return one.effects == from.effects; });
            found.push_back(from);
        }
    }

    // One more effect beside a candidate: the best of the most promising, all of which are kept.
    std::optional<Candidate> bestBeside(const Candidate& from, const Linearisation& about, double enough,
                                        std::vector<Candidate>& found) const {
        const std::vector<double> gains = gainsOver(car_, about, from.fit);
        std::optional<Candidate> best;
        std::size_t refits = 0;
        for (const std::size_t e : bestFirst(gains)) {
            if (contains(from.effects, e)) continue;
            if (gains[e] < 0.5 * enough || refits++ == kFurtherRefits) break;
            Effects effects = from.effects;
            effects.push_back(e);
            if (tried(found, effects)) continue;
            std::optional<Candidate> more = refit(about, effects, from.fit.at);
            if (!more) continue;
            found.push_back(*more);
            if (!best || more->log_evidence > best->log_evidence) best = more;
        }
        return best;
    }

    // The best three effects without one of them: the first may have been found for what the two others do together.
    void prune(std::vector<Candidate>& found) const {
        sort(found);
        if (found.empty() || found.front().effects.size() < kMostEffects) return;
        const Candidate from = found.front();
        for (const std::size_t out : from.effects) {
            Effects effects = from.effects;
            std::erase(effects, out);
            if (tried(found, effects)) continue;
            Deviation at = from.fit.at;
            for (const Eigen::Index k : problem_.knobs[out]) at(k) = 0;
            std::optional<Candidate> less = refit(car_.about, effects, at);
            if (!less) continue;
            if (less->log_evidence > from.log_evidence - kHopeless) settle(*less);
            found.push_back(std::move(*less));
        }
    }

    const Calibration& car_;
    const Problem& problem_;
    const Progress& progress_;
    Fit none_;
};

}  // namespace

const Candidate& Search::none() const {
    return *std::find_if(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.effects.empty(); });
}

Search search(const Calibration& car, const Screen& screen, const Progress& progress) {
    return Searcher(car, progress).run(screen);
}

}  // namespace tread::diagnose::select
