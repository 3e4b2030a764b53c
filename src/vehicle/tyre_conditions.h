// What the surroundings of the tyres make of their step: ply-steer and conicity, temperature. T is double, or lanes of
// which each holds another car.
#pragma once

#include "tread/vehicle.h"
#include "tyre/four_tyres.h"
#include "vehicle/tyre_grip.h"
#include "vehicle/tyre_load.h"

namespace tread {

inline namespace TREAD_ISA {

// Ply-steer and conicity, in the motions that the tyres' formulas are given.
template <class T, class Car>
void shiftMotions(PerWheel<BasicTyreMotion<T>>& begin, PerWheel<BasicTyreMotion<T>>& end, const Car& vehicle) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& shift = vehicle.corners[i].tyre_shift;
        for (BasicTyreMotion<T>* motion : {&begin[i], &end[i]}) {
            motion->Vsy += shift.slip * motion->Vx;
            motion->gamma += shift.camber;
        }
    }
}

// However hot or cold, this much of the tyre is left: the polynomials mean nothing far from where they were measured.
inline constexpr double kLeastOfTyre = 0.1;

// Factors of a tyre at its temperature, as warmth() in tyre_surroundings.h.
template <class T>
BasicTyreFactors<T> warmthOf(const BasicTyreTemperatureParams<T>& params, const T& warming) {
    const T over = params.start + warming - params.nominal;
    return {.friction = larger(T(1 + (params.friction + params.friction_squared * over) * over), T(kLeastOfTyre)),
            .stiffness = larger(T(1 + params.stiffness * over), T(kLeastOfTyre))};
}

template <class T, class Car>
void applyWarmth(PerWheel<BasicTyreFactors<T>>& factors, const PerWheel<BasicWheelState<T>>& wheels,
                 const Car& vehicle) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const BasicTyreFactors<T> now = warmthOf(vehicle.corners[i].temperature, wheels[i].warming);
        factors[i].friction *= now.friction;
        factors[i].stiffness *= now.stiffness;
    }
}

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

// Heats the tyres by the power of their slip at the end of the step, and cools them.
template <class T, class Car>
void warmTyres(PerWheel<BasicWheelState<T>>& wheels, const Car& vehicle, double dt) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& corner = vehicle.corners[i];
        BasicWheelState<T>& wheel = wheels[i];
        const T rolling_speed = rollingRadius(corner.tyre, wheel.motion.Fz) * wheel.spin;
        const T power = slipPower(wheel.motion, wheel.tyre, rolling_speed, wheel.fx, wheel.fy);
        wheel.warming = warmed(wheel.warming, corner.temperature, power, wheel.motion.Vx, dt);
    }
}

}  // namespace TREAD_ISA
}  // namespace tread
