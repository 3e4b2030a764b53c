// What the driver did, from what the instruments showed of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recording/recorded_drive.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread::recording {

// The channels of the driver, and the speed that he may follow, without their instruments' noise: a car that is driven
// with it trembles, and a play in the steering would seem to calm it. What is quick, a turn or a kick, stays as it was.
Log quietInputs(const Log& log);

// Evenly spaced values without their noise: each lies on the parabola through those around it, as far as that leaves no
// more than noise.
std::vector<double> quietened(const std::vector<double>& values);

// The first gap in what the replay of a drive needs; shorter ones are bridged by straight lines.
std::optional<InputGap> firstGap(const RecordedDrive& drive);

// The input that a channel recorded, over the time of the drive; empty without that channel (D5).
Curve driverInput(const RecordedDrive& drive, const std::string& channel, const Instrument& instrument,
                  const Limits& limits);

}  // namespace tread::recording
