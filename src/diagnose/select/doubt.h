// Doubt about the signatures of effects: a model that explains much may be wrong about it by more than a rival differs.
#pragma once

#include "diagnose/select/search.h"

namespace tread::diagnose::select {

// What these knobs of a fit explain in each drive, squared: the part of their signature that its other free parameters
// cannot imitate.
std::vector<double> explainedIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs);

// True when one drive holds nearly all of what is explained, so that the others cannot test it.
bool toldByOneDrive(const std::vector<double>& explained);

// Divisor of the evidence against a model. In each drive the error of its signatures may account for a difference of
// the size of the signatures' error times all that the model changes there, also what its other parameters could
// imitate: they imitate the signature, not its error. Drives count in proportion to what is explained in them. 1 for
// the model without effects (D30).
double doubt(const Calibration& car, const Fit& fit);

}  // namespace tread::diagnose::select
