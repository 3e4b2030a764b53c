// The model repeats a recorded drive, and is observed as the real car was.
#pragma once

#include <functional>

#include "recording/recorded_drive.h"
#include "run/simulate.h"

namespace tread::recording {

// Drives a car; replaced in tests by models of two lines.
using Simulate = std::function<void(const VehicleParams&, const Scenario&, const Recorder&, const Pushing&)>;

// The nominal car, and the simulator that repeats drives with it and with cars that differ from it.
struct Replayer {
    Subject nominal;
    double step = 0.002;  // s
    Simulate simulate;
};

// The scenario in which the subject does what the drive's driver did.
Scenario replayOf(const RecordedDrive& drive, const Subject& subject, const Replayer& replayer);

// What the model does, at every step: the channels that instruments observe, time from 0 at the drive's beginning.
// `pushing`, when there is one, acts on the car in the time of the drive. Throws SimulationError.
Log replayed(const RecordedDrive& drive, const Subject& subject, const Replayer& replayer, const Pushing& pushing = {});

// What the instruments would have shown: all rows of the drive.
Eigen::VectorXd readings(const RecordedDrive& drive, const Log& motion, const Instruments& instruments);

}  // namespace tread::recording
