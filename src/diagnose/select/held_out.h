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
    // True when the drives speak against a model: their gap does not shrink, which is improbable where the model is
    // true, because they show its difference to the one without effects (D38b). `variance_factor`: on the variances of
    // the fitted numbers, B of (D42).
    bool speakAgainst(const Fit& with, const Deviation& without, double variance_factor) const;

private:
    // Product of two changes of the rows, with disturbances marginalised.
    double product(const Rows& one, const Rows& other) const;
};
HeldOut heldOut(const Calibration& car);

// Squared residuals of drives with the effects of a model and without, squared difference between the two, variance of
// the residuals, and that of the product of the difference and the errors of the fitted numbers.
struct HeldOutGap {
    double with, without, difference, variance, by_numbers = 0;
};
// True when the gap does not shrink and a true model would leave it so by chance only (D38b).
bool speaksAgainst(const HeldOutGap& gap);

}  // namespace tread::diagnose::select
