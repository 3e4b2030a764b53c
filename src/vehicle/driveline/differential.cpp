#include "vehicle/driveline/differential.h"

#include <algorithm>
#include <cmath>

#include "vehicle/driveline/link.h"

namespace tread {
namespace {

// Two outputs of a differential as they would be at the end of the step, and what goes through it.
struct Outputs {
    double slip;          // rad/s, first less second
    double per_torque;    // by how much a moved torque lowers it
    double torque;        // N m, through the differential
    double speed;         // rad/s, of its cage
    double outward_pull;  // m/s2, lateral acceleration: positive when the second output is the outer wheel
};

// Torque moved from the first to the second output. What is described is the difference of torques: twice that.
double moved(const OpenDifferential& d, const Outputs& out) {
    return linkTorque(out.slip, out.per_torque, 0.5 * d.locking * std::abs(out.torque), 0);
}
double moved(const LockedDifferential&, const Outputs& out) {
    return linkTorque(out.slip, out.per_torque, kInfinity, 0);
}
double moved(const LimitedSlipDifferential& d, const Outputs& out) {
    const double locking = out.torque * out.speed >= 0 ? d.locking_driving : d.locking_coasting;
    const double capacity = 0.5 * (d.preload + locking * std::abs(out.torque));
    return linkTorque(out.slip, out.per_torque, capacity, 0.5 * d.viscosity);
}
double moved(const VectoringDifferential& d, const Outputs& out) {
    return 0.5 * std::clamp(d.by_lateral_acceleration * out.outward_pull, -d.largest, d.largest);
}

bool open(const auto& differential) {
    const auto* kind = std::get_if<OpenDifferential>(&differential);
    return kind && kind->locking == 0;
}

double movedBy(const auto& differential, const Outputs& out) {
    return std::visit([&](const auto& kind) { return moved(kind, out); }, differential);
}

}  // namespace

PerWheel<double> sharedTorque(const DrivelineParams& params, const DrivelineInput& in, double torque, double dt) {
    const double front = 0.5 * params.front_share * torque, rear = 0.5 * (1 - params.front_share) * torque;
    PerWheel<double> wheel{front, front, rear, rear};
    const auto speed = [&](std::size_t i) {
        return in.wheel_spin[i] + dt * (wheel[i] + in.wheel_load[i]) / in.wheel_inertia[i];
    };
    const auto yields = [&](std::size_t i) { return dt / in.wheel_inertia[i]; };

    // Between the axles: each takes its torque half and half at its wheels.
    if (!open(params.centre_differential)) {
        const double front_speed = 0.5 * (speed(0) + speed(1)), rear_speed = 0.5 * (speed(2) + speed(3));
        const double per_torque = 0.25 * (yields(0) + yields(1) + yields(2) + yields(3));
        const double half = 0.5 * movedBy(params.centre_differential,
                                          {front_speed - rear_speed, per_torque, torque, front_speed + rear_speed, 0});
        wheel.front_left -= half;
        wheel.front_right -= half;
        wheel.rear_left += half;
        wheel.rear_right += half;
    }
    // Between the wheels of an axle.
    const auto couple = [&](const AxleDifferential& differential, std::size_t left, std::size_t right) {
        if (open(differential)) return;
        const double move =
            movedBy(differential, {speed(left) - speed(right), yields(left) + yields(right), wheel[left] + wheel[right],
                                   speed(left) + speed(right), in.lateral_acceleration});
        wheel[left] -= move;
        wheel[right] += move;
    };
    couple(params.front_differential, 0, 1);
    couple(params.rear_differential, 2, 3);
    return wheel;
}

}  // namespace tread
