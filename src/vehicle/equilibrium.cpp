// The equilibrium is found by letting the car settle: all sub-models, present and future, are in it as they are. What
// the settling adds is damping of the body; a rolling car is held at its speed while the torque at the wheels is sought
// that leaves no longitudinal acceleration.

#include "tread/equilibrium.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

constexpr double kStep = 0.001;      // s
constexpr double kLongest = 6;       // s
constexpr double kQuietTime = 0.05;  // s, for which the body must be quiet
constexpr double kQuiet = 1e-7;      // m/s2 and rad/s2
constexpr double kBodyDamping = 18;  // 1/s: about critical for heave, pitch and roll of a car
constexpr double kTorqueGain = 8;    // 1/s: how fast the torque at the wheels follows the need

// The car on its wheels at static height, its axes along the road.
ChassisMotion placed(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start) {
    const Vector3 up = -surroundings.gravity_W.normalized();
    const RoadContact ground = surroundings.road.contact({start.x, start.y, 0}, 0);
    const Vector3& n = ground.normal_W;
    Vector3 point(start.x, start.y, 0);
    point.z() =
        ground.point_W.z() - (n.x() * (start.x - ground.point_W.x()) + n.y() * (start.y - ground.point_W.y())) / n.z();

    const Vector3 heading = Quaternion(Eigen::AngleAxisd(start.heading, up)) * Vector3::UnitX();
    Eigen::Matrix3d axes;
    axes.col(0) = (heading - heading.dot(n) * n).normalized();
    axes.col(1) = n.cross(axes.col(0));
    axes.col(2) = n;
    ChassisMotion motion;
    motion.orientation = Quaternion(axes).normalized();
    motion.position_W = point + vehicle.params.height * n;
    motion.velocity_W = start.speed * axes.col(0);
    return motion;
}

VehicleState resting(const Vehicle& vehicle, const Start& start) {
    VehicleState state;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreCoefficients& p = vehicle.corners[i].tyre.parameters;
        WheelState& wheel = state.wheels[i];
        wheel.spin = start.speed / p.Re;
        wheel.motion.Vx = start.speed;
        wheel.motion.Fz = vehicle.corners[i].static_force;
        wheel.suspension_force = wheel.load = wheel.vertical_force = vehicle.corners[i].static_force;
    }
    return state;
}

double largest(const std::array<double, 3>& a) {
    return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

double meanDrivenSpin(const VehicleState& state, double front_share) {
    const auto& w = state.wheels;
    return 0.5 * (front_share * (w[0].spin + w[1].spin) + (1 - front_share) * (w[2].spin + w[3].spin));
}

}  // namespace

Equilibrium equilibrium(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start) {
    const ChassisMotion place = placed(vehicle, surroundings, start);
    const bool rolls = start.speed != 0;
    const double front_share = vehicle.params.driveline.front_share;
    const double inertia_torque = vehicle.params.mass * vehicle.corners[0].tyre.parameters.Re;
    const Vector3 forward = place.orientation * Vector3::UnitX();

    Equilibrium result{.motion = place, .state = resting(vehicle, start), .input = start.input};
    VehicleState& state = result.state;
    double torque = 0;
    double quiet = 0;
    for (double t = 0; t < kLongest && quiet < kQuietTime; t += kStep) {
        // Driveline in steady running at the torque sought.
        const SteadyDriveline steady =
            steadyDriveline(vehicle.params.driveline, meanDrivenSpin(state, front_share), rolls ? torque : 0);
        state.driveline = steady.state;
        result.throttle = steady.throttle;
        if (rolls) result.input.throttle = std::clamp(steady.throttle, 0.0, 1.0);
        advance(result.motion, state, vehicle, result.input, result.input, surroundings, kStep);

        // Hold the place; a rolling car also its speed and heading. Damp what is left.
        ChassisMotion& motion = result.motion;
        const double damped = 1 - kBodyDamping * kStep;
        Vector3 left_over = motion.velocity_W - place.velocity_W;
        Vector3 turning = motion.angular_velocity_W;
        std::array<double, 3> acceleration = state.acceleration_W;
        if (rolls) {
            const Vector3 n = place.orientation * Vector3::UnitZ();
            const Vector3 a(acceleration[0], acceleration[1], acceleration[2]);
            torque -= kTorqueGain * kStep * inertia_torque * a.dot(forward);
            left_over = left_over.dot(n) * n;
            turning -= turning.dot(n) * n;
            motion.position_W = place.position_W + (motion.position_W - place.position_W).dot(n) * n;
        }
        motion.velocity_W = place.velocity_W + damped * left_over;
        motion.angular_velocity_W = damped * turning;
        result.acceleration = std::max(largest(state.acceleration_W), largest(state.angular_acceleration_W));
        quiet = result.acceleration < kQuiet ? quiet + kStep : 0;
    }

    // Rest at last: what the settling left is below what matters.
    result.motion.velocity_W = place.velocity_W;
    result.motion.angular_velocity_W.setZero();
    return result;
}

}  // namespace tread
