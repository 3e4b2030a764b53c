#include "vehicle/driveline/coupling.h"

#include <algorithm>
#include <cmath>

#include "vehicle/driveline/link.h"

namespace tread {
namespace {

// The clutch closes with engine speed: open at idle, closed well above.
constexpr double kClutchOpens = 1.05;   // times idle speed
constexpr double kClutchCloses = 1.50;  // times idle speed
// A converter's capacity falls to none at equal speeds: its slope there is taken at this relative slip.
constexpr double kLeastSlip = 1e-3;

// ---- Clutch ----

double capacityOf(const ClutchParams& clutch, double idle, double engine_speed) {
    const double closed = (engine_speed / idle - kClutchOpens) / (kClutchCloses - kClutchOpens);
    return clutch.torque * std::clamp(closed, 0.0, 1.0);
}

CouplingTorques coupledBy(const ClutchParams& clutch, const DrivelineParams& params, const DrivelineState& state,
                          const CouplingInput& in) {
    const double capacity = capacityOf(clutch, params.engine->idle_speed, state.engine_speed) * in.closed;
    const double torque =
        linkTorque(in.engine_speed - in.gearbox_speed, in.engine_per_torque + in.gearbox_per_torque, capacity, 0);
    return {torque, torque};
}

SteadyCoupling steadyBy(const ClutchParams& clutch, double idle, double gearbox_speed, int, double torque, bool) {
    // Locked where it can be; else the engine turns as fast as closes the clutch far enough.
    const double locked = std::max(gearbox_speed, idle);
    if (torque <= capacityOf(clutch, idle, locked)) return {locked, torque, torque};
    const double closed = std::min(torque / clutch.torque, 1.0);
    return {idle * (kClutchOpens + closed * (kClutchCloses - kClutchOpens)), torque, torque};
}

// ---- Torque converter ----

struct Converter {
    double conductance;   // N m s/rad: pump torque over slip
    double torque_ratio;  // turbine over pump
    double lock_up;       // N m, that the lock-up clutch holds
};

Converter converterAt(const TorqueConverterParams& converter, double pump, double turbine, int gear) {
    const bool driving = pump >= turbine;
    const double faster = std::max(driving ? pump : turbine, 0.0), slower = std::max(driving ? turbine : pump, 0.0);
    if (faster == 0) return {0, 1, 0};
    const double ratio = std::min(slower / faster, 1 - kLeastSlip);
    Converter c;
    c.conductance = converter.capacity(ratio) * faster / (1 - ratio);
    c.torque_ratio = driving ? converter.torque_ratio(ratio) : 1;
    const double closing = (slower / faster - converter.lock_up_speed_ratio) / (1 - converter.lock_up_speed_ratio);
    c.lock_up = gear >= converter.lock_up_gear ? converter.lock_up_torque * std::clamp(closing, 0.0, 1.0) : 0;
    return c;
}

CouplingTorques coupledBy(const TorqueConverterParams& converter, const DrivelineParams&, const DrivelineState& state,
                          const CouplingInput& in) {
    const Converter c = converterAt(converter, state.engine_speed, state.gearbox_speed, state.gear);
    const double slip = in.engine_speed - in.gearbox_speed;
    const double both = in.engine_per_torque + in.gearbox_per_torque;
    const double lock_up = linkTorque(slip, both, c.lock_up * in.closed, 0);
    const double left = slip - both * lock_up;
    const double conductance = c.conductance * in.closed;
    const double pump =
        conductance * left / (1 + conductance * (in.engine_per_torque + c.torque_ratio * in.gearbox_per_torque));
    return {pump + lock_up, c.torque_ratio * pump + lock_up};
}

CouplingTorques steadyAt(const TorqueConverterParams& converter, double engine_speed, double gearbox_speed, int gear) {
    const Converter c = converterAt(converter, engine_speed, gearbox_speed, gear);
    const double pump = c.conductance * (engine_speed - gearbox_speed);
    return {pump, c.torque_ratio * pump};
}

// Root of a rising function.
template <class Function>
double bisect(double low, double high, Function&& f) {
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) > 0 ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

SteadyCoupling steadyBy(const TorqueConverterParams& converter, const EngineParams& engine, double gearbox_speed,
                        int gear, double torque, bool standing) {
    const auto torques = [&](double speed) { return steadyAt(converter, speed, gearbox_speed, gear); };
    if (standing) {
        // The idle control against the creeping converter.
        const double speed =
            bisect(0, engine.idle_speed, [&](double at) { return torques(at).engine - engineTorque(engine, 0, at); });
        return {speed, torques(speed).engine, torques(speed).gearbox};
    }
    const Converter locked = converterAt(converter, gearbox_speed, gearbox_speed, gear);
    if (locked.lock_up > std::abs(torque) && gearbox_speed > engine.idle_speed) return {gearbox_speed, torque, torque};
    const double low = torque > 0 ? std::max(gearbox_speed, 0.0) : 0;
    const double high = torque > 0 ? 2 * engine.speed_limit : gearbox_speed;
    const double speed = bisect(low, high, [&](double at) { return torques(at).gearbox - torque; });
    return {speed, torques(speed).engine, torque};
}

}  // namespace

CouplingTorques coupled(const DrivelineParams& params, const DrivelineState& state, const CouplingInput& input) {
    return std::visit([&](const auto& coupling) { return coupledBy(coupling, params, state, input); }, params.coupling);
}

SteadyCoupling steadyCoupling(const DrivelineParams& params, double gearbox_speed, int gear, double gearbox_torque,
                              bool standing) {
    if (const auto* clutch = std::get_if<ClutchParams>(&params.coupling))
        return steadyBy(*clutch, params.engine->idle_speed, gearbox_speed, gear, gearbox_torque, standing);
    return steadyBy(std::get<TorqueConverterParams>(params.coupling), *params.engine, gearbox_speed, gear,
                    gearbox_torque, standing);
}

}  // namespace tread
