#include "vehicle/tyre_conditions.h"

#include <algorithm>

namespace tread {
namespace {

// Power that the contact patch loses to the road: its force times its slip velocity, which is that of the rim and its
// own against the rim.
double slipPower(const WheelState& wheel, double rolling_radius) {
    const double Vsx = wheel.motion.Vx - rolling_radius * wheel.spin + wheel.tyre.du;
    const double Vsy = wheel.motion.Vsy + wheel.tyre.dv;
    return std::max(-wheel.fx * Vsx + wheel.fy * Vsy, 0.0);  // fy counts to the left, Vsy to the right
}

}  // namespace

void shiftMotions(PerWheel<TyreMotion>& begin, PerWheel<TyreMotion>& end, const Vehicle& vehicle) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreShift& shift = vehicle.corners[i].tyre_shift;
        begin[i] = shifted(begin[i], shift);
        end[i] = shifted(end[i], shift);
    }
}

void applyWarmth(PerWheel<TyreFactors>& factors, const PerWheel<WheelState>& wheels, const Vehicle& vehicle) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreWarmth now = warmth(vehicle.corners[i].temperature, wheels[i].warming);
        factors[i].friction *= now.friction;
        factors[i].stiffness *= now.stiffness;
    }
}

void warmTyres(PerWheel<WheelState>& wheels, const Vehicle& vehicle, double dt) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        WheelState& wheel = wheels[i];
        const double power = slipPower(wheel, corner.tyre.parameters.Re);
        wheel.warming = advanceWarming(wheel.warming, corner.temperature, power, wheel.motion.Vx, dt);
    }
}

}  // namespace tread
