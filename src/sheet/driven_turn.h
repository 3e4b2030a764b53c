// A steady turn driven by the simulated car itself.
#pragma once

#include "tread/vehicle.h"

namespace tread::sheet {

// Slopes between a turn to the right and one to the left; NaN where the car does not hold such a turn.
struct DrivenTurn {
    double understeer;  // rad s2/m, of the road-wheel angle beyond wheelbase over radius
    double roll;        // rad s2/m
};

// `guess`: steering, rad at the road wheels, for the lateral acceleration.
DrivenTurn drivenTurn(const VehicleParams& car, double speed, double road_wheel_angle);

}  // namespace tread::sheet
