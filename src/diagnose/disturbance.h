// What disturbs every real drive and no model: wind, unevenness, a hand that trembles. As generalised forces on the
// car that wander about zero (Ornstein-Uhlenbeck processes), piecewise linear over time (hats of a quarter of a
// second), so that what they do to the motion is as correlated in time and across channels as it really is: what pushes
// aside is replayed.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <string_view>
#include <vector>

#include "diagnose/bench.h"

namespace tread {

enum class Disturbed { longitudinal, lateral, yaw, roll, steering };
inline constexpr std::array<std::string_view, 5> kDisturbedNames{"longitudinal", "lateral", "yaw", "roll", "steering"};
inline constexpr std::size_t kDisturbances = kDisturbedNames.size();

// Of a usual disturbance of a car: N along or aside, N m in yaw or roll, rad of the road wheels.
double usualSize(Disturbed kind, const VehicleParams& car);

struct Disturbances {
    Eigen::MatrixXd columns;       // rows x impulses, each of the usual size: what they do, and what lingers of them
    std::vector<Disturbed> kinds;  // of each column
    std::vector<double> times;     // s, of each impulse
    Eigen::MatrixXd lingering;     // of one kind: hats x impulses
    Eigen::VectorXd by_start_speed = {};  // startSpeedColumn

    // Heights of the hats, of all kinds, that these impulses build up.
    Eigen::VectorXd hats(const Eigen::VectorXd& impulses) const;
};

// Cholesky factor of the correlation of so many hats, each of variance one: what an impulse leaves in them.
Eigen::MatrixXd lingering(Eigen::Index hats);

// Of a drive of the subject.
Disturbances disturbances(Bench& bench, std::size_t drive, const Subject& subject);

}  // namespace tread
