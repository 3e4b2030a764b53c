#include "diagnose/select/candidate.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/threads/parallel.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr int kMostRenewals = 3;       // renewals of the linearisation about one candidate
constexpr double kRenewalSettled = 8;  // nats; the linearisation is not renewed after a fit that gained less
constexpr double kStuck = 0.02;        // units; a knob that moved less counts as stuck at its limit
constexpr double kOutOfReach = 100;    // nats behind the best fit, from which a fit has no chance
constexpr double kFar = 3;             // standard deviations of its tolerance by which a number hardly moves by itself
constexpr double kFarShort = 25;       // nats by which a fit may fall short of what the screen promised
constexpr std::size_t kMovedAtOnce = 3;  // knobs moved for points around a car

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

// Moves to these knobs what the nuisances did in their place: the same car at a larger prior density (D17).
Deviation handedOver(const Calibration& car, const std::vector<Eigen::Index>& knobs, Deviation at) {
    for (const Eigen::Index k : knobs) {
        if (at(k) != 0) continue;
        const Parameter& knob = car.problem.replays.parameters[k];
        double both = 0, squares = 1;
        const std::vector<model::Share> shares = car.asNuisances(knob);
        for (const model::Share& share : shares) {
            both += share.units * at(share.of);
            squares += share.units * share.units;
        }
        at(k) = std::clamp(both / squares, knob.lowest, knob.highest);
        for (const model::Share& share : shares) at(share.of) -= at(k) * share.units;
    }
    return at;
}

// Squares that each of some models leaves beside the remainder of the calibrated car; infinite where a car cannot be
// driven.
std::vector<double> squaresOf(const Calibration& car, const std::vector<std::optional<Rows>>& models) {
    const Uncertainty& uncertainty = car.uncertainty;
    Eigen::MatrixXd left = Eigen::MatrixXd::Zero(std::ssize(models), std::ssize(car.drives()));
    inParallel(car.drives().size(), car.problem.replays.threads, [&](std::size_t d) {
        const inference::Metric metric =
            inference::metricOf(uncertainty.bare[d].disturbances, uncertainty.sizesOf(d, car.fit.sizes));
        for (std::size_t i = 0; i < models.size(); ++i) {
            if (!models[i]) continue;
            const Eigen::VectorXd off = model::residual(car.drives(), uncertainty, *models[i], d);
            left(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(d)) =
                inference::squaresIn(metric, off, uncertainty.directions[d].transpose() * off);
        }
    });
    std::vector<double> squares;
    for (std::size_t i = 0; i < models.size(); ++i)
        squares.push_back(models[i] ? left.row(static_cast<Eigen::Index>(i)).sum() : kInfinity);
    return squares;
}

// A car with these knobs at so many times their typical sizes, within bounds. Bit i of `sides`: knob i is negative.
Deviation withKnobsAt(const Calibration& car, Deviation at, std::span<const Eigen::Index> knobs, double size,
                      std::size_t sides) {
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        const Parameter& knob = car.problem.replays.parameters[knobs[i]];
        at(knobs[i]) = std::clamp((sides >> i & 1) != 0 ? -size : size, knob.lowest, knob.highest);
    }
    return at;
}

// Of the points around a car, with the first knobs of an effect at once or twice their typical sizes, to all sides, the
// one that leaves the smallest squares; nothing when none can be driven.
std::optional<Deviation> pointAround(const Calibration& car, const Deviation& middle, std::size_t effect) {
    const std::span<const Eigen::Index> all = car.problem.knobs[effect];
    const std::span<const Eigen::Index> knobs = all.first(std::min(all.size(), kMovedAtOnce));
    std::vector<Deviation> points;
    for (const double size : {1.0, 2.0})
        for (std::size_t sides = 0; sides < (std::size_t{1} << knobs.size()); ++sides)
            points.push_back(withKnobsAt(car, middle, knobs, size, sides));
    const std::vector<double> left = squaresOf(car, model::rowsAt(car.problem.replays, car.drives(), points));
    const auto least = std::min_element(left.begin(), left.end());
    if (*least == kInfinity) return std::nullopt;
    return points[least - left.begin()];
}

// A load has a moment and hardly a mass: beyond the mass whose moment would lie outside the car the evidence falls, and
// rises again towards the mass that has the inertia, too.
bool othersMovedFurther(const Candidate& single) {
    if (single.log_evidence < kSettings.effect) return false;
    const Eigen::VectorXd moved = single.fit.at(single.fit.knobs).cwiseAbs();
    return moved(0) < moved.maxCoeff();
}

// Whether numbers, disturbances or errors stand for an effect: they are so far from what is usual that a fit from the
// calibrated car may end where they do its work.
bool standsForAnEffect(const Calibration& car) {
    const bool remainder = std::any_of(
        model::kAllDisturbed.begin(), model::kAllDisturbed.end(),
        [&](model::Disturbed kind) { return model::kWidePrior.deviations(kind, car.fit.sizes[placeOf(kind)]) > kFar; });
    return remainder || (car.fit.at(car.problem.nuisances).array().abs() > kFar).any();
}

// Where an effect was fitted to keep car and model together; null when it was not.
const Deviation* triedAt(const Calibration& car, std::size_t effect) {
    if (!car.together) return nullptr;
    const auto found = car.together->tried.find(effect);
    return found == car.together->tried.end() ? nullptr : &found->second;
}

void keepBetter(std::optional<Candidate>& best, std::optional<Candidate> other) {
    if (other && (!best || other->log_evidence > best->log_evidence)) best = std::move(other);
}

}  // namespace

bool Candidate::of(const std::vector<std::size_t>& others) const {
    return std::is_permutation(effects.begin(), effects.end(), others.begin(), others.end());
}

