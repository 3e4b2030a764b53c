// The linear single-track model: closed-form transfer functions, and logs of it under any steering.
//   m (vy' + v r) = Fy,f + Fy,r    J r' = a Fy,f - b Fy,r    Fy,i = C_i * slip angle of the axle
// (Riekert and Schunck, Zur Fahrmechanik des gummibereiften Kraftfahrzeugs, 1940.)
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <functional>

#include "log/log.h"

namespace tread::shared {

struct SingleTrack {
    double mass = 1400, inertia = 2200;  // kg, kg m2
    double front = 1.15, rear = 1.45;    // m, axles from the centre of gravity
    double front_stiffness = 9e4;        // N/rad, both wheels together
    double rear_stiffness = 1.1e5;       // N/rad
    double speed = 25;                   // m/s
    double ratio = 16;                   // steering wheel over road wheel

    double wheelbase() const { return front + rear; }
    // rad per m/s2 at the road wheels.
    double understeer() const { return mass / wheelbase() * (rear / front_stiffness - front / rear_stiffness); }
    // Steady yaw rate over steering-wheel angle, 1/s.
    double yawGain() const { return speed / (wheelbase() + understeer() * speed * speed) / ratio; }

    Eigen::Matrix2d a() const {
        const double f = front_stiffness, r = rear_stiffness, v = speed;
        Eigen::Matrix2d out;
        out << -(f + r) / (mass * v), (rear * r - front * f) / (mass * v) - v, (rear * r - front * f) / (inertia * v),
            -(front * front * f + rear * rear * r) / (inertia * v);
        return out;
    }
    Eigen::Vector2d b() const {
        return Eigen::Vector2d(front_stiffness / mass, front * front_stiffness / inertia) / ratio;
    }

    // Over the steering-wheel angle at a frequency in Hz.
    struct Transfer {
        std::complex<double> yaw_rate;  // 1/s
        std::complex<double> ay;        // m/s2 over rad
    };
    Transfer at(double frequency) const {
        const std::complex<double> s(0, 2 * std::acos(-1.0) * frequency);
        const Eigen::Matrix2cd system = s * Eigen::Matrix2cd::Identity() - a().cast<std::complex<double>>();
        const Eigen::Vector2cd x = system.inverse() * b().cast<std::complex<double>>();
        return {x[1], s * x[0] + speed * x[1]};
    }

    // A log under a steering over time, by Runge-Kutta; the rate a whole part of the inverse of the step.
    Log drive(const std::function<double(double)>& steering, double duration, double rate, double step = 0.001) const {
        Log log{{{"time", "s", {}},
                 {"driver.steering_wheel_angle", "rad", {}},
                 {"chassis.vx", "m/s", {}},
                 {"chassis.yaw_rate", "rad/s", {}},
                 {"chassis.ay", "m/s2", {}},
                 {"chassis.sideslip", "rad", {}}}};
        const auto every = static_cast<long>(std::lround(1 / (rate * step)));
        Eigen::Vector2d x(0, 0);
        const auto slope = [&](const Eigen::Vector2d& y, double t) -> Eigen::Vector2d {
            return a() * y + b() * steering(t);
        };
        for (long k = 0; static_cast<double>(k) * step <= duration + 1e-9; ++k) {
            const double t = static_cast<double>(k) * step;
            if (k % every == 0) {
                const double row[] = {t, steering(t), speed, x[1], slope(x, t)[0] + speed * x[1], x[0] / speed};
                for (std::size_t i = 0; i < log.channels.size(); ++i) log.channels[i].values.push_back(row[i]);
            }
            const Eigen::Vector2d k1 = slope(x, t), k2 = slope(x + 0.5 * step * k1, t + 0.5 * step),
                                  k3 = slope(x + 0.5 * step * k2, t + 0.5 * step), k4 = slope(x + step * k3, t + step);
            x += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        return log;
    }
};

}  // namespace tread::shared
