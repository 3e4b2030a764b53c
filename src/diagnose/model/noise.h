// How noisy the rows of the recordings are.
#pragma once

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Factor on noise and disturbances of a drive for what its reference does not take off: what a model lacks depends a
// little on what disturbs the drive, which is never the same twice. 1 without a reference.
double referenceInflation(const RecordedDrive& drive);

// How large the disturbances are that the rows of a drive hold, over those of one drive: two runs of the car when a
// reference is taken off, and its inflation.
double disturbanceScale(const RecordedDrive& drive);

// Of one drive. `deviation` is the standard deviation of each row that is white noise: what the file tells of the
// instrument, and not less than what the recordings show between 2 and 7 Hz that the model does not explain. Above that
// engine and road shake the instruments: the faster a deviation, the less it says. Rows that say nothing are infinitely
// noisy.
struct RowNoise {
    Eigen::VectorXd deviation;
    std::vector<Eigen::Index> ends;  // of the rows of each channel
    double expected = 0;             // sum of squares that over() leaves of white noise

    // Columns of rows over their noise, smoothed (inference::binomial): in them white noise of deviation 1 is what is
    // slow.
    Eigen::MatrixXd over(const Eigen::Ref<const Eigen::MatrixXd>& rows) const;
};

// `model`: what the model does in the drives; `until`: s, of each drive, what comes later says nothing (D8), (D45).
std::vector<RowNoise> rowNoise(Drives drives, const Rows& model, const std::vector<double>& until);

}  // namespace tread::diagnose::model
