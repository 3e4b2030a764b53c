// Candidates for an answer, and how they are fitted.
#pragma once

#include <vector>

#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// A set of effects that may explain the recordings.
struct Candidate {
    std::vector<std::size_t> effects;  // indices of effects; empty: only nuisances
    double log_evidence = 0;           // nats over the model without effects
    Fit fit;                           // empty if not `fitted`; log_evidence is then that of the linear model
    bool fitted = false;
    answer::ForceLaw law = {.gain = -kInfinity};  // of a force of unknown cause beside the effects

    // Whether these are the effects, in any order.
    bool of(const std::vector<std::size_t>& others) const;
};

// Fits candidates about the calibrated car and about each other. Fits that will stay far behind the best one so far are
// given up.
class CandidateFitter {
public:
    explicit CandidateFitter(const Calibration& car);

    // The model without effects, and the evidence of a fit over it.
    const Fit& none() const { return none_; }
    double over(const Fit& fit) const { return fit.log_evidence - none_.log_evidence; }
    // Fits that model with another linearisation. The result is kept if it is better; tells whether it is.
    bool refitNone(const Linearisation& about);

    // One effect, about the calibrated car. The fit may have gone astray where it falls far short of what the linear
    // model promised, where others of its knobs moved further than the first, or where numbers of the calibrated car
    // moved far beyond their tolerances: it is then started again around that car, or around the nominal one.
    // Nothing when the car cannot be driven with the effect.
    std::optional<Candidate> single(std::size_t effect, double promised);

    // A set of effects, from this start. Nothing when the car cannot be driven there.
    std::optional<Candidate> fit(const Linearisation& about, const std::vector<std::size_t>& effects,
                                 const Start& from);

    // Fits a candidate repeatedly, each time with the nuisances linearised at its point, until it gains little, and
    // once more from nominal nuisances. Returns the linearisation about its point; the columns of the knobs stay those
    // of the calibrated car.
    Linearisation settle(Candidate& candidate);

private:
    const Calibration& car_;
    Fit none_;
    double best_;  // ln Z of the best fit so far
};

}  // namespace tread::diagnose::select
