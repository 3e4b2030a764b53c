// Evidence for a cause that is not in the catalogue.
#pragma once

#include "diagnose/select/force_law.h"
#include "diagnose/select/search.h"
#include "inference/heterogeneity.h"

namespace tread::diagnose::select {

// Evidence for larger disturbances than the best model has, or for forces that follow a law in place of its effects.
struct UnknownCause {
    double gain = 0;  // nats over the best model, of the stronger of the two
    // In place of the effects if that is clear, else beside them. Empty unless clear and likelier than larger
    // disturbances.
    answer::ForceLaw law;
};
// For the best model of the search (D36).
UnknownCause unknownCause(const Calibration& car, const Search& found);

// Tests whether one value of the fitted effects suits all drives.
inference::Heterogeneity heterogeneity(const Calibration& car, const Fit& fit);

// Nats that an unknown cause gains over a model's effects if it merely resembles them: it need not have one value in
// all drives. The value of a true effect may vary too: by the error of its signature or, when recordings are `compared`
// with references, because the model's structure differs from the car's (D39).
double lookAlikeGain(const inference::Heterogeneity& same, bool compared);

}  // namespace tread::diagnose::select
