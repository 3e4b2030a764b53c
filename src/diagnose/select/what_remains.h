// What a model leaves: whether its remainder exceeds the disturbances and model errors of an ordinary drive, and which
// law it follows.
#pragma once

#include "diagnose/select/force_law.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::select {

struct Remains {
    // Nats by which the remainder as large as estimated is likelier than one of ordinary size (D33).
    double beyond_ordinary = 0;
    // Largest squared gap of a channel or of a drive over that of a perfect model, less 1.
    double excess = 0;
    // Nats by which tolerances with long tails are likelier than those that were told: numbers moved too far (D33a).
    double strain = 0;
    double of_law = 0;     // nats that a force law gains beside it (D35)
    answer::ForceLaw law;  // that the remainder follows; empty unless clear

    bool material() const;
    double nats() const;  // for an unknown cause
    double probability() const;  // that a cause of no catalogue is part of it
    bool seen() const;           // as probable as what is claimed
};
// `rows`: of the answer, with its sizes free of their prior.
Remains whatRemains(const Calibration& car, const Candidate& model, const Rows& rows);

}  // namespace tread::diagnose::select
