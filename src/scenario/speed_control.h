// Feet of a driver who holds a speed.
#pragma once

#include "scenario/closed_loop.h"

namespace tread {

class SpeedControl {
public:
    // A phase begins, at this speed and with the throttle so.
    void begin(double speed, double throttle);

    // The car has this speed at the end of a step of dt, `elapsed` after the phase began.
    void look(const HoldSpeed& hold, double speed, double elapsed, double dt);

    // The same with this speed missing to that of a course, which wants this acceleration.
    void look(const FollowCourse& follow, double missing, double acceleration, double dt);

    // The pedals, as throttle above and brake below zero.
    struct Pedals {
        double throttle;
        double brake;
    };
    Pedals pedals(const HoldSpeed& hold, double speed, double elapsed) const;
    Pedals pedals(const FollowCourse& follow, double missing, double acceleration) const;

private:
    double wanted(const HoldSpeed& hold, double elapsed) const;
    double wish(const FollowCourse& follow, double missing, double acceleration) const;

    double start_speed_ = 0;     // m/s
    double start_throttle_ = 0;  // -
    double missing_way_ = 0;     // m, integral of the speed that was missing
};

}  // namespace tread
