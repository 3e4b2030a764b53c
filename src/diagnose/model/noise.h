// Noise of the rows of the recordings.
#pragma once

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Factor on noise and disturbances of a drive for the part that its reference does not remove: what a model lacks
// depends somewhat on the disturbances, and these differ between two drives. 1 without a reference.
double referenceInflation(const RecordedDrive& drive);

// Factor on the disturbances in the rows of a drive relative to those of a single run: the root of the number of runs
// (two if a reference is subtracted) times referenceInflation().
double disturbanceScale(const RecordedDrive& drive);

// Noise of one drive. `deviation` is the standard deviation of each row, taken as white noise: the value that the file
// gives for the instrument, but not less than this drive shows between 2 and 7 Hz and the model does not explain.
// Rows without information have infinite noise.
struct RowNoise {
    Eigen::VectorXd deviation;
    std::vector<Eigen::Index> ends;  // of the rows of each channel: index behind the last one
    double expected = 0;             // sum of squares that white noise is expected to leave in over()

    // Rows (one column per quantity) divided by their noise and smoothed by inference::binomial(). The smoothing keeps
    // slow noise at variance 1 and gives fast deviations little weight, because engine and road vibration shake the
    // instruments at high frequencies.
    Eigen::MatrixXd over(const Eigen::Ref<const Eigen::MatrixXd>& rows) const;
};

// `model`: rows of the model in the drives. `until`: time in each drive, s, after which rows carry no information (D8),
// (D8a), (D45).
std::vector<RowNoise> rowNoise(Drives drives, const Rows& model, const std::vector<double>& until);

}  // namespace tread::diagnose::model
