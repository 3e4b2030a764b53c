#include "diagnose/select/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "diagnose/select/doubt.h"
#include "diagnose/select/force_law.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr std::size_t kFewestRefits = 4, kMostRefits = 8;  // effects of the screen that are fitted: at least, at most
// Nats behind the best of the screen; effects further behind are fitted only if among the first kFewestRefits.
constexpr double kHopeless = 25;
constexpr double kUncertain = 3;           // nats that a new linearisation may add to a single below the threshold
constexpr double kBehind = 15;             // nats behind the best single, too many for a new linearisation to make up
constexpr int kMostRounds = 3;             // renewals of the linearisation about one candidate
constexpr double kSettled = 8;             // nats; the linearisation is not renewed after a fit that gained less
constexpr std::size_t kRelinearised = 2;   // best singles about which the nuisances are linearised again
constexpr std::size_t kFurtherRefits = 3;  // effects tried beside each of these
constexpr std::size_t kMostEffects = 3;    // of a set: the prior gives larger sets no probability
constexpr std::array kTrialSizes{-3.0, -2.0, -1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0, 3.0};  // typical sizes
constexpr double kAlike = 0.7;  // cosine from which an effect is started from the best one's fit
constexpr std::size_t kMovedAtOnce = 3, kPointsAround = 2;  // knobs moved for points around the car; points kept
constexpr double kStuck = 0.02;  // units; a knob that moved less counts as stuck at its limit

using Effects = std::vector<std::size_t>;

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

bool sameEffects(const Candidate& one, const Effects& effects) {
    return std::is_permutation(one.effects.begin(), one.effects.end(), effects.begin(), effects.end());
}

bool tried(const std::vector<Candidate>& candidates, const Effects& effects) {
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](const Candidate& one) { return sameEffects(one, effects); });
}

// Start points for a fit of these knobs: the given point and, if a knob at 0 is bounded to one side, a second one with
// that knob at its typical size. At a limit the sensitivity may be 0 although the effect is not.
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

// State of the search.
class Searcher {
public:
    Searcher(const Calibration& car, const Progress& progress)
        : car_(car), problem_(car.problem), progress_(progress), none_(car.fit) {}

    Search run(const Screen& screen) {
        std::vector<Candidate> singles = refittedSingles(screen);
        startFromTheBest(singles, screen);
        std::vector<Candidate> grown = growFrom(singles);
        prune(singles, grown);
        Search result;
        result.candidates = std::move(singles);
        result.candidates.insert(result.candidates.end(), grown.begin(), grown.end());
        result.candidates.push_back({{}, 0, none_, true});
        countUnknownForces(result.candidates);
        sort(result.candidates);
        return result;
    }

private:
    // Beside each set a force of unknown cause may act (D35a). The last candidate is the model without effects.
    void countUnknownForces(std::vector<Candidate>& candidates) const {
        const ForceLaws laws(car_);
        for (Candidate& one : candidates) {
            if (!one.fitted) continue;
            one.law = laws.best(one.fit);
            one.log_evidence = one.fit.log_evidence + gainIfUnknown(one.law);
        }
        const double none = candidates.back().log_evidence;
        for (Candidate& one : candidates)
            if (one.fitted) one.log_evidence -= none;
    }

