// What disturbs every real drive and no model: wind, unevenness, a hand that trembles. As generalised forces on the
// car that wander about zero (Ornstein-Uhlenbeck processes), piecewise linear over time (hat functions a quarter of a
// second apart), so that what they do to the motion is as correlated in time and across channels as it really is: what
// pushes aside is replayed.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <string_view>
#include <vector>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

enum class Disturbed { longitudinal, lateral, yaw, roll, steering };
inline constexpr std::array<std::string_view, 5> kDisturbedNames{"longitudinal", "lateral", "yaw", "roll", "steering"};
inline constexpr std::size_t kDisturbances = kDisturbedNames.size();
inline constexpr std::array<Disturbed, kDisturbances> kDisturbedKinds{
    Disturbed::longitudinal, Disturbed::lateral, Disturbed::yaw, Disturbed::roll, Disturbed::steering};

using Sizes = std::array<double, kDisturbances>;  // of each kind, as a multiple of the usual size

constexpr std::size_t placeOf(Disturbed kind) {
    return static_cast<std::size_t>(kind);
}
constexpr std::string_view nameOf(Disturbed kind) {
    return kDisturbedNames[placeOf(kind)];
}

// Of a usual disturbance of a car: N along or aside, N m in yaw or roll, rad of the road wheels.
double usualSize(Disturbed kind, const VehicleParams& car);

struct Disturbances {
    Eigen::MatrixXd columns;              // rows x impulses, each of the usual size: what they do to the drive
    std::vector<Disturbed> kinds;         // of each column
    std::vector<double> times;            // s, of each impulse
    Eigen::MatrixXd correlation_factor;   // of one kind: heights of the hats x impulses
    Eigen::VectorXd by_start_speed = {};  // startSpeedColumn

    Eigen::Index hats() const { return correlation_factor.rows(); }  // of one kind
    // Heights of the hats, of all kinds, that these impulses build up.
    Eigen::VectorXd heights(const Eigen::VectorXd& impulses) const;
};

// Of a drive of the subject.
Disturbances disturbances(const Replays& replays, const RecordedDrive& drive, const Subject& subject);

}  // namespace tread::diagnose::model
