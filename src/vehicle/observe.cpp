#include <cmath>

#include "tread/vehicle.h"

#include "base/math/elementary.h"
#include "vehicle/tyre_load.h"

namespace tread {
namespace {

constexpr double kSlowWheel = 0.1;  // m/s, below which slips are reported against this speed
constexpr double kSlowBody = 0.5;   // m/s, below which the sideslip angle means nothing

ChassisOutput observeChassis(const PointMotion& point, const Vector3& gravity_W) {
    const ChassisMotion& motion = point.motion;
    const Vector3 up = gravity_W.norm() > 0 ? Vector3(-gravity_W.normalized()) : Vector3::UnitZ();
    const Eigen::Matrix3d body = motion.orientation.toRotationMatrix();
    // Intermediate axes of ISO 8855: x horizontal along the heading, z vertical.
    const Vector3 x = (body.col(0) - body.col(0).dot(up) * up).normalized();
    const Vector3 y = up.cross(x);
    const Vector3& acceleration = point.acceleration_W;

    ChassisOutput out;
    out.x = motion.position_W.x();
    out.y = motion.position_W.y();
    out.z = motion.position_W.z();
    out.yaw = arctan2(x.y(), x.x());
    out.pitch = -arcsine(std::clamp(body.col(0).dot(up), -1.0, 1.0));
    out.roll = arctan2(body.col(1).dot(up), body.col(2).dot(up));
    out.vx = motion.velocity_W.dot(x);
    out.vy = motion.velocity_W.dot(y);
    out.vz = motion.velocity_W.dot(up);
    out.roll_rate = motion.angular_velocity_W.dot(x);
    out.pitch_rate = motion.angular_velocity_W.dot(y);
    out.yaw_rate = motion.angular_velocity_W.dot(up);
    out.ax = acceleration.dot(x);
    out.ay = acceleration.dot(y);
    out.az = acceleration.dot(up);
    out.sideslip = hypotenuse(out.vx, out.vy) < kSlowBody ? 0 : arctan2(out.vy, out.vx);
    return out;
}

SteeringOutput observeSteering(const VehicleState& state, const SteeringParams& params) {
    const auto moment = [&](const WheelState& wheel, bool left) {
        return steeringMoment(params, wheel.fx, wheel.fy, wheel.mz, left);
    };
    const double torque = steeringWheelTorque(state.steering, params, moment(state.wheels.front_left, true),
                                              moment(state.wheels.front_right, false));
    return {state.steering.angle, torque};
}

WheelOutput observeWheel(const WheelState& wheel, const Vehicle::Corner& corner) {
    const double rolling_radius = rollingRadius(corner.tyre, wheel.motion.Fz);
    const double speed = std::max(std::abs(wheel.motion.Vx), kSlowWheel);
    WheelOutput out;
    out.load = wheel.load;
    out.fx = wheel.fx;
    out.fy = wheel.fy;
    out.mz = wheel.mz;
    out.slip_ratio = (rolling_radius * wheel.spin - wheel.motion.Vx) / speed;
    out.slip_angle = arctan2(-wheel.motion.Vsy, speed);
    out.camber = wheel.motion.gamma;
    out.steer = wheel.steer;
    out.spin = wheel.spin;
    out.travel = wheel.travel;
    out.drive_torque = wheel.drive_torque;
    out.brake_torque = wheel.brake_torque;
    out.patch_u = wheel.tyre.u;
    out.patch_v = -wheel.tyre.v;  // ISO 8855: positive to the left
    out.temperature = corner.temperature.start + wheel.warming;
    return out;
}

}  // namespace

PointMotion referenceMotion(const ChassisMotion& motion, const VehicleState& state, const Vehicle& vehicle) {
    const auto vectorOf = [](const std::array<double, 3>& a) { return Vector3(a[0], a[1], a[2]); };
    PointMotion point{motion, vectorOf(state.acceleration_W), vectorOf(state.angular_acceleration_W)};
    if (vehicle.reference_B.isZero(0)) return point;
    const Vector3 arm_W = motion.orientation * vehicle.reference_B;
    const Vector3& spin_W = motion.angular_velocity_W;
    point.motion.position_W += arm_W;
    point.motion.velocity_W += spin_W.cross(arm_W);
    point.acceleration_W += point.angular_acceleration_W.cross(arm_W) + spin_W.cross(spin_W.cross(arm_W));
    return point;
}

VehicleOutput observe(const ChassisMotion& motion, const VehicleState& state, const Vehicle& vehicle,
                      const Vector3& gravity_W) {
    VehicleOutput out;
    out.chassis = observeChassis(referenceMotion(motion, state, vehicle), gravity_W);
    for (std::size_t i = 0; i < kWheels; ++i) {
        out.wheel[i] = observeWheel(state.wheels[i], vehicle.corners[i]);
        out.wheel[i].brake_temperature = vehicle.params.brakes.ambient_temperature + state.brakes.heating[i];
        out.brakes.stability_control += state.brakes.stability_control.torque[i];
    }
    out.steering = observeSteering(state, vehicle.params.steering);
    out.brakes.anti_lock = regulatedWheels(state.brakes.anti_lock);
    out.driveline = {state.driveline.engine_speed, state.engine_torque, state.motor_torque,
                     static_cast<double>(state.driveline.gear)};
    return out;
}

void glance(VehicleOutput& output, const ChassisMotion& motion, const VehicleState& state, const Vehicle& vehicle,
            const Vector3& gravity_W) {
    output.chassis = observeChassis(referenceMotion(motion, state, vehicle), gravity_W);
    for (std::size_t i = 0; i < kWheels; ++i) output.wheel[i].spin = state.wheels[i].spin;
    output.steering.angle = state.steering.angle;
    output.driveline.engine_speed = state.driveline.engine_speed;
}

}  // namespace tread
