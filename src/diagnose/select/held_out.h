// The gap of a model in drives to which it was not fitted.
#pragma once

#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

struct HeldOut {
    const Problem& problem;
    Uncertainty uncertainty;  // of the drives held out, about the calibrated car

    Drives drives() const { return problem.held_out; }
    // Squared gap of each drive; nothing without drives, or when the model cannot be driven in them.
    std::optional<std::vector<double>> gapOf(const Deviation& at) const;
    // True when the drives speak against a model: they would show the difference between it and the one without
    // effects, and the gap does not shrink (D38b).
    bool speakAgainst(const Deviation& with, const Deviation& without) const;
};
HeldOut heldOut(const Calibration& car);

}  // namespace tread::diagnose::select
