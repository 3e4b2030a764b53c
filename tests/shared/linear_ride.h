// The ride of a car as a linear model of body and four wheels, written on its own.
#pragma once

#include <Eigen/Dense>

#include "shared/vehicles.h"

namespace reference {

using Vector7 = Eigen::Vector<double, 7>;
using Vector14 = Eigen::Vector<double, 14>;

// Equal damping in bump and rebound: the linear model knows no other.
inline tread::VehicleParams linearCar(tread::VehicleParams car) {
    car = simplified(car);
    for (tread::AxleParams* axle : {&car.front, &car.rear}) {
        tread::DamperParams& damper = axle->suspension.damper;
        damper.bump = damper.rebound = 0.5 * (damper.bump + damper.rebound);
    }
    return car;
}

// ---- The linear model ----
// Coordinates: heave z, roll phi, pitch theta of the body, rise w of the four wheels. All rates from Lagrange:
//   2 T = m z'^2 + Ix phi'^2 + Iy theta'^2 + sum mu (w'^2 - (z' + y phi' - x theta')^2)
//   2 V = sum ks (w - z - y phi + x theta)^2 + kt w^2 + bars - W h phi^2 - W (h - r) theta^2
// The last terms: the contacts swing with the body, in roll down the plane of the leaning wheel, in pitch below its
// centre.

// Matrices of dynamic size compile faster than fixed ones of 7 and 14 rows.
struct LinearModel {
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(7, 7), damping = mass, stiffness = mass;

    Eigen::MatrixXd system() const {
        const Eigen::MatrixXd inverse = mass.inverse();
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(14, 14);
        a.topRightCorner(7, 7).setIdentity();
        a.bottomLeftCorner(7, 7) = -inverse * stiffness;
        a.bottomRightCorner(7, 7) = -inverse * damping;
        return a;
    }
};

inline LinearModel linearModel(const tread::VehicleParams& car) {
    const double b = car.wheelbase - car.front_axle_distance;
    LinearModel model;
    model.mass.diagonal().head<3>() << car.mass, car.inertia.roll, car.inertia.pitch;

    const auto add = [](Eigen::MatrixXd& m, double value, const Vector7& row) { m += value * row * row.transpose(); };
    for (std::size_t i = 0; i < tread::kWheels; ++i) {
        const tread::AxleParams& axle = i < 2 ? car.front : car.rear;
        Vector7 body = Vector7::Zero();
        const double y = (i % 2 == 0 ? 0.5 : -0.5) * axle.track;
        body.head<3>() << 1, y, i < 2 ? -car.front_axle_distance : b;
        const Vector7 wheel = Vector7::Unit(static_cast<int>(3 + i));
        add(model.mass, axle.unsprung_mass, wheel);
        add(model.mass, -axle.unsprung_mass, body);
        add(model.stiffness, axle.suspension.spring, wheel - body);
        add(model.damping, axle.suspension.damper.bump, wheel - body);
        add(model.stiffness, axle.tyre.parameters.pz1, wheel);
        add(model.damping, axle.tyre.parameters.pz2, wheel);
        if (i % 2 == 0) {
            Vector7 twist = wheel - Vector7::Unit(static_cast<int>(4 + i));
            twist(1) = -axle.track;
            add(model.stiffness, axle.suspension.anti_roll_bar, twist);
        }
        const double load =
            0.5 * car.mass * tread::kStandardGravity * (i < 2 ? b : car.front_axle_distance) / car.wheelbase;
        const double radius = axle.tyre.parameters.Ro - load / axle.tyre.parameters.pz1;
        model.stiffness(1, 1) -= load * car.centre_of_gravity_height;
        model.stiffness(2, 2) -= load * (car.centre_of_gravity_height - radius);
    }
    return model;
}

// Movement of a car from rest.
inline Vector7 coordinates(const Car& car, const Car& rest) {
    const tread::VehicleOutput out = car.output();
    Vector7 q;
    q.head<3>() << out.chassis.z - rest.output().chassis.z, out.chassis.roll, out.chassis.pitch;
    for (std::size_t i = 0; i < tread::kWheels; ++i)
        q(static_cast<int>(3 + i)) =
            rest.state.wheels[i].radius > 0 ? car.state.wheels[i].radius - rest.state.wheels[i].radius : 0;
    return q;
}

}  // namespace reference
