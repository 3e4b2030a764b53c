// What goes into the car and what is logged of it: the columns of every log. ISO 8855 axes and signs.
#pragma once

#include "tread/describe.h"
#include "tread/wheels.h"

namespace tread {

inline constexpr double kStandardGravity = 9.80665;  // m/s2

struct VehicleInput {
    double steering_wheel_angle = 0;
    double throttle = 0;
    double brake = 0;
    double clutch = 0;
    double parking_brake = 0;
    double hands_off = 0;
    double longitudinal_force = 0;
    double force_command = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(steering_wheel_angle), About{"rad", "steering-wheel angle, positive to the left"});
        field(TREAD_FIELD(throttle), About{"-", "throttle pedal", kFraction});
        field(TREAD_FIELD(brake), About{"-", "brake pedal", kFraction});
        field(TREAD_FIELD(clutch), About{"-", "clutch pedal, 1 separates engine and gearbox", kFraction});
        field(TREAD_FIELD(parking_brake), About{"-", "parking brake", kFraction});
        field(TREAD_FIELD(hands_off), About{"-", "1: hands off the steering wheel", kFraction});
        field(TREAD_FIELD(longitudinal_force),
              About{"N", "commanded longitudinal force of all tyres together, positive forward"});
        field(TREAD_FIELD(force_command),
              About{"-", "1: the commanded force replaces engine, motor and brake pedal", kFraction});
    }
};
static_assert(describesEveryMember<VehicleInput>());

// Position, velocity, acceleration and sideslip angle are those of the centre of gravity of the car without the load
// that its file adds (VehicleParams::load): of a point that is fixed to the body, as instruments are.
struct ChassisOutput {
    double x = 0, y = 0, z = 0;
    double roll = 0, pitch = 0, yaw = 0;
    double vx = 0, vy = 0, vz = 0;
    double roll_rate = 0, pitch_rate = 0, yaw_rate = 0;
    double ax = 0, ay = 0, az = 0;
    double sideslip = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "position of the centre of gravity"});
        field(TREAD_FIELD(y), About{"m", "position of the centre of gravity"});
        field(TREAD_FIELD(z), About{"m", "position of the centre of gravity"});
        field(TREAD_FIELD(roll), About{"rad", "roll angle, positive with the right side down"});
        field(TREAD_FIELD(pitch), About{"rad", "pitch angle, positive with the nose down"});
        field(TREAD_FIELD(yaw), About{"rad", "yaw angle, positive to the left"});
        field(TREAD_FIELD(vx), About{"m/s", "longitudinal velocity, horizontal along the heading"});
        field(TREAD_FIELD(vy), About{"m/s", "lateral velocity, horizontal, positive to the left"});
        field(TREAD_FIELD(vz), About{"m/s", "vertical velocity"});
        field(TREAD_FIELD(roll_rate), About{"rad/s", "angular velocity about the horizontal heading axis"});
        field(TREAD_FIELD(pitch_rate), About{"rad/s", "angular velocity about the horizontal lateral axis"});
        field(TREAD_FIELD(yaw_rate), About{"rad/s", "angular velocity about the vertical"});
        field(TREAD_FIELD(ax), About{"m/s2", "longitudinal acceleration, horizontal, without gravity"});
        field(TREAD_FIELD(ay), About{"m/s2", "lateral acceleration, horizontal, without gravity"});
        field(TREAD_FIELD(az), About{"m/s2", "vertical acceleration, without gravity"});
        field(TREAD_FIELD(sideslip), About{"rad", "sideslip angle at the centre of gravity, 0 below 0.5 m/s"});
    }
};
static_assert(describesEveryMember<ChassisOutput>());

struct WheelOutput {
    double load = 0, fx = 0, fy = 0, mz = 0;
    double slip_ratio = 0, slip_angle = 0;
    double camber = 0, steer = 0;
    double spin = 0;
    double travel = 0;
    double drive_torque = 0, brake_torque = 0;
    double brake_temperature = 0;
    double patch_u = 0, patch_v = 0;
    double temperature = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(load), About{"N", "normal load of the tyre"});
        field(TREAD_FIELD(fx), About{"N", "longitudinal tyre force, wheel axes"});
        field(TREAD_FIELD(fy), About{"N", "lateral tyre force, wheel axes"});
        field(TREAD_FIELD(mz), About{"N m", "aligning moment, wheel axes"});
        field(TREAD_FIELD(slip_ratio), About{"-", "longitudinal slip of the rim, -1 when locked"});
        field(TREAD_FIELD(slip_angle), About{"rad", "slip angle of the wheel"});
        field(TREAD_FIELD(camber), About{"rad", "inclination against the road, positive with the top to the right"});
        field(TREAD_FIELD(steer), About{"rad", "angle of the wheel against the body, toe included"});
        field(TREAD_FIELD(spin), About{"rad/s", "wheel speed"});
        field(TREAD_FIELD(travel), About{"m", "suspension travel, positive in compression"});
        field(TREAD_FIELD(drive_torque), About{"N m", "torque of the driveline on the wheel"});
        field(TREAD_FIELD(brake_torque), About{"N m", "torque that the brake can hold"});
        field(TREAD_FIELD(brake_temperature), About{"K", "temperature of the brake disc"});
        field(TREAD_FIELD(patch_u), About{"m", "longitudinal deflection of the contact patch"});
        field(TREAD_FIELD(patch_v), About{"m", "lateral deflection of the contact patch"});
        field(TREAD_FIELD(temperature), About{"K", "temperature of the tyre"});
    }
};
static_assert(describesEveryMember<WheelOutput>());

struct SteeringOutput {
    double angle = 0;
    double torque = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(angle), About{"rad", "angle of the steering wheel, positive to the left"});
        field(
            TREAD_FIELD(torque),
            About{"N m", "torque of the driver on the steering wheel without power assistance, positive to the left"});
    }
};
static_assert(describesEveryMember<SteeringOutput>());

struct DrivelineOutput {
    double engine_speed = 0;
    double engine_torque = 0;
    double motor_torque = 0;
    double gear = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(engine_speed), About{"rad/s", "engine speed; motor speed in a car without an engine"});
        field(TREAD_FIELD(engine_torque), About{"N m", "engine torque"});
        field(TREAD_FIELD(motor_torque), About{"N m", "torque of the electric motor"});
        field(TREAD_FIELD(gear), About{"-", "gear"});
    }
};
static_assert(describesEveryMember<DrivelineOutput>());

struct BrakeOutput {
    double anti_lock = 0;
    double stability_control = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(anti_lock), About{"-", "number of wheels whose pressure the anti-lock control regulates"});
        field(TREAD_FIELD(stability_control), About{"N m", "brake torque demanded by the stability control"});
    }
};
static_assert(describesEveryMember<BrakeOutput>());

struct VehicleOutput {
    ChassisOutput chassis;
    PerWheel<WheelOutput> wheel;
    SteeringOutput steering;
    DrivelineOutput driveline;
    BrakeOutput brakes;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(chassis), About{"", "motion of the body"});
        field(TREAD_FIELD(wheel), About{"", "wheels and tyres"});
        field(TREAD_FIELD(steering), About{"", "steering"});
        field(TREAD_FIELD(driveline), About{"", "driveline"});
        field(TREAD_FIELD(brakes), About{"", "brakes"});
    }
};
static_assert(describesEveryMember<VehicleOutput>());

}  // namespace tread
