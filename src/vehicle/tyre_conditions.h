// What the surroundings of the tyres make of their step: ply-steer and conicity, temperature.
#pragma once

#include "tread/vehicle.h"
#include "tyre/four_tyres.h"
#include "vehicle/tyre_grip.h"

namespace tread {

// Ply-steer and conicity, in the motions that the tyres' formulas are given.
void shiftMotions(PerWheel<TyreMotion>& begin, PerWheel<TyreMotion>& end, const Vehicle& vehicle);

// Factors of the tyres at their temperatures.
void applyWarmth(PerWheel<TyreFactors>& factors, const PerWheel<WheelState>& wheels, const Vehicle& vehicle);

inline namespace TREAD_ISA {

// As advanceWarming() in tyre_surroundings.h.
template <class T>
T warmed(const T& warming, const BasicTyreTemperatureParams<T>& params, const T& slip_power, const T& speed,
         double dt) {
    // Trapezoidal rule: heat lost with the mean temperature of the step.
    const T loss = params.cooling + params.cooling_by_speed * magnitude(speed);
    const T over_air = params.start + warming - params.air;
    const T change = dt * (params.slip_share * slip_power - loss * over_air) / (params.heat_capacity + 0.5 * dt * loss);
    return select(params.heat_capacity == T(0), warming, T(warming + change));
}

// Heats the tyres by the power of their slip at the end of the step, and cools them. T is double, or lanes of which
// each holds another car.
template <class T, class Car>
void warmTyres(PerWheel<BasicWheelState<T>>& wheels, const Car& vehicle, double dt) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& corner = vehicle.corners[i];
        BasicWheelState<T>& wheel = wheels[i];
        const T rolling_speed = corner.tyre.parameters.Re * wheel.spin;
        const T power = slipPower(wheel.motion, wheel.tyre, rolling_speed, wheel.fx, wheel.fy);
        wheel.warming = warmed(wheel.warming, corner.temperature, power, wheel.motion.Vx, dt);
    }
}

}  // namespace TREAD_ISA
}  // namespace tread
