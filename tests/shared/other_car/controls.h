// From steering wheel and brake pedal to the steering gear and the brakes of the other car: first-order lags and, in
// some structures, an oscillating steering column and a slow rear brake circuit.
#pragma once

#include "shared/other_car/params.h"
#include "shared/other_car/state.h"

namespace other_car {

inline constexpr double kLeastLag = 0.001;  // s; shorter lags are ignored: they are faster than the integration step

inline double steeringWheelAfterLag(const Params& p, const Vector& s, const Input& input) {
    return p.steering_lag > kLeastLag ? s[kSteer] : input.steering_wheel;
}

inline double pedalAfterLag(const Params& p, const Vector& s, const Input& input) {
    return p.brake_lag > kLeastLag ? s[kBrake] : input.brake;
}

inline double brakeTorque(const Params& p, bool front, const Vector& s, const Input& input) {  // N m, of an axle
    const double pedal = p.structure.slow_rear_brakes && !front ? s[kRearBrake] : pedalAfterLag(p, s, input);
    return (front ? p.brake_front_share : 1 - p.brake_front_share) * pedal * p.brake_torque;
}

inline void setControlRates(const Params& p, const Vector& s, const Input& input, Vector& rate) {
    rate[kSteer] = p.steering_lag > kLeastLag ? (input.steering_wheel - s[kSteer]) / p.steering_lag : 0;
    rate[kBrake] = p.brake_lag > kLeastLag ? (input.brake - s[kBrake]) / p.brake_lag : 0;
    rate[kRearBrake] = (pedalAfterLag(p, s, input) - s[kRearBrake]) / kRearBrakeLag;
    rate[kBoost] = (input.throttle - s[kBoost]) / kTurboTime;
    rate[kColumn] = s[kColumnRate];
    rate[kColumnRate] = kColumnFrequency * (kColumnFrequency * (steeringWheelAfterLag(p, s, input) - s[kColumn]) -
                                            2 * kColumnDamping * s[kColumnRate]);
}

}  // namespace other_car
