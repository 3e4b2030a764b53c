// The driver's inputs, reconstructed from the readings of their instruments.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recording/recorded_drive.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread::recording {

// Channels of the driver, commands, and the speed that may be followed, with the instruments' noise removed. Replaying
// the noise would shake the car, and play in the steering would then seem to suppress the shaking. Fast inputs such as
// a step steer are kept.
Log quietInputs(const Log& log);

bool isInput(std::string_view channel);  // of the driver, or a command

// Evenly spaced values with their noise removed: each is replaced by the widest parabola through its neighbours that
// leaves no more than noise. The value lies in the middle of these, except near the
// first and the last one.
std::vector<double> quietened(const std::vector<double>& values);

// The first gap in the inputs that a replay needs; shorter gaps are bridged by straight lines.
std::optional<InputGap> firstGap(const RecordedDrive& drive);

// The input behind a recorded channel, over the time of the drive; empty without that channel (D5).
Curve driverInput(const RecordedDrive& drive, const std::string& channel, const Instrument& instrument,
                  const Limits& limits);

// The speed behind the recorded one, as a car can follow it: a parabola through 0.4 s about each sample (at an end of
// the drive, the 0.4 s there), so that what is left of the noise does not become acceleration.
Curve followedSpeed(const RecordedDrive& drive, const Instruments& instruments);

// The channel that commands the longitudinal motion; empty without one.
std::string commandOf(const Log& log);

// The force that the actuator makes of the recorded command, over the time of the drive. A commanded acceleration
// counts as the force that it takes with the nominal mass [kg] (D5b).
Curve commandedForce(const RecordedDrive& drive, const ForceActuator& actuator, double mass);

}  // namespace tread::recording
