// A steady turn at a small lateral acceleration, about the standing car: the linear model of handling. Wheel loads,
// roll, compliance of suspension and steering and the tyres' formulas are in it; drive, drag and speed are not.
#pragma once

#include "sheet/at_rest.h"

namespace tread::sheet {

// Both tyres of an axle together.
struct AxleStiffness {
    double tyres;            // N/rad, cornering stiffness at static load
    double with_compliance;  // N/rad, of the force over the slip angle that the axle has with what yields
};
PerAxle<AxleStiffness> axleStiffness(const AtRest& rest);

// Slopes over lateral acceleration, in a turn to the left.
struct TurnSlopes {
    PerAxle<double> slip;  // rad s2/m, angle between an axle and its path: slip, roll steer and compliance together
    double roll;           // rad s2/m, outwards
    PerAxle<double> difference;  // N s2/m, load of the outer less that of the inner wheel
};
TurnSlopes turnSlopes(const AtRest& rest);

// The single-track model with axles that have these angles in a steady turn.
struct SingleTrack {
    double mass, inertia;              // kg, kg m2
    double front_distance, wheelbase;  // m
    PerAxle<double> stiffness;         // N/rad, effective: static load over gravity and slope of the axle's angle

    double understeer() const;                // rad s2/m
    double staticMargin() const;              // -, of the wheelbase, positive when the car understeers
    double characteristicSpeed() const;       // m/s; NaN when the car does not understeer
    double criticalSpeed() const;             // m/s; NaN when it does not oversteer
    double yawFrequency(double speed) const;  // Hz, undamped; NaN above the critical speed
    double yawDamping(double speed) const;    // -, ratio
};
SingleTrack singleTrack(const AtRest& rest, const TurnSlopes& turn);

// The yaw mode of the same model whose side forces follow their angles over the relaxation length of the tyres; NaN
// when it does not oscillate.
struct YawMode {
    double frequency;  // Hz, undamped
    double damping;    // -, ratio
};
YawMode yawModeWithLag(const AtRest& rest, const SingleTrack& track, double speed);

}  // namespace tread::sheet