bool Candidate::holds(std::size_t effect) const {
    return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

bool Candidate::lacksOneOf(const Candidate& set) const {
    return effects.size() + 1 == set.effects.size() &&
           std::all_of(effects.begin(), effects.end(), [&](std::size_t effect) { return set.holds(effect); });
}

SharedLinearisation linearisationAbout(const Calibration& car, const Candidate& candidate) {
    return candidate.about ? candidate.about : linearisedAt(car, candidate.fit);
}

CandidateFitter::CandidateFitter(const Calibration& car) : car_(car), none_(car.fit), best_(car.fit.log_evidence) {}

bool CandidateFitter::refitNone(const Linearisation& about, const Candidate& beside) {
    Start from_beside = endOf(beside.fit);
    from_beside.at = car_.problem.withOnly({}, beside.fit.at);
    bool better = false;
    for (const Start& from : {Start{none_.at}, from_beside}) {
        std::optional<Fit> again = fitted(car_.problem.replays, car_.drives(), car_.uncertainty, about, {}, from);
        if (!again || again->log_evidence <= none_.log_evidence) continue;
        none_ = std::move(*again);
        better = true;
    }
    best_ = std::max(best_, none_.log_evidence);
    return better;
}

std::vector<CandidateFitter::Found> CandidateFitter::together(
    std::size_t count, const std::function<Found(double&, std::size_t)>& fit_one) {
    std::vector<Found> found(count);
    std::vector<double> best(count, best_);
    inParallel(count, car_.problem.replays.threads, [&](std::size_t i) { found[i] = fit_one(best[i], i); });
    for (const double one : best) best_ = std::max(best_, one);
    return found;
}

std::vector<CandidateFitter::Found> CandidateFitter::singles(const std::vector<Promising>& some) {
    return together(some.size(), [&](double& best, std::size_t i) { return singleBeside(best, some[i]); });
}

std::vector<CandidateFitter::Found> CandidateFitter::fits(const Linearisation& about,
                                                          const std::vector<Attempt>& attempts) {
    return together(attempts.size(), [&](double& best, std::size_t i) { return fitBeside(best, about, attempts[i]); });
}

CandidateFitter::Found CandidateFitter::fit(const Linearisation& about, const std::vector<std::size_t>& effects,
                                            const Start& from) {
    return fitBeside(best_, about, {effects, from});
}

SharedLinearisation CandidateFitter::settle(Candidate& candidate) {
    return settleBeside(best_, candidate);
}

std::vector<CandidateFitter::Found> CandidateFitter::settledFits(const Linearisation& about,
                                                                 const std::vector<Attempt>& attempts,
                                                                 const Candidate& than, double far_behind) {
    return together(attempts.size(), [&](double& best, std::size_t i) {
        Found one = fitBeside(best, about, attempts[i]);
        if (one && one->log_evidence > std::max(than.log_evidence - far_behind, attempts[i].settled))
            settleBeside(best, *one);
        return one;
    });
}

CandidateFitter::Found CandidateFitter::singleBeside(double& best_so_far, const Promising& one) const {
    const auto fitFrom = [&](const Deviation& at) { return fitBeside(best_so_far, car_.about, {{one.effect}, {at}}); };
    Found best = fitFrom(car_.fit.at);
    if (const Deviation* tried = triedAt(car_, one.effect)) keepBetter(best, fitFrom(*tried));
    const auto fitAround = [&](const Deviation& middle) {
        if (const std::optional<Deviation> from = pointAround(car_, middle, one.effect))
            keepBetter(best, fitFrom(*from));
    };
    const bool astray = !best || best->log_evidence <= one.promised - kFarShort || othersMovedFurther(*best);
    if (astray) fitAround(car_.fit.at);
    if (astray || standsForAnEffect(car_)) fitAround(car_.problem.replays.origin());
    return best;
}

CandidateFitter::Found CandidateFitter::fitBeside(double& best_so_far, const Linearisation& about,
                                                  const Attempt& attempt) const {
    Found best;
    const Start& from = attempt.from;
    const std::vector<Eigen::Index> knobs = car_.problem.knobsOf(attempt.effects);
    for (Deviation& at : starts(car_.problem, knobs, handedOver(car_, knobs, from.at))) {
        // The second start is needed only when a knob did not leave its limit.
        if (best && (best->fit.at(knobs) - from.at(knobs)).cwiseAbs().minCoeff() > kStuck) break;
        std::optional<Fit> found =
            fitted(car_.problem.replays, car_.drives(), car_.uncertainty, about, knobs,
                   {std::move(at), from.sizes, from.imperfection, from.is_end, best_so_far - kOutOfReach});
        if (found) best_so_far = std::max(best_so_far, found->log_evidence);
        if (found) keepBetter(best, Candidate{attempt.effects, over(*found), std::move(*found), true});
    }
    return best;
}

SharedLinearisation CandidateFitter::settleBeside(double& best_so_far, Candidate& candidate) const {
    SharedLinearisation here;
    for (int round = 0; round < kMostRenewals; ++round) {
        here = linearisedAt(car_, candidate.fit);
        Found again = fitBeside(best_so_far, *here, {candidate.effects, endOf(candidate.fit)});
        if (!again) break;
        const double gained = again->log_evidence - candidate.log_evidence;
        if (gained > 0) candidate = std::move(*again);
        if (gained < kRenewalSettled) break;
    }
    Found other = fitBeside(best_so_far, *here, {candidate.effects, anew(candidate.fit)});
    if (other && other->log_evidence > candidate.log_evidence + kRenewalSettled) {
        candidate = std::move(*other);
        here = linearisedAt(car_, candidate.fit);
    }
    candidate.about = here;
    return here;
}

}  // namespace tread::diagnose::select
