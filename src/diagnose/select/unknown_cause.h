// Does something act that no effect of the catalogue explains?
#pragma once

#include "diagnose/select/force_law.h"
#include "diagnose/select/search.h"
#include "inference/heterogeneity.h"

namespace tread::diagnose::select {

// What speaks for a cause that is not in the catalogue: larger disturbances than the best model has, or forces that
// follow a law in place of its effects.
struct UnknownCause {
    double gain = 0;       // nats over the best model, of what speaks most for an unknown cause
    answer::ForceLaw law;  // in place of its effects if that is clear, else beside them; named if likelier than those
};
// For the best model of the search (D36).
UnknownCause unknownCause(const Calibration& car, const Search& found);

// Is one value of the model's effects right for all drives?
inference::Heterogeneity heterogeneity(const Calibration& car, const Fit& fit);

// Nats that a cause of no catalogue gains over a model's effects when it merely looks like them: it need not keep to
// their typical sizes, nor to one value in all drives. Where recordings are `compared` with references, somebody
// changed the car by as much as he liked, and a model of another structure finds a value that varies a little (D39).
double lookAlikeGain(const Candidate& candidate, const inference::Heterogeneity& same, bool compared);

}  // namespace tread::diagnose::select
