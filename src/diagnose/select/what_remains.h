// What a model leaves: whether its remainder exceeds the disturbances and model errors of an ordinary drive, and which
// law it follows.
#pragma once

#include "diagnose/select/force_law.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::select {

struct Remains {
    // Nats by which the remainder as large as estimated is likelier than one of ordinary size (D33).
    double beyond_ordinary = 0;
    answer::ForceLaw law;  // that the remainder follows; empty unless clear

    bool seen() const;
    double probability() const;  // that a cause of no catalogue is part of it
};
Remains whatRemains(const Calibration& car, const Candidate& model);

}  // namespace tread::diagnose::select
