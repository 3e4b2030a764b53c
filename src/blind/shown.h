// Which effects a car can show at all: a tyre whose file says nothing about pressure does not change with it.
#pragma once

#include <vector>

#include "blind/drives.h"
#include "diagnose/catalogue/effect.h"
#include "tread/vehicle.h"

namespace tread {

// The effects whose typical size changes the readings of these drives by more than their noise.
std::vector<diagnose::catalogue::Effect> shownEffects(const VehicleParams& nominal,
                                                      const std::vector<diagnose::catalogue::Effect>& effects,
                                                      const std::vector<Drive>& drives);

}  // namespace tread
