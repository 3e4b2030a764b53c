// Replay of a recorded drive by the model, read through the instruments of the real car.
#pragma once

#include <functional>

#include "recording/recorded_drive.h"
#include "run/simulate.h"

namespace tread::recording {

// Simulates a car; tests replace it by models of a few lines.
using Simulate = std::function<void(const VehicleParams&, const Scenario&, const Recorder&, const Pushing&)>;

// The nominal car, and the simulator that repeats drives with it and with variants of it.
struct Replayer {
    Subject nominal;
    double step = 0.002;  // s
    Simulate simulate;
    // m/s, added to the speed at which a drive starts, and to the speed that it follows before pedals or a command act.
    // Where the speed is followed throughout, it is none other than the measured one.
    double faster = 0;
};

// The scenario in which the driver's inputs of the drive act on the subject.
Scenario replayOf(const RecordedDrive& drive, const Subject& subject, const Replayer& replayer);

// Motion of the model at every time step: the channels that instruments observe, time from 0 at the start of the drive.
// `pushing`, if given, adds external forces over the time of the drive. Throws SimulationError.
Log replayed(const RecordedDrive& drive, const Subject& subject, const Replayer& replayer, const Pushing& pushing = {});

// Readings of the instruments for a motion: all rows of the drive.
Eigen::VectorXd readings(const RecordedDrive& drive, const Log& motion, const Instruments& instruments);

}  // namespace tread::recording
