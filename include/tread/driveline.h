// Driveline: engine, clutch, gearbox, shafts and open differentials.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tread/curve.h"
#include "tread/describe.h"
#include "tread/wheels.h"

namespace tread {

struct EngineParams {
    Curve full_load;
    Curve drag;
    double inertia = kRequired;
    double idle_speed = kRequired;
    double speed_limit = kRequired;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(full_load), About{"N m", "torque at full throttle over engine speed", kAny, 0.05, "rad/s"});
        field(TREAD_FIELD(drag),
              About{"N m", "torque that turns the engine at closed throttle", kNonNegative, 0.2, "rad/s"});
        field(TREAD_FIELD(inertia), About{"kg m2", "inertia of engine and flywheel", kPositive, 0.2});
        field(TREAD_FIELD(idle_speed), About{"rad/s", "idle speed", kPositive});
        field(TREAD_FIELD(speed_limit), About{"rad/s", "speed at which the fuel is cut", kPositive});
    }
};
static_assert(describesEveryMember<EngineParams>());

struct GearboxParams {
    std::vector<double> ratios;
    double final_drive = kRequired;
    double efficiency = 1;
    double inertia = kRequired;
    double clutch_torque = kRequired;
    double shift_up_speed = kRequired;
    double shift_down_speed = kRequired;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(ratios), About{"-", "gear ratios, first gear first", kPositive});
        field(TREAD_FIELD(final_drive), About{"-", "final drive ratio", kPositive});
        field(TREAD_FIELD(efficiency), About{"-", "output torque over input torque when driving", {0, 1, true}, 0.03});
        field(TREAD_FIELD(inertia), About{"kg m2", "inertia at the gearbox input", kPositive});
        field(TREAD_FIELD(clutch_torque), About{"N m", "largest torque of the closed clutch", kPositive});
        field(TREAD_FIELD(shift_up_speed),
              About{"rad/s", "engine speed at which the next gear is taken at full throttle", kPositive});
        field(TREAD_FIELD(shift_down_speed),
              About{"rad/s", "engine speed below which the gear below is taken", kPositive});
    }
};
static_assert(describesEveryMember<GearboxParams>());

struct DrivelineParams {
    EngineParams engine;
    GearboxParams gearbox;
    double front_share = kRequired;
    double shaft_stiffness = 15000;
    double shaft_damping = 60;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(engine), About{"", "engine"});
        field(TREAD_FIELD(gearbox), About{"", "clutch and gearbox with automatic shifting"});
        field(TREAD_FIELD(front_share), About{"-", "share of the torque that goes to the front axle", kFraction});
        field(TREAD_FIELD(shaft_stiffness),
              About{"N m/rad", "torsional stiffness of the shafts, at the wheels", kPositive, 0.2});
        field(TREAD_FIELD(shaft_damping), About{"N m s/rad", "torsional damping of the shafts", kNonNegative, 0.5});
    }
};
static_assert(describesEveryMember<DrivelineParams>());

struct DrivelineState {
    double engine_speed = 0;   // rad/s
    double gearbox_speed = 0;  // rad/s, at the gearbox input
    double twist = 0;          // rad, of the shafts, at the wheels
    double since_shift = 0;    // s
    int gear = 1;              // 1 is the first
};

struct DrivelineInput {
    double throttle;              // 0 to 1
    double clutch_pedal;          // 0 closed to 1 open
    PerWheel<double> wheel_spin;  // rad/s
};

struct DrivelineTorques {
    PerAxle<double> wheel;  // N m, on each wheel of the axle
    double engine;          // N m
};

DrivelineTorques advance(DrivelineState& state, const DrivelineParams& params, const DrivelineInput& input, double dt);

// The state in which the driveline runs steadily at a wheel spin, giving a torque (all wheels together) to the wheels,
// and the throttle that this needs (it may lie outside 0 to 1: the car cannot hold that speed).
struct SteadyDriveline {
    DrivelineState state;
    double throttle;
};
SteadyDriveline steadyDriveline(const DrivelineParams& params, double wheel_spin, double wheel_torque);

}  // namespace tread
