// Sharing of the torque of the shafts among the wheels.
#pragma once

#include "tread/driveline.h"

namespace tread {

PerWheel<double> sharedTorque(const DrivelineParams& params, const DrivelineInput& input, double torque, double dt);

}  // namespace tread
