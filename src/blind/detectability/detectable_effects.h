// Effects that are detectable at all in a car: a tyre file without data on pressure does not respond to pressure.
#pragma once

#include <vector>

#include "blind/drives/drives.h"
#include "diagnose/catalogue/effect.h"
#include "tread/vehicle.h"

namespace tread::blind::detectability {

// Effects whose typical size changes the readings of the training drives clearly beyond their noise.
std::vector<diagnose::catalogue::Effect> detectableEffects(const VehicleParams& nominal,
                                                           const std::vector<diagnose::catalogue::Effect>& effects,
                                                           const std::vector<drives::Drive>& drives);

}  // namespace tread::blind::detectability