    // One candidate per effect; the most promising of the screen are fitted, the others keep the evidence of the
    // screen.
    std::vector<Candidate> refittedSingles(const Screen& screen) const {
        std::vector<Candidate> singles;
        const Effects order = bestFirst(screen.gain);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::size_t e = order[i];
            const bool hopeless = screen.gain[e] < screen.gain[order.front()] - kHopeless || screen.gain[e] < -1;
            std::optional<Candidate> one;
            if (i < kFewestRefits || (i < kMostRefits && !hopeless)) one = refitSingle(e, screen.least_gain[e]);
            progress_(0.3 * static_cast<double>(std::min(i, kMostRefits)) / kMostRefits,
                      "fitting " + problem_.effects[e].name);
            if (!one) one = Candidate{{e}, screen.least_gain[e], {}, false};
            singles.push_back(std::move(*one));
        }
        fitPromising(singles);
        return singles;
    }

    // Fits one effect. Where the fit falls far short of what the linear model promised, or where others of its knobs
    // moved further than the first, it may have gone astray: it is then started again from points around the
    // nominal car.
    std::optional<Candidate> refitSingle(std::size_t effect, double promised) const {
        std::optional<Candidate> best = refit(car_.about, {effect}, car_.fit.at);
        if (const Deviation* tried = triedAt(effect)) {
            std::optional<Candidate> again = refit(car_.about, {effect}, *tried);
            if (again && (!best || again->log_evidence > best->log_evidence)) best = std::move(again);
        }
        if (best && best->log_evidence > promised - kHopeless && !othersMovedFurther(*best)) return best;
        for (const Deviation& from : pointsAround(effect)) {
            std::optional<Candidate> again = refit(car_.about, {effect}, from);
            if (again && (!best || again->log_evidence > best->log_evidence)) best = std::move(again);
        }
        return best;
    }

    // Of the points with the first knobs of an effect at once or twice their typical sizes, to all sides, those that
    // leave the smallest squares.
    std::vector<Deviation> pointsAround(std::size_t effect) const {
        const std::vector<Eigen::Index>& knobs = problem_.knobs[effect];
        const std::size_t moved = std::min(knobs.size(), kMovedAtOnce);
        std::vector<std::pair<double, Deviation>> points;
        for (const double size : {1.0, 2.0}) {
            for (std::size_t sides = 0; sides < (std::size_t{1} << moved); ++sides) {
                Deviation at = car_.fit.at;
                for (std::size_t i = 0; i < moved; ++i) {
                    const Parameter& knob = problem_.replays.parameters[knobs[i]];
                    at(knobs[i]) = std::clamp((sides >> i & 1) != 0 ? -size : size, knob.lowest, knob.highest);
                }
                if (const std::optional<double> left = squaresAt(at, car_.fit.sizes)) points.emplace_back(*left, at);
            }
        }
        std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Deviation> best;
        for (std::size_t i = 0; i < std::min(points.size(), kPointsAround); ++i) best.push_back(points[i].second);
        return best;
    }

    // A load has a moment and hardly a mass: beyond the mass whose moment would lie outside the car the evidence falls,
    // and rises again towards the mass that has the inertia, too.
    static bool othersMovedFurther(const Candidate& one) {
        if (one.effects.size() != 1 || one.log_evidence < kSettings.effect) return false;
        const Eigen::VectorXd moved = one.fit.at(one.fit.knobs).cwiseAbs();
        return moved(0) < moved.maxCoeff();
    }

    // Fits effects that look like the best one again, from its point: its knobs give way to theirs, at the size of
    // those tried that leaves least. Where the car differs much, a fit may stop at a lesser maximum of the evidence.
    void startFromTheBest(std::vector<Candidate>& singles, const Screen& screen) const {
        if (singles.empty() || !singles.front().fitted || singles.front().log_evidence < kSettings.effect) return;
        const Candidate best = singles.front();
        std::size_t refits = 0;
        for (std::size_t i = 1; i < singles.size() && refits < kFurtherRefits; ++i) {
            Candidate& one = singles[i];
            if (!one.fitted || cosine(problem_, screen.products, best.effects.front(), one.effects.front()) < kAlike)
                continue;
            ++refits;
            const std::optional<Deviation> from = inPlaceOf(best, one.effects.front());
            std::optional<Candidate> again = from ? refit(car_.about, one.effects, *from) : std::nullopt;
            if (again && again->log_evidence > one.log_evidence) one = std::move(*again);
        }
        sort(singles);
    }

    // The point of a fit with another effect in place of its own, at the size of those tried that leaves least.
    std::optional<Deviation> inPlaceOf(const Candidate& best, std::size_t effect) const {
        std::optional<Deviation> nearest;
        double least = kInfinity;
        for (const Eigen::Index knob : problem_.knobs[effect]) {
            Deviation at = best.fit.at;
            at(best.fit.knobs).setZero();
            const auto tried = leastAt(at, knob, best.fit.sizes);
            if (!tried || tried->second >= least) continue;
            at(knob) = tried->first, least = tried->second, nearest = std::move(at);
        }
        return nearest;
    }

    // The size of a knob, of those tried, that leaves the smallest squares at a point, and these squares.
    std::optional<std::pair<double, double>> leastAt(Deviation at, Eigen::Index knob, const Sizes& sizes) const {
        const Parameter& parameter = problem_.replays.parameters[knob];
        std::optional<std::pair<double, double>> best;
        for (const double size : kTrialSizes) {
            at(knob) = std::clamp(size, parameter.lowest, parameter.highest);
            const std::optional<double> left = squaresAt(at, sizes);
            if (left && (!best || *left < best->second)) best = {at(knob), *left};
        }
        return best;
    }

    // Squares that a point leaves; nothing when the car cannot be driven there.
    std::optional<double> squaresAt(const Deviation& at, const Sizes& sizes) const {
        const std::optional<Rows> rows = model::rowsAt(problem_.replays, problem_.drives, at);
        if (!rows) return std::nullopt;
        double left = 0;
        for (std::size_t d = 0; d < rows->size(); ++d)
            left += model::squaresOf(car_.uncertainty, d, model::residual(problem_.drives, car_.uncertainty, *rows, d),
                                     sizes);
        return left;
    }

    // Where an effect was fitted to keep car and model together; null when it was not.
    const Deviation* triedAt(std::size_t effect) const {
        if (!car_.together) return nullptr;
        const auto found = car_.together->tried.find(effect);
        return found == car_.together->tried.end() ? nullptr : &found->second;
    }

    // Fits the best of the others as long as the linear model promises more of it than the best fit has.
    void fitPromising(std::vector<Candidate>& singles) const {
        while (true) {
            sort(singles);
            const auto next =
                std::find_if(singles.begin(), singles.end(), [](const Candidate& c) { return !c.fitted; });
            const double best = singles.front().fitted ? singles.front().log_evidence : 0;
            if (next == singles.end() || next->log_evidence <= std::max(best, kSettings.effect)) return;
            std::optional<Candidate> one = refitSingle(next->effects.front(), next->log_evidence);
            if (one) *next = std::move(*one);
            else singles.erase(next);  // the car cannot be driven with this effect
        }
    }

    // Fits the best singles again with the nuisances linearised at each, then adds effects to them.
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

    // Fits the model without effects with the linearisation about the best effect, and keeps the result if it is
    // better.
    void refitNone(const Linearisation& about) {
        std::optional<Fit> again = fitted(problem_.replays, problem_.drives, car_.uncertainty, about, {}, none_.at);
        if (again && again->log_evidence > none_.log_evidence) none_ = std::move(*again);
    }

    std::optional<Candidate> refit(const Linearisation& about, const Effects& effects, const Deviation& from) const {
        std::optional<Candidate> best;
        const std::vector<Eigen::Index> knobs = problem_.knobsOf(effects);
        for (const Deviation& start : starts(problem_, knobs, handedOver(knobs, from))) {
            // The second start is needed only when a knob did not leave its limit.
            if (best && (best->fit.at(knobs) - from(knobs)).cwiseAbs().minCoeff() > kStuck) break;
            std::optional<Fit> fit = fitted(problem_.replays, problem_.drives, car_.uncertainty, about, knobs, start);
            if (!fit || (best && fit->log_evidence <= best->fit.log_evidence)) continue;
            best = Candidate{effects, fit->log_evidence - none_.log_evidence, std::move(*fit), true};
        }
        return best;
    }

    // Moves to these knobs what the nuisances did in their place: the same car at a larger prior density (D17).
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

    // Fits a candidate repeatedly, each time with the nuisances linearised at its point, until it gains little. Returns
    // the last linearisation; the columns of the knobs stay those of the calibrated car.
    Linearisation settle(Candidate& candidate) const {
        Linearisation here;
        for (int round = 0; round < kMostRounds; ++round) {
            here = linearisedAt(car_, candidate.fit.at);
            std::optional<Candidate> again = refit(here, candidate.effects, candidate.fit.at);
            if (!again) break;
            candidate = std::move(*again);
            if (candidate.fit.gained < kSettled) break;
        }
        // The nuisances may hold what they did in place of the effects.
        std::optional<Candidate> anew = refit(here, candidate.effects, withoutNuisances(candidate.fit));
        if (anew && anew->log_evidence > candidate.log_evidence + kSettled) {
            candidate = std::move(*anew);
            here = linearisedAt(car_, candidate.fit.at);
        }
        return here;
    }

    // Adds effects to a candidate as long as each gains enough, linearised about the fit of those before.
    void grow(Linearisation about, Candidate from, std::vector<Candidate>& found) const {
        while (from.effects.size() < kMostEffects) {
            const double enough = kSettings.effect * doubt(car_, from.fit);
            std::optional<Candidate> best = bestBeside(from, about, enough, found);
            if (!best || best->log_evidence < from.log_evidence + enough) return;
            from = std::move(*best);
            if (from.effects.size() == kMostEffects) return;
            about = settle(from);
            std::erase_if(found, [&](const Candidate& one) { return one.effects == from.effects; });
            found.push_back(from);
        }
    }

    // The best fit with one more effect. The most promising effects are fitted, and all these fits are kept in `found`.
    std::optional<Candidate> bestBeside(const Candidate& from, const Linearisation& about, double enough,
                                        std::vector<Candidate>& found) const {
        const std::vector<double> gains = gainsOver(car_, about, from.fit, car_.uncertainty.sizes);
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

    // Fits the best set without each of its effects, from its point, then the best of these sets in the same way: the
    // first effect may have been found only because it imitates the others, and a fit that came from elsewhere may have
    // stopped at a lesser maximum.
    void prune(std::vector<Candidate>& singles, std::vector<Candidate>& grown) const {
        sort(grown);
        if (grown.empty()) return;
        Candidate from = grown.front();
        while (from.effects.size() > 1) {
            const Linearisation here = linearisedAt(car_, from.fit.at);
            std::optional<Candidate> best;
            for (const std::size_t out : from.effects) {
                Effects effects = from.effects;
                std::erase(effects, out);
                std::optional<Candidate> less = refit(here, effects, problem_.withOnly(effects, from.fit.at));
                if (!less) continue;
                if (less->log_evidence > from.log_evidence - kHopeless) settle(*less);
                if (!best || less->log_evidence > best->log_evidence) best = less;
                keepBetter(effects.size() == 1 ? singles : grown, std::move(*less));
            }
            if (!best) return;
            from = std::move(*best);
        }
    }

    // Puts a candidate in the place of another fit of the same effects, if it is better.
    static void keepBetter(std::vector<Candidate>& all, Candidate one) {
        const auto known = std::find_if(all.begin(), all.end(),
                                        [&](const Candidate& other) { return sameEffects(other, one.effects); });
        if (known == all.end()) all.push_back(std::move(one));
        else if (!known->fitted || one.log_evidence > known->log_evidence) *known = std::move(one);
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
