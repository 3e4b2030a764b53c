// Two turning parts that dry friction and a viscous fluid couple.
#pragma once

#include <algorithm>

namespace tread {

// Torque over a step that makes their speeds equal at its end as far as `capacity` holds them, and a viscous torque on
// what is left, taken at the end of the step too: it never drives one past the other. `slip` is the difference of
// speeds at the end without it, `per_torque` by how much a torque lowers that.
inline double linkTorque(double slip, double per_torque, double capacity, double viscosity) {
    const double dry = std::clamp(slip / per_torque, -capacity, capacity);
    return dry + viscosity * (slip - per_torque * dry) / (1 + viscosity * per_torque);
}

}  // namespace tread
