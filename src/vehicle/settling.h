// How a car settles into its equilibrium: from its static height or from where a similar car has settled, advanced
// alone unless somebody has several to advance.
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

// Where the settling of a car ended.
struct Settled {
    ChassisMotion place;  // of the car at static height
    ChassisMotion motion;
    VehicleState state;
    VehicleInput input;
    double torque = 0;                      // N m, of the wheels; as far as the car rolls
    bool pulls = false;                     // whether it pulls to a side, so that these two are sought
    double trim = 0;                        // rad, steering wheel behind its play
    double sideways = 0;                    // m/s, to the left
    double throttle = 0, acceleration = 0;  // as in Equilibrium
};

// `from`: where another car has settled at the same start, on the same road and in the same wind; null: none. The
// nearer that car, the sooner this one is at rest. `settling`: who advances it; empty: the car alone.
Settled settle(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start,
               const Settled* from = nullptr, const SettlingOf& settling = {});

// equilibrium() of tread/equilibrium.h for a car that has settled.
Equilibrium atRest(const Settled& settled, const Vehicle& vehicle);

}  // namespace tread
