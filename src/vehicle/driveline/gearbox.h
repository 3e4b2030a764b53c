// Gears: which is in, when it changes, and how far the change has come.
#pragma once

#include "tread/driveline.h"

namespace tread {

double totalRatio(const GearboxParams& gearbox, int gear);
int gears(const GearboxParams& gearbox);

// Time since the last shift after which the gearbox may shift again.
double shiftPause(const GearboxParams& gearbox);

// Takes the next gear or the one below when the shift map says so.
void shift(DrivelineState& state, const GearboxParams& gearbox, double throttle, double dt);

// How far the clutch is closed again after a shift, 0 to 1.
double engagement(const DrivelineState& state, const GearboxParams& gearbox);

}  // namespace tread
