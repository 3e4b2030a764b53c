// Random part of the readings of a drive: noise of the instruments, and pushes by the surroundings.
#pragma once

#include "blind/detectability/detectability.h"
#include "blind/detectability/examination.h"
#include "blind/world/truth.h"
#include "log/log.h"

namespace tread::blind::detectability {

// N and B of detectability.h; the other columns are left empty. `readings`: of this car in this drive, without noise
// and pushes (drives::readingsOf).
DriveColumns noiseAndPushes(const ExaminedDrive& drive, const world::Truth& truth, const Log& readings);

}  // namespace tread::blind::detectability
