#include "vehicle/tyre_conditions.h"

#include "vehicle/tyre_grip.h"

namespace tread {
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
        const double rolling_speed = corner.tyre.parameters.Re * wheel.spin;
        const double power = slipPower(wheel.motion, wheel.tyre, rolling_speed, wheel.fx, wheel.fy);
        wheel.warming = advanceWarming(wheel.warming, corner.temperature, power, wheel.motion.Vx, dt);
    }
}

}  // namespace tread
