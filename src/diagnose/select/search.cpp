#include "diagnose/select/search.h"

#include <algorithm>
#include <numeric>

#include "diagnose/select/doubt.h"
#include "diagnose/select/force_law.h"
#include "diagnose/select/posterior.h"
#include "diagnose/select/sets.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr std::size_t kFewestFitted = 4, kMostFitted = 8;  // effects of the screen that are fitted: at least, at most
// Nats behind the best of the screen, and share of its promise; effects that have neither are fitted only if among the
// first kFewestFitted.
constexpr double kHopeless = 25, kLeastShare = 1.0 / 3;
constexpr double kUncertain = 3;        // nats that a new linearisation may add to a single below the threshold
constexpr int kMostRivalRounds = 2;     // best singles about which rivals are fitted
constexpr std::size_t kMostRivals = 4;  // fitted about the best candidate
constexpr double kFarBehind = 50;       // nats behind the best candidate that may be due to the point of the fit
constexpr int kMostSetRounds = 4;       // best sets about which others are compared
constexpr std::size_t kSetsFitted = 4;  // about each of these
constexpr double kClose = 3;            // nats behind the best set up to which others are fitted: odds of 20 to 1

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

std::size_t numbersMoved(const Problem& problem, std::size_t effect) {
    std::size_t count = 0;
    for (const Eigen::Index knob : problem.knobs[effect]) count += problem.replays.parameters[knob].moves.size();
    return count;
}

// Whether two effects change all rows alike, to the bit: that of all sensors and that of one, where only one is read.
bool changeTheSame(const Calibration& car, std::size_t one, std::size_t other) {
    const std::vector<Eigen::Index>&knobs = car.problem.knobs[one], &others = car.problem.knobs[other];
    if (knobs.size() != others.size()) return false;
    bool any = false;
    for (const Eigen::MatrixXd& columns : car.about.about.columns) {
        const Eigen::MatrixXd changes = columns(Eigen::all, knobs);
        if (changes != columns(Eigen::all, others)) return false;
        any |= !changes.isZero(0);
    }
    return any;
}

// Effects that do in these drives only what one does that moves fewer numbers: they are another name of it.
std::vector<bool> otherNames(const Calibration& car) {
    std::vector<bool> names(car.problem.effects.size());
    for (std::size_t e = 0; e < names.size(); ++e) {
        for (std::size_t of = 0; of < names.size() && !names[e]; ++of)
            names[e] = numbersMoved(car.problem, of) < numbersMoved(car.problem, e) && changeTheSame(car, of, e);
    }
    return names;
}

// State of the search.
class Searcher {
public:
    Searcher(const Calibration& car, const Progress& progress)
        : car_(car), problem_(car.problem), progress_(progress), other_name_(otherNames(car)), fitter_(car) {}

