// What the step reads of the cars in lanes, in place of `Vehicle`: nothing but numbers, each for all lanes. The names
// are those of vehicle.h and suspension.h, so that one source (step.h) reads both.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/vectors.h"

namespace tread {
inline namespace TREAD_ISA {

// The suspension without what has curves.
template <class T>
struct LaneSuspension {
    T spring;
    struct {
        T bump, rebound, friction;
    } damper;
    T anti_roll_bar;
    BasicStopParams<T> bump_stop, rebound_stop;
    T side_view_slope_braking, side_view_slope_driving;
    T camber, camber_by_travel, toe, toe_by_travel;
    T steer_by_lateral_force, steer_by_aligning_moment, steer_by_longitudinal_force, camber_by_lateral_force;
};

template <class T>
struct LaneCorner {
    LaneVector<T> hub_B;
    T static_force, lateral_slope, unsprung_mass, wheel_inertia;
    struct {
        BasicTyreCoefficients<T> parameters;
        BasicTyreScaling<T> lambda;
    } tyre;
    struct {
        T slip, camber;
    } tyre_shift;
    BasicTyreTemperatureParams<T> temperature;
    T aligning_stiffness;
};

template <class T>
struct LaneNumbers {
    struct {
        T mass;
        BasicInertiaParams<T> inertia;
        struct {
            LaneSuspension<T> suspension;
        } front, rear;
    } params;
    PerWheel<LaneCorner<T>> corners;
    struct {
        T element[6][6];
        TREAD_INLINE const T& operator()(int i, int k) const { return element[i][k]; }
    } inverse_mass;
};

inline constexpr std::size_t kLaneNumbers = sizeof(LaneNumbers<double>) / sizeof(double);

}  // namespace TREAD_ISA
}  // namespace tread
