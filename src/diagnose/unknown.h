// Does something act that no effect of the catalogue explains?
#pragma once

#include "diagnose/force_law.h"
#include "diagnose/search.h"

namespace tread {

// What speaks for a cause that is not in the catalogue: larger disturbances than the best model has, or forces that
// follow a law in place of its effects.
struct Outside {
    double gain = 0;  // nats over the best model, of what speaks most for an unknown cause
    ForceLaw law;     // in place of its effects if that is clear, else beside them; named if it is likelier than those
};
Outside outside(const Study& study, const Search& found);

// Is one value of the model's effects right for all drives? Cochran's Q of what each drive alone asks for.
struct Constancy {
    double q = 0;
    double degrees_of_freedom = 0;
    double p = 1;
    double spread = 0;  // of the value from drive to drive, beyond chance and as a share of it
};
Constancy constancy(const Study& study, const Fit& fit);

// Nats that something gains over a model's effects which it merely imitates: it need not keep to their typical sizes,
// nor to one value in all drives. Where recordings are `compared` with references, somebody changed the car by as much
// as he liked, and a model of another structure finds a value that varies a little.
double imitationGain(const Candidate& candidate, const Constancy& same, bool compared);

// P(X > x) of the chi-squared distribution.
double chiSquaredTail(double x, double degrees_of_freedom);

}  // namespace tread
