// Another car simulator: a double-track model that shares no code with tread, for cases in which the model of the
// diagnosis differs in structure from the car.
//
// After R. Rajamani, Vehicle Dynamics and Control, 2nd ed. (2012), chapters 2, 4, 13 and 15, and M. Mitschke, H.
// Wallentowitz, Dynamik der Kraftfahrzeuge, 4th ed. (2004): a rigid body that moves in the plane, pitches, and rolls
// about an axis fixed in it; four spinning wheels whose slip relaxes; load transfer by springs and links. Left out:
// heave, vertical wheel motion, twist of the shafts, tyre moments other than that of the trail. Plane road, steady
// wind. Optional differences in structure: structure.h. ISO 8855 axes. Classical fourth-order Runge-Kutta.
#pragma once

#include <algorithm>
#include <array>

#include "shared/other_car/wheels.h"

namespace other_car {

class Car {
public:
    Car(const Params& params, double speed) : p_(params) {
        s_[kVx] = speed;
        for (std::size_t i = 0; i < 4; ++i) s_[kSpin + i] = speed / tyre_[i].rolling_radius;
        s_[kBoost] = holdingThrottle();
        forces_ = last_ = settled({.throttle = s_[kBoost]});
    }

    double holdingThrottle() const { return other_car::holdingThrottle(p_, s_); }

    // Loads depend on accelerations and these on the loads. Each stage iterates once, from the result of the previous
    // stage extrapolated by the change over the previous step.
    void step(const Input& begin, const Input& end, double dt) {
        const Input middle{0.5 * (begin.steering_wheel + end.steering_wheel), 0.5 * (begin.throttle + end.throttle),
                           0.5 * (begin.brake + end.brake)};
        const Vector a = ratesAt(s_, begin);
        const Forces now = forces_;
        extrapolateHalfStep(now);
        const Vector b = ratesAt(moved(a, dt / 2), middle);
        const Vector c = ratesAt(moved(b, dt / 2), middle);
        extrapolateHalfStep(now);
        const Vector d = ratesAt(moved(c, dt), end);
        for (std::size_t i = 0; i < kStates; ++i) s_[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        last_ = now;
    }

    // Held during the following steps.
    void push(const Push& push) { push_ = push; }

    const Vector& state() const { return s_; }
    // Roll angle of the body against the horizon, rad.
    double roll() const { return s_[kRoll] + slope(p_, s_).y; }
    // Pitch angle of the body against the horizon, rad, positive nose down.
    double pitch() const { return s_[kPitch] - slope(p_, s_).x; }
    Forces forces(const Input& input) const { return settled(input); }
    // Forces of the last stage of the last step.
    const Forces& lastForces() const { return forces_; }
    double engineSpeed() const { return other_car::engineSpeed(p_, s_); }
    double engineTorque(const Input& input) const { return other_car::engineTorque(p_, s_, input); }

private:
    Vector moved(const Vector& rate, double dt) const {
        Vector next = s_;
        for (std::size_t i = 0; i < kStates; ++i) next[i] += dt * rate[i];
        return next;
    }

    const Vector& ratesAt(const Vector& s, const Input& input) {
        iterate(s, input, forces_);
        return forces_.rate;
    }

    void extrapolateHalfStep(const Forces& now) {
        forces_.felt_ay += 0.5 * (now.felt_ay - last_.felt_ay);
        for (std::size_t i = 0; i < 4; ++i) forces_.fy[i] += 0.5 * (now.fy[i] - last_.fy[i]);
    }

    // Loads from the accelerations in `f`, then forces and accelerations at these loads.
    void iterate(const Vector& s, const Input& input, Forces& f) const {
        setLoads(p_, s, input, f);
        const PlaneForce wind = airForce(p_, s);
        PlaneForce sum{push_.fx + wind.x, push_.fy + wind.y, push_.yaw + wind.moment};
        setControlRates(p_, s, input, f.rate);
        for (std::size_t i = 0; i < 4; ++i) addWheel(p_, tyre_[i], body_.arm, i, s, input, f, sum);
        setBodyRates(p_, body_, push_, sum, s, input, f);
    }

    // Three iterations from zero converge to 1e-4.
    Forces settled(const Input& input) const {
        Forces f{};
        for (int round = 0; round < 3; ++round) iterate(s_, input, f);
        return f;
    }

    Params p_;
    Body body_ = bodyOf(p_);
    WheelTyres tyre_ = tyresOf(p_);
    Forces forces_{}, last_{};  // of the last stage; at the beginning of the last step
    Vector s_{};
    Push push_;
};

}  // namespace other_car
