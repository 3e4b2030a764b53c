#include "blind/gauges.h"
#include "recording/instruments.h"

namespace tread {

using recording::Instruments;

const std::vector<Gauge>& gauges() {
    // Guesses of a good inertial unit, an optical speed sensor and the car's own wheel speeds.
    static const std::vector<Gauge> list{
        {"driver.steering_wheel_angle", &Instruments::steering_wheel_angle, 0.002, 0},
        {"driver.throttle", &Instruments::throttle, 0.001, 0},
        {"driver.brake", &Instruments::brake, 0.001, 0},
        {"chassis.ax", &Instruments::ax, 0.05, 0.1},
        {"chassis.ay", &Instruments::ay, 0.05, 0.15},
        {"chassis.yaw_rate", &Instruments::yaw_rate, 0.002, 0.003},
        {"chassis.roll_rate", &Instruments::roll_rate, 0.003, 0.005},
        {"chassis.roll", &Instruments::roll, 0.001, 0},
        {"chassis.vx", &Instruments::speed, 0.03, 0},
        {"wheel.front_left.spin", &Instruments::wheel_speed, 0.1, 0},
        {"wheel.front_right.spin", &Instruments::wheel_speed, 0.1, 0},
        {"wheel.rear_left.spin", &Instruments::wheel_speed, 0.1, 0},
        {"wheel.rear_right.spin", &Instruments::wheel_speed, 0.1, 0},
    };
    return list;
}

}  // namespace tread
