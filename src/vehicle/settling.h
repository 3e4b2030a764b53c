// Who advances a car while it settles into its equilibrium: the car alone, unless somebody has several to advance.
#pragma once

#include <functional>
#include <memory>

#include "tread/equilibrium.h"

namespace tread {

class Settling {
public:
    virtual ~Settling() = default;
    // By dt with this input. Of the state, what glance() reads and the rates of the wheels are here after it; these
    // rates, the driveline, the steering and the motion may be others before the next step.
    virtual void advance(ChassisMotion& motion, VehicleState& state, const VehicleInput& input, double dt) = 0;
    // All of the state.
    virtual void complete(VehicleState& state) = 0;
};

// For a car that lives as long.
using SettlingOf = std::function<std::unique_ptr<Settling>(const Vehicle&)>;

// equilibrium() of tread/equilibrium.h, with somebody else who advances the car.
Equilibrium equilibrium(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start,
                        const SettlingOf& settling);

}  // namespace tread
