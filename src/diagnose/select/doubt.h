// Doubt about the signatures of effects: a model that explains much may be wrong about it by more than a rival differs.
#pragma once

#include "diagnose/model/channel_squares.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::select {

// What these knobs of a fit explain in each drive, squared: the part of their signature that its other free parameters
// cannot imitate.
std::vector<double> explainedIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs);

// True when one drive holds nearly all of what is explained, so that the others cannot test it.
bool toldByOneDrive(const std::vector<double>& explained);

// Signature of the effects of a fit: whitened changes of the rows of each drive.
std::vector<Eigen::VectorXd> changedByEffects(const Fit& fit);

// Divisor of the evidence that a difference from a model gives: `off`, whitened rows of each drive. In each channel,
// the signatures of the model's effects may be wrong by the signatures' error times all that the effects change there,
// also what its other parameters could imitate: they imitate the signature, not its error. In the worst case, each
// channel errs along the difference, and those of a drive with the correlation that hides most of it. Drives err
// independently. 1 for the model without effects (D30).
double doubtAlong(const Calibration& car, const model::ChannelSquares& squares, const Fit& fit,
                  const std::vector<Eigen::VectorXd>& off);

// The same of the evidence for a rival with these rows.
double doubt(const Calibration& car, const model::ChannelSquares& squares, const Fit& fit, const Rows& rival);

}  // namespace tread::diagnose::select
