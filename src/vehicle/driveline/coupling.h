// Clutch and torque converter between engine and gearbox.
#pragma once

#include "tread/driveline.h"

namespace tread {

struct CouplingTorques {
    double engine;   // N m, taken from the engine
    double gearbox;  // N m, given to the gearbox
};

// What both sides do over a step without the coupling, and by how much a torque changes their speeds at its end.
struct CouplingInput {
    double engine_speed;   // rad/s, at the end without the coupling
    double gearbox_speed;  // rad/s
    double engine_per_torque;
    double gearbox_per_torque;
    double closed;  // 0 to 1: pedal and shift
};
CouplingTorques coupled(const DrivelineParams& params, const DrivelineState& state, const CouplingInput& input);

// Speed of the engine at which the coupling gives the gearbox a torque steadily, and the torque that it then takes from
// the engine; `idling` is the torque with which the engine can creep at a speed.
struct SteadyCoupling {
    double engine_speed;    // rad/s
    double engine_torque;   // N m
    double gearbox_torque;  // N m: what was asked for, or that of a creeping converter at standstill
};
SteadyCoupling steadyCoupling(const DrivelineParams& params, double gearbox_speed, int gear, double gearbox_torque,
                              bool standing);

}  // namespace tread
