#include "tread/engine.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

constexpr double kIdleControl = 2.0;  // N m per rad/s away from idle speed
constexpr double kIdleTorque = 60;    // N m, most that the idle control gives
constexpr double kNoTorque = 1e-6;    // N m, rounding of a torque

double idleControl(const EngineParams& engine, double speed) {
    return std::min(kIdleControl * (engine.idle_speed - speed), kIdleTorque);
}

double scaled(const EngineParams& engine, double torque) {
    return torque * (torque > 0 ? engine.torque_scale : engine.drag_scale);
}

// One stretch of the torque over the throttle.
struct Stretch {
    double from, to;                // throttle
    double torque_from, torque_to;  // N m
};

// The stretch of the map at a speed on which `fits(end of the stretch)` is first true; the last one if none is.
template <class Fits>
Stretch stretchWhere(const EngineParams& engine, double speed, Fits&& fits) {
    Stretch s{0, 1, scaled(engine, -engine.drag(speed)), scaled(engine, engine.full_load(speed))};
    for (const PartLoadParams& row : engine.part_load) {
        const double torque = scaled(engine, row.torque(speed));
        if (fits(row.throttle, torque)) return {s.from, row.throttle, s.torque_from, torque};
        s.from = row.throttle;
        s.torque_from = torque;
    }
    return s;
}

}  // namespace

double engineTorque(const EngineParams& engine, double throttle, double speed) {
    if (speed >= engine.speed_limit) return scaled(engine, -engine.drag(speed));
    const Stretch s = stretchWhere(engine, speed, [&](double end, double) { return throttle <= end; });
    const double share = (throttle - s.from) / (s.to - s.from);
    return std::max(share * (s.torque_to - s.torque_from) + s.torque_from, idleControl(engine, speed));
}

double throttleFor(const EngineParams& engine, double torque, double speed) {
    const auto invert = [&](double wanted) {
        const Stretch s = stretchWhere(engine, speed, [&](double, double end) { return wanted <= end; });
        const double rise = s.torque_to - s.torque_from;
        return rise > 0 ? s.from + (s.to - s.from) * (wanted - s.torque_from) / rise : 0;
    };
    const double idle = idleControl(engine, speed);
    return torque < idle + kNoTorque ? std::min(invert(torque) - invert(idle), 0.0) : invert(torque);
}

}  // namespace tread
