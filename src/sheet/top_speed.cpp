#include "sheet/top_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/channels.h"
#include "vehicle/driveline/coupling.h"
#include "vehicle/driveline/gearbox.h"
#include "vehicle/tyre_load.h"

namespace tread::sheet {
namespace {

constexpr int kBisections = 50;
constexpr int kSpeeds = 400;        // between standstill and the speed limit of a gear
constexpr double kAtLimit = 0.995;  // of the speed limit of engine or motor

// The wheels at a speed.
struct Rolling {
    double spin;        // rad/s, mean of those that are driven, as the gearbox feels it
    double torque;      // N m, that holds the speed, all wheels together
    double resistance;  // N, of drag and rolling
};

double driveShare(const VehicleParams& car, std::size_t axle) {
    return axle == 0 ? car.driveline.front_share : 1 - car.driveline.front_share;
}

// A wheel under the load that the air leaves it.
struct Loaded {
    double load;        // N
    double radius;      // m
    double resistance;  // N m, of rolling and of a brake that drags, when it turns freely
    double stiffness;   // N, slip stiffness
};

Loaded loadedAt(const AtRest& rest, std::size_t wheel, const AeroForces& air, double speed) {
    const double lift = 0.5 * (axleOf(wheel) == 0 ? air.front_lift : air.rear_lift);
    const double load = std::max(rest.load[wheel] - lift, 0.0);
    const TyreParams& tyre = rest.tyre[wheel];
    const TyreSteadyState free = steadyState(tyre, {.Fz = load, .gamma = 0, .Vx = speed, .Vsx = 0, .Vsy = 0});
    return {load, rest.radius[wheel] + (rest.load[wheel] - load) / radialStiffness(tyre),
            std::abs(free.My) + rest.vehicle.corners[wheel].brake_drag, free.Kx};
}

// The driven wheels slip under the force that they drive with: drag, and the resistance of the wheels that roll along.
Rolling rollingAt(const AtRest& rest, double speed) {
    const AeroForces air = forces(rest.car().aero, {speed, 0, 0});
    const double drag = -air.drag_B.x();
    PerWheel<Loaded> wheels;
    double force = drag;
    Rolling rolling{0, 0, drag};
    for (std::size_t i = 0; i < kWheels; ++i) {
        wheels[i] = loadedAt(rest, i, air, speed);
        const double own = wheels[i].resistance / wheels[i].radius;
        rolling.resistance += own;
        if (driveShare(rest.car(), axleOf(i)) == 0) force += own;
    }
    for (std::size_t i = 0; i < kWheels; ++i) {
        const double share = 0.5 * driveShare(rest.car(), axleOf(i));
        if (share == 0) continue;
        rolling.spin += share * speed * (1 + share * force / wheels[i].stiffness) / rest.tyre[i].parameters.Re;
        rolling.torque += wheels[i].resistance + share * force * wheels[i].radius;
    }
    return rolling;
}

double ratioOf(const AtRest& rest, int gear) {
    return totalRatio(rest.car().driveline.gearbox, gear);
}

double speedLimitOf(const DrivelineParams& d) {
    double limit = std::numeric_limits<double>::infinity();
    if (d.engine) limit = std::min(limit, d.engine->speed_limit);
    if (d.motor) limit = std::min(limit, d.motor->speed_limit);
    return limit;
}

// Whether full throttle holds a speed in a gear.
bool holds(const AtRest& rest, int gear, double speed) {
    const DrivelineParams& d = rest.car().driveline;
    const Rolling rolling = rollingAt(rest, speed);
    const double ratio = ratioOf(rest, gear), gearbox_speed = rolling.spin * ratio;
    double needed = rolling.torque / (ratio * d.gearbox.efficiency);
    if (d.motor) needed -= motorTorque(*d.motor, 1, 0, gearbox_speed).total;
    if (!d.engine) return needed <= 0;
    const SteadyCoupling link = steadyCoupling(d, gearbox_speed, gear, needed, false);
    return link.engine_torque <= engineTorque(*d.engine, 1, link.engine_speed);
}

// Speed at which the gearbox turns at `limit` in a gear.
double speedAt(const AtRest& rest, int gear, double limit) {
    double low = 0, high = 2 * limit / ratioOf(rest, gear) * rest.tyre[0].parameters.Ro;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (low + high);
        (rollingAt(rest, middle).spin * ratioOf(rest, gear) > limit ? high : low) = middle;
    }
    return low;
}

// Speed that full throttle comes to in a gear, from a speed at which it came in, below `highest`.
double settledSpeed(const AtRest& rest, int gear, double from, double highest) {
    const double step = highest / kSpeeds;
    const bool faster = holds(rest, gear, from);
    double held = from, not_held = from;
    if (faster) {
        while (not_held < highest && holds(rest, gear, not_held))
            not_held = std::min((held = not_held) + step, highest);
        if (holds(rest, gear, not_held)) return highest;
    } else {
        while (held > step && !holds(rest, gear, held)) held = (not_held = held) - step;
        if (!holds(rest, gear, held)) return 0;
    }
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (held + not_held);
        (holds(rest, gear, middle) ? held : not_held) = middle;
    }
    return held;
}

}  // namespace

double resistancePower(const AtRest& rest, double speed) {
    return rollingAt(rest, speed).resistance * speed;
}

TopSpeed topSpeed(const AtRest& rest) {
    const DrivelineParams& d = rest.car().driveline;
    const GearboxParams& gearbox = d.gearbox;
    const double limit = speedLimitOf(d);
    const double up = gearbox.shift_up_speed * gearbox.shift_up_share(1);
    const double down = gearbox.shift_down_speed * gearbox.shift_down_share(1);
    const auto reached = [&](double speed, int gear, SpeedLimit by) {
        return TopSpeed{speed, gear, by, resistancePower(rest, speed)};
    };
    // As the gearbox does it: up from the first gear, until a gear comes to a speed at which it stays.
    double speed = 0.1 * speedAt(rest, 1, limit);
    for (int gear = 1;; ++gear) {
        const bool last = gear == gears(gearbox);
        const double fastest = speedAt(rest, gear, last ? limit : std::min(up, limit));
        const double settled = settledSpeed(rest, gear, std::min(speed, fastest), fastest);
        if (settled == 0) return {kUndefined, gear, SpeedLimit::power, kUndefined};
        const double turns = rollingAt(rest, settled).spin * ratioOf(rest, gear);
        if (gear > 1 && turns < down) return reached(speed, gear - 1, SpeedLimit::shift);
        if (last || up >= limit || settled < kAtLimit * fastest)
            return reached(settled, gear, turns > kAtLimit * limit ? SpeedLimit::gearing : SpeedLimit::power);
        speed = settled;
    }
}

}  // namespace tread::sheet
