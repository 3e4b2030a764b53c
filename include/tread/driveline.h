// Driveline: engine with clutch or converter, or electric motor; gearbox, shafts and differentials.
#pragma once

#include <optional>

#include "tread/api.h"
#include "tread/describe.h"
#include "tread/differential.h"
#include "tread/engine.h"
#include "tread/gearbox.h"
#include "tread/wheels.h"

namespace tread {

struct DrivelineParams {
    std::optional<EngineParams> engine;
    std::optional<MotorParams> motor;
    CouplingParams coupling;
    GearboxParams gearbox;
    double front_share = kRequired;
    AxleDifferential front_differential;
    AxleDifferential rear_differential;
    CentreDifferential centre_differential;
    double shaft_stiffness = 15000;
    double shaft_damping = 60;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(engine), About{"", "combustion engine"});
        field(TREAD_FIELD(motor), About{"", "electric motor at the gearbox input, alone or beside the engine"});
        field(TREAD_FIELD(coupling), About{"", "coupling between engine and gearbox"});
        field(TREAD_FIELD(gearbox), About{"", "gearbox with automatic shifting"});
        field(TREAD_FIELD(front_share), About{"-", "share of the torque that goes to the front axle", kFraction});
        field(TREAD_FIELD(front_differential), About{"", "differential between the front wheels"});
        field(TREAD_FIELD(rear_differential), About{"", "differential between the rear wheels"});
        field(
            TREAD_FIELD(centre_differential),
            About{
                "",
                "differential between the axles; with front_share 0 or 1 it couples the other axle to the driven one"});
        field(TREAD_FIELD(shaft_stiffness),
              About{"N m/rad", "torsional stiffness of the shafts, at the wheels", kPositive, 0.2}.usually(0.5, 1e6));
        field(TREAD_FIELD(shaft_damping),
              About{"N m s/rad", "torsional damping of the shafts", kNonNegative, 0.5}.usually(0, 1e4));
    }

    static void check(const auto& self, auto&& complain) {
        if (!self.engine && !self.motor)
            complain("engine", "found neither engine nor motor, expected at least one of them");
        const auto* clutch = std::get_if<ClutchParams>(&self.coupling);
        if (self.engine && clutch && clutch->torque == 0)
            complain("coupling", "missing, expected a clutch with its torque or a torque_converter behind the engine");
    }
};
static_assert(describesEveryMember<DrivelineParams>());

struct DrivelineState {
    double engine_speed = 0;     // rad/s; without an engine that of the motor
    double gearbox_speed = 0;    // rad/s, at the gearbox input
    double twist = 0;            // rad, of the shafts, at the wheels
    double since_shift = 0;      // s
    double engine_throttle = 0;  // the throttle that the engine's torque follows
    double motor_throttle = 0;
    int gear = 1;  // 1 is the first
};

struct DrivelineInput {
    double throttle;              // 0 to 1
    double clutch_pedal;          // 0 closed to 1 open
    PerWheel<double> wheel_spin;  // rad/s
    // For differentials that are not open: torque of road and brake on each wheel over the last step, N m, and inertia.
    PerWheel<double> wheel_load{};
    PerWheel<double> wheel_inertia{};
    double lateral_acceleration = 0;    // m/s2
    double brake_torque = 0;            // N m, of all brakes together, as far as a motor may take it over
    std::optional<double> commanded{};  // N m, on all wheels together, in place of the torque of engine and motor
};

struct DrivelineTorques {
    PerWheel<double> wheel;  // N m, on each wheel
    double engine;           // N m
    double motor;            // N m
    PerAxle<double> braked;  // N m, not negative: what the motor recovers for the brake pedal, each wheel of the axle
};

TREAD_API DrivelineTorques advance(DrivelineState& state, const DrivelineParams& params, const DrivelineInput& input,
                                   double dt);

// The state in which the driveline runs steadily at a wheel spin, giving a torque (all wheels together) to the wheels,
// and the throttle that this needs (it may lie outside 0 to 1: the car cannot hold that speed). At standstill a torque
// converter gives the torque with which it creeps, whatever torque is asked for.
struct SteadyDriveline {
    DrivelineState state;
    double throttle;
};
TREAD_API SteadyDriveline steadyDriveline(const DrivelineParams& params, double wheel_spin, double wheel_torque);

}  // namespace tread
