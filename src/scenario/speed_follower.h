// Inverse dynamics of the longitudinal motion: the force that lets a car follow a speed over time.
//
// The force accelerates the car's mass as the speed asks, and overcomes the resistances (air, rolling, cornering,
// slope), which are observed as what the force of the last steps did not turn into acceleration. A small share corrects
// the speed itself. Method: disturbance observer (Ohnishi, Shibata & Murakami, IEEE/ASME Trans. Mechatronics 1, 1996).
#pragma once

#include "scenario/closed_loop.h"

namespace tread {

// What the driver knows of the car who follows a speed.
struct KnownResistance {
    double mass = 1500;  // kg, with that of the turning wheels: inertia over the square of the radius
    double force = 0;    // N, that holds the speed at the start
};

class SpeedFollower {
public:
    explicit SpeedFollower(const KnownResistance& car) : car_(car), resistance_(car.force / car.mass) {}

    // The force at the end of the coming step of dt, N. The car has `speed` at the beginning of that step, and
    // `elapsed` seconds of the phase have passed at its end. Called once for each step that is followed, and expected
    // to be obeyed (D5a).
    double force(const FollowSpeed& follow, double speed, double elapsed, double dt);

    // The coming step is not followed.
    void pause() { step_ = 0; }

private:
    void observe(double speed);

    KnownResistance car_;
    double resistance_;        // m/s2, deceleration of the car that no force drives
    double step_ = 0;          // s, the last step; 0 if it was not followed
    double speed_ = 0;         // m/s, at its beginning
    double force_before_ = 0;  // N, then
    double force_ = 0;         // N, at its end
    bool holds_ = false;       // a standing car: what its brakes do not need tells nothing
};

}  // namespace tread
