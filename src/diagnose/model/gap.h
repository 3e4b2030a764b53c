// The measure of a gap between recording and model: squared differences in units of what noise and usual disturbances
// cause. The same for all models.
#pragma once

#include "diagnose/model/uncertainty.h"

namespace tread::diagnose::model {

// Whitened columns of the disturbances of a drive, each of the usual size.
Eigen::MatrixXd usualDisturbances(const Uncertainty& uncertainty, std::size_t drive);

// Standard deviation of the rows of a drive by noise and disturbances of the usual sizes; infinite for rows that are
// not compared (D46).
Eigen::VectorXd floorOf(const Uncertainty& uncertainty, std::size_t drive);

// The same of filtered rows, in units of the noise of a row.
Eigen::VectorXd filteredFloorOf(const Uncertainty& uncertainty, std::size_t drive);

// Noise that weights rows as the gap does: the floor in place of the noise, and no disturbance but the start speed.
// Least squares in it are those of the gap, filtered.
Uncertainty weightedAsTheGap(const Uncertainty& uncertainty, Drives drives);

// Gap of each row of a drive, in units of the floor.
Eigen::VectorXd gapOf(Drives drives, const Uncertainty& uncertainty, const Eigen::VectorXd& rows, std::size_t drive);

// Squared gap of a drive, in units of the floor: about `comparedRows` for a perfect model (D46).
double squaredGap(Drives drives, const Uncertainty& uncertainty, const Eigen::VectorXd& rows, std::size_t drive);
std::vector<double> squaredGaps(Drives drives, const Uncertainty& uncertainty, const Rows& rows);  // of each drive
double comparedRows(const Uncertainty& uncertainty, std::size_t drive);

// Root of the squared gap of all drives over the number of rows: 1 for a perfect model.
double levelOf(Drives drives, const Uncertainty& uncertainty, const Rows& rows);

}  // namespace tread::diagnose::model