    Search run(const Screen& screen) {
        fitSingles(screen);
        fitSets(settleBest());
        takeApart();
        fitRivalsOfBest();
        found_.push_back({{}, 0, fitter_.none(), true});
        countUnknownForces();
        sort(found_);
        return {std::move(found_)};
    }

private:
    // One candidate per effect; the most promising of the screen are fitted, the others keep its evidence.
    void fitSingles(const Screen& screen) {
        const Effects order = bestFirst(screen.gain);
        std::vector<CandidateFitter::Promising> promising;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::size_t e = order[i];
            if (other_name_[e]) continue;
            const double best = screen.gain[order.front()];
            const bool hopeless =
                screen.gain[e] < std::min(best - kHopeless, kLeastShare * best) || screen.gain[e] < -1;
            found_.push_back({{e}, screen.least_gain[e], {}, false});
            if (i < kFewestFitted || (i < kMostFitted && !hopeless)) promising.push_back({e, screen.least_gain[e]});
        }
        fitTheseSingles(promising);
        fitPromising();
    }

    // The best one first: what it reaches tells which of the others can be given up.
    void fitTheseSingles(std::vector<CandidateFitter::Promising> promising) {
        if (promising.empty()) return;
        progress_(0, "fitting " + problem_.effects[promising.front().effect].name);
        keepBetter(fitter_.single(promising.front().effect, promising.front().promised));
        promising.erase(promising.begin());
        progress_(0.1, "fitting single effects");
        keepBetter(fitter_.singles(promising));
    }

    // Fits the best of the others as long as the linear model promises more of it than the best fit has.
    void fitPromising() {
        while (true) {
            sort(found_);
            const auto next = std::find_if(found_.begin(), found_.end(), [](const Candidate& c) { return !c.fitted; });
            const double best = found_.front().fitted ? found_.front().log_evidence : 0;
            if (next == found_.end() || next->log_evidence <= std::max(best, kSettings.effect)) return;
            std::optional<Candidate> one = fitter_.single(next->effects.front(), next->log_evidence);
            if (one) *next = std::move(*one);
            else found_.erase(next);  // the car cannot be driven with this effect
        }
    }

    // Settles the best single and fits its rivals about it. Where one of them is then the best, about that one in turn.
    // Returns the linearisation about the best; nothing when it was not settled.
    SharedLinearisation settleBest() {
        for (int round = 0; round < kMostRivalRounds && !found_.empty(); ++round) {
            Candidate best = found_.front();
            if (!worthSettling(best)) break;
            progress_(0.3, "linearising at " + problem_.effects[best.effects.front()].name);
            const SharedLinearisation here = fitter_.settle(best);
            const double before = fitter_.none().log_evidence;
            if (fitter_.refitNone(*here, best)) {
                for (Candidate& one : found_)
                    one.log_evidence =
                        one.fitted ? fitter_.over(one.fit) : one.log_evidence - (fitter_.none().log_evidence - before);
                best.log_evidence = fitter_.over(best.fit);
                // What is possible without the effect is possible with it.
                std::optional<Candidate> again = fitter_.fit(*here, best.effects, endOf(fitter_.none()));
                if (again && again->log_evidence > best.log_evidence) best = std::move(*again);
            }
            keepBetter(best);
            fitRivals(best, *here, anew(best.fit));
            sort(found_);
            if (found_.front().of(best.effects)) return here;
        }
        return nullptr;
    }

    bool worthSettling(const Candidate& single) const {
        return single.fitted && single.log_evidence >= kSettings.effect - kUncertain;
    }

    // Fits sets of effects about the most probable one, and goes on about the best of these, until none is better.
    // `here`: linearised about the best single; nothing where that was not settled.
    void fitSets(SharedLinearisation here) {
        for (int round = 0; round < kMostSetRounds && !found_.empty(); ++round) {
            Candidate best = mostProbable();
            if (!worthSettling(best)) return;
            progress_(0.4 + 0.1 * round, "comparing sets of effects");
            if (!here) here = fitter_.settle(best), keepBetter(best);
            if (!fitSetsAbout(best, *here)) return;
            here.reset();
        }
    }

    // Fits the sets that the linear model about a candidate finds about as probable. Tells whether one is better.
    bool fitSetsAbout(const Candidate& best, const Linearisation& here) {
        const model::ChannelSquares squares(car_.drives(), car_.uncertainty, best.fit.sizes);
        const double close = kClose * doubt(car_, squares, best.fit, fitter_.none().rows);
        bool better = false;
        std::vector<Attempt> attempts;
        for (const PromisingSet& set : promisingSets(car_, here, best, sought())) {
            if (set.promised < -close || attempts.size() == kSetsFitted) break;
            if (isFitted(set.effects) || hardlyGains(set, best)) continue;
            attempts.push_back({set.effects, endOf(best.fit)});
            attempts.back().from.at = problem_.withOnly(set.effects, best.fit.at);
        }
        for (std::optional<Candidate>& one : fitter_.fits(here, attempts)) {
            if (!one) continue;
            better |= logProbability(*one) > logProbability(best);
            keepBetter(std::move(*one));
        }
        return better;
    }

    // Whether effects that a set has more than a candidate are unlikely to be named: each must gain so much. In a small
    // catalogue, their prior alone does not exclude them.
    bool hardlyGains(const PromisingSet& set, const Candidate& best) const {
        if (set.effects.size() <= best.effects.size()) return false;
        const auto more = static_cast<double>(set.effects.size() - best.effects.size());
        const double gain =
            set.promised + logPrior(problem_, best.effects.size()) - logPrior(problem_, set.effects.size());
        return gain < 0.5 * kSettings.effect * more;
    }

    double logProbability(const Candidate& one) const {
        return one.log_evidence + logPrior(problem_, one.effects.size());
    }

    Candidate mostProbable() const {
        return *std::max_element(found_.begin(), found_.end(), [&](const Candidate& a, const Candidate& b) {
            if (a.fitted != b.fitted) return b.fitted;
            return logProbability(a) < logProbability(b);
        });
    }

    // Effects that are not another name of one.
    Effects sought() const {
        Effects some;
        for (std::size_t e = 0; e < other_name_.size(); ++e)
            if (!other_name_[e]) some.push_back(e);
        return some;
    }

    // Fits the best set without each of its effects, from its point, then the best of these sets in the same way: the
    // first effect may have been found only because it imitates the others, and a fit that came from elsewhere may have
    // stopped at a lesser maximum.
    void takeApart() {
        sort(found_);
        const auto set = std::find_if(found_.begin(), found_.end(),
                                      [](const Candidate& one) { return one.fitted && one.effects.size() > 1; });
        if (set == found_.end()) return;
        Candidate from = *set;
        while (from.effects.size() > 1) {
            std::vector<Attempt> attempts;
            for (const std::size_t out : from.effects) {
                attempts.push_back({from.effects, without(out, from.fit)});
                std::erase(attempts.back().effects, out);
                attempts.back().settled = settledWith(attempts.back().effects);
            }
            std::optional<Candidate> best;
            for (std::optional<Candidate>& less :
                 fitter_.settledFits(*linearisationAbout(car_, from), attempts, from, kHopeless)) {
                if (!less) continue;
                keepBetter(*less);
                if (!best || less->log_evidence > best->log_evidence) best = std::move(less);
            }
            if (!best) return;
            from = std::move(*best);
        }
    }

    // Evidence of a set that has been settled, nats.
    double settledWith(const Effects& effects) const {
        const auto known = std::find_if(found_.begin(), found_.end(),
                                        [&](const Candidate& one) { return one.about && one.of(effects); });
        return known == found_.end() ? -kInfinity : known->log_evidence;
    }

    // The end of a fit, with an effect taken out.
    Start without(std::size_t effect, const Fit& fit) const {
        Start end = endOf(fit);
        end.at(problem_.knobs[effect]).setZero();
        return end;
    }

    void fitRivalsOfBest() {
        if (found_.empty()) return;
        const Candidate best = mostProbable();
        if (!best.fitted || best.log_evidence < kSettings.effect) return;
        fitRivals(best, *linearisationAbout(car_, best), endOf(best.fit));
    }

    // Whether a single effect can imitate one of a candidate: its fit may lag behind only because it went astray.
    bool canImitate(const Candidate& single, const Candidate& other) const {
        if (single.effects.size() != 1) return false;
        const std::vector<std::string>& alike = problem_.effects[single.effects.front()].alike;
        return std::any_of(other.effects.begin(), other.effects.end(), [&](std::size_t e) {
            return std::find(alike.begin(), alike.end(), problem_.effects[e].name) != alike.end();
        });
    }

    // Whether a single effect can imitate the best candidate, or one that is about as probable.
    bool canImitateOneNear(const Candidate& single, const Candidate& best) const {
        return std::any_of(found_.begin(), found_.end(), [&](const Candidate& near) {
            return near.fitted && logProbability(near) > logProbability(best) - kClose && canImitate(single, near);
        });
    }

    // Fits the rivals of a candidate again, about its point: fits that came from elsewhere may differ by more than
    // their effects do. Effects that can imitate it, or a rival as probable, are fitted even where the screen promises
    // little of them. `start`: of the candidate; the knobs of each rival take the place of its own.
    void fitRivals(const Candidate& best, const Linearisation& here, const Start& start) {
        std::vector<const Candidate*> rivals;
        for (const Candidate& one : found_)
            if (one.fitted && !one.of(best.effects) &&
                (logProbability(one) > logProbability(best) - kFarBehind || canImitate(one, best)))
                rivals.push_back(&one);
        std::stable_sort(rivals.begin(), rivals.end(), [&](const Candidate* a, const Candidate* b) {
            return logProbability(*a) > logProbability(*b);
        });
        if (rivals.size() > kMostRivals) rivals.resize(kMostRivals);
        for (const Candidate& one : found_)
            if (!one.fitted && canImitateOneNear(one, best)) rivals.push_back(&one);
        std::vector<Attempt> attempts;
        for (const Candidate* rival : rivals) {
            attempts.push_back({rival->effects, start});
            Deviation& at = attempts.back().from.at;
            at(best.fit.knobs).setZero();
            at(rival->fit.knobs) = rival->fit.at(rival->fit.knobs);
        }
        keepBetter(fitter_.fits(here, attempts));
    }

    // Beside each set a force of unknown cause may act (D35a). The last candidate is the model without effects. What
    // such a force gains beside those that were not fitted is not known, so they keep a lower bound.
    void countUnknownForces() {
        const ForceLaws laws(car_);
        for (Candidate& one : found_) {
            if (!one.fitted) continue;
            one.law = laws.best(one.fit);
            one.log_evidence += gainIfUnknown(one.law);
        }
        const double none = found_.back().log_evidence;
        for (Candidate& one : found_) one.log_evidence -= none;
    }

    bool isFitted(const Effects& effects) const {
        return std::any_of(found_.begin(), found_.end(),
                           [&](const Candidate& one) { return one.fitted && one.of(effects); });
    }

    // Puts a candidate in the place of another fit of the same effects, unless it is worse.
    void keepBetter(Candidate one) {
        const auto known =
            std::find_if(found_.begin(), found_.end(), [&](const Candidate& other) { return other.of(one.effects); });
        if (known == found_.end()) found_.push_back(std::move(one));
        else if (!known->fitted || one.log_evidence >= known->log_evidence) *known = std::move(one);
    }

    void keepBetter(std::optional<Candidate> one) {
        if (one) keepBetter(std::move(*one));
    }

    void keepBetter(std::vector<std::optional<Candidate>> some) {
        for (std::optional<Candidate>& one : some) keepBetter(std::move(one));
    }

    const Calibration& car_;
    const Problem& problem_;
    const Progress& progress_;
    const std::vector<bool> other_name_;  // of another effect, which is sought in its place
    CandidateFitter fitter_;
    std::vector<Candidate> found_;
};

}  // namespace

const Candidate& Search::none() const {
    return *std::find_if(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.effects.empty(); });
}

Search search(const Calibration& car, const Screen& screen, const Progress& progress) {
    return Searcher(car, progress).run(screen);
}

bool fitScreened(const Calibration& car, Search& found, Candidate& screened) {
    std::optional<Candidate> one = CandidateFitter(car).single(screened.effects.front(), screened.log_evidence);
    if (!one) return false;
    const Candidate& none = found.none();
    one->law = ForceLaws(car).best(one->fit);
    one->log_evidence =
        one->fit.log_evidence + gainIfUnknown(one->law) - none.fit.log_evidence - gainIfUnknown(none.law);
    screened = std::move(*one);
    return true;
}

}  // namespace tread::diagnose::select
