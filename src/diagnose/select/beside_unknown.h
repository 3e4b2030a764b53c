// Whether an effect acts beside an unknown cause, or is no more than the effect most like it.
#pragma once

#include <cstddef>

namespace tread::diagnose::select {

// The share of the gap that an effect closes is between these, as far as noise lets it be known.
struct ClosedShare {
    double least, most;
};

// Squared gaps beyond noise with all effects that are named, and with all but one of them; `scatter`: their standard
// deviation by noise alone.
ClosedShare closedShare(double with, double without, double scatter);

// Probability that one of so many named effects acts, if an unknown cause does. If the unknown cause acts alone, it is
// alike to the effect to any degree, and all shares are as probable; if both act, one is larger by up to two orders of
// magnitude, and the logarithm of share/(1 - share) is uniform (D32a).
double actsBesideUnknown(const ClosedShare& closed, std::size_t named);

}  // namespace tread::diagnose::select
