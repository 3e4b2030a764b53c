// vehicles/compact.yaml as a car of the other simulator: the numbers of that file, as far as this model has them.
#pragma once

#include <numbers>

#include "shared/other_car/car.h"

namespace other_car {

inline Params compact() {
    constexpr double kDegree = std::numbers::pi / 180;
    Params p;
    Axle &front = p.front, &rear = p.rear;
    front.track = 1.53;
    front.spring = 22000;
    front.anti_roll_bar = 15000;
    front.damping = 1675;
    front.brake_support = 0.06;
    front.roll_axis = 0.06;
    front.unsprung_mass = 38;
    front.wheel_inertia = 1.0;
    front.compliance_steer = -5e-6;
    front.toe_by_travel = -3 * kDegree;
    front.camber = -0.5 * kDegree;
    front.camber_by_travel = -12 * kDegree;
    front.lift_area = 0.10;
    front.tyre.loaded_radius = 0.291;
    rear.track = 1.51;
    rear.spring = 20000;
    rear.anti_roll_bar = 8000;
    rear.damping = 1325;
    rear.brake_support = 0.15;
    rear.roll_axis = 0.11;
    rear.unsprung_mass = 34;
    rear.wheel_inertia = 0.95;
    rear.compliance_steer = 0.5e-6;
    rear.toe = 0.1 * kDegree;
    rear.toe_by_travel = 2 * kDegree;
    rear.camber = -1.2 * kDegree;
    rear.camber_by_travel = -6 * kDegree;
    rear.lift_area = 0.16;
    rear.tyre.loaded_radius = 0.299;
    p.drive_full = {{80, 100}, {150, 126}, {250, 145}, {350, 152}, {450, 149}, {550, 136}, {640, 115}};
    p.drive_drag = {{0, 12}, {200, 16}, {400, 24}, {700, 40}};
    p.side_area = 3.9;
    p.yaw_volume = 3.0;
    return p;
}

}  // namespace other_car
