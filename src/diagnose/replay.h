// The model repeats a recorded drive, and is observed as the real car was.
#pragma once

#include "diagnose/diagnosis.h"
#include "diagnose/drive.h"

namespace tread {

// The scenario in which the subject does what the drive's driver did.
Scenario replayOf(const RecordedDrive& drive, const Subject& subject, const Subject& nominal, double step);

// What the model does, at every step: the channels that instruments observe, time from 0 at the drive's beginning.
// `pushing`, when there is one, acts on the car in the time of the drive.
// Throws SimulationError.
Log replayed(const RecordedDrive& drive, const Subject& subject, const Subject& nominal, double step,
             const Simulate& simulate, const Pushing& pushing = {});

// What the instruments would have shown: all rows of the drive.
Eigen::VectorXd readings(const RecordedDrive& drive, const Log& motion, const Instruments& instruments);

}  // namespace tread
