// Why a set of effects cannot be the answer, whatever its evidence.
#pragma once

#include <string>

#include "diagnose/select/closeness.h"
#include "diagnose/select/held_out.h"
#include "diagnose/select/left_out.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::select {

inline constexpr const char *kAtItsEnd = "a number is at the end of its plausible range",
                            *kClosesByChance = "one of its effects closes no more of the gap than chance could";

// True when a knob is at an end of its plausible range. If that end is within the usual sizes, the fit without it must
// also lie beyond it by more than the uncertainty of the knob.
bool implausible(const Calibration& car, const Fit& fit);

// Why a model cannot be the answer, as far as its fit tells; empty when it can: its numbers are plausible, it predicts
// the drives that are left out, its effects have the same values in all drives, and those held out do not speak against
// it.
std::string objectionInTheFit(const Calibration& car, const Candidate& model, const Search& found,
                              const HeldOut& held_out, double variance_factor);

// The same as far as the gap tells: each effect closes more of it than chance may, and does not enlarge it in drives
// that it is not fitted to.
std::string objectionInTheGap(const Calibration& car, const Candidate& model, const Closeness& closeness,
                              LeftOut& left_out);

}  // namespace tread::diagnose::select
