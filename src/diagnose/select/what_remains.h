// What a model leaves: whether its remainder exceeds the disturbances and model errors of an ordinary drive, and which
// law it follows.
#pragma once

#include "diagnose/select/force_law.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::select {

struct Remains {
    // Nats by which the remainder as large as estimated is likelier than one of ordinary size (D33). These nats, those
    // of a law, and those of numbers are divided by the doubt about the signatures of the model's effects (D33g).
    double beyond_ordinary = 0;
    // Probability that chance leaves a gap as large, in any channel or drive, or errors of readings as large (D33b,
    // D33f).
    double by_chance = 1;
    // Nats by which tolerances with long tails are likelier than those that were told: numbers moved too far (D33a).
    double strain = 0;
    double of_law = 0;         // nats that a force law gains beside it (D35)
    bool law_visible = false;  // it closes more of the gap than chance may (D38e)
    // Nats by which sets of effects that cannot be the answer are likelier than those that can: an unknown cause may
    // look like one of them (D33c).
    double rejected = -kInfinity;
    answer::ForceLaw law;              // that the remainder follows; empty unless clear and visible
    answer::Vibration vibration = {};  // faster than the rows (D33e)

    bool visible() const;        // otherwise only a law that is visible by itself needs a cause
    double nats() const;         // for an unknown cause
    double probability() const;  // that a cause of no catalogue is part of it
};

// Nats by which Student's t with four degrees of freedom and the same variance is likelier than the normal distribution
// for a deviation, in standard deviations; 0 where it is not (D33a).
double natsOfTail(double deviation);

// `closest`: the closest car with the effects of the model.
Remains whatRemains(const Calibration& car, const Candidate& model, const Closest& closest);

}  // namespace tread::diagnose::select
