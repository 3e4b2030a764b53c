// Candidates for an answer, and how they are fitted.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "diagnose/select/force_law.h"

namespace tread::diagnose::select {

// A set of effects that may explain the recordings.
struct Candidate {
    std::vector<std::size_t> effects;  // indices of effects; empty: only nuisances
    double log_evidence = 0;           // nats over the model without effects
    Fit fit;                           // empty if not `fitted`; log_evidence is then that of the linear model
    bool fitted = false;
    SharedLinearisation about = {};  // about its point; nothing if it was not settled
    FoundLaw law = {};               // of a force of unknown cause beside the effects

    // Whether these are the effects, in any order.
    bool of(const std::vector<std::size_t>& others) const;
    bool holds(std::size_t effect) const;
    bool lacksOneOf(const Candidate& set) const;  // whether it is that set without one of its effects
};

// The linearisation about a fitted candidate: its own, or computed where it has none.
SharedLinearisation linearisationAbout(const Calibration& car, const Candidate& candidate);

// A set of effects to be fitted, and where its fit starts.
struct Attempt {
    std::vector<std::size_t> effects;
    Start from;
    double settled = -kInfinity;  // evidence over none, nats, with which these effects have been settled before
};

// Fits candidates about the calibrated car and about each other. Fits that will stay far behind the best one so far are
// given up. Several at once do not know of each other, so that their results do not depend on which ends first.
class CandidateFitter {
public:
    using Found = std::optional<Candidate>;  // nothing when the car cannot be driven with the effects

    explicit CandidateFitter(const Calibration& car);

    // The model without effects, and the evidence of a fit over it.
    const Fit& none() const { return none_; }
    double over(const Fit& fit) const { return fit.log_evidence - none_.log_evidence; }
    // Fits that model with another linearisation, from its own point and from that of a candidate without its effects.
    // The better result is kept if it is better than the model so far; tells whether it is.
    bool refitNone(const Linearisation& about, const Candidate& beside);

    // Single effects, about the calibrated car. A fit may have gone astray where it falls far short of what the linear
    // model promised, where others of its knobs moved further than the first, or where numbers of the calibrated car
    // moved far beyond their tolerances: it is then started again around that car, or around the nominal one.
    struct Promising {
        std::size_t effect;
        double promised;
    };
    std::vector<Found> singles(const std::vector<Promising>& some);
    Found single(std::size_t effect, double promised) { return std::move(singles({{effect, promised}}).front()); }

    // Sets of effects, from these starts.
    std::vector<Found> fits(const Linearisation& about, const std::vector<Attempt>& attempts);
    Found fit(const Linearisation& about, const std::vector<std::size_t>& effects, const Start& from);

    // Fits a candidate repeatedly, each time with the nuisances linearised at its point, until it gains little, and
    // once more from nominal nuisances. Returns the linearisation about its point; the columns of the knobs stay those
    // of the calibrated car.
    SharedLinearisation settle(Candidate& candidate);

    // Sets of effects from these starts; those that do not stay this far behind `than` are settled, unless they are no
    // better than when they were settled before.
    std::vector<Found> settledFits(const Linearisation& about, const std::vector<Attempt>& attempts,
                                   const Candidate& than, double far_behind);

private:
    // Each of these knows the best ln Z so far, and raises it.
    Found singleBeside(double& best, const Promising& one) const;
    Found fitBeside(double& best, const Linearisation& about, const Attempt& attempt) const;
    SharedLinearisation settleBeside(double& best, Candidate& candidate) const;
    std::vector<Found> together(std::size_t count, const std::function<Found(double&, std::size_t)>& fit_one);

    const Calibration& car_;
    Fit none_;
    double best_;  // ln Z of the best fit so far
};

}  // namespace tread::diagnose::select
