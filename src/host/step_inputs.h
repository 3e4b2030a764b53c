// The driver's inputs over one step of the world, in which the car takes several of its own.
#pragma once

#include "base/math/interpolate.h"
#include "tread/vehicle_output.h"

namespace tread {

// They move linearly from the one end to the other; what is on or off is so for the whole step.
class StepInputs {
public:
    StepInputs(const VehicleInput& from, const VehicleInput& to, int steps) : from_(from), to_(to), steps_(steps) {
        if (from.force_command != to.force_command) from_.longitudinal_force = to.longitudinal_force;
        from_.hands_off = to.hands_off;
        from_.force_command = to.force_command;
    }

    int steps() const { return steps_; }

    // After k of the steps.
    VehicleInput after(int k) const {
        return k == 0 ? from_ : interpolated(from_, to_, static_cast<double>(k) / steps_);
    }

private:
    VehicleInput from_, to_;
    int steps_;
};

}  // namespace tread
