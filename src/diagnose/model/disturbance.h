// Random disturbances of a real drive that the model does not have: wind, road unevenness, tremor of the driver's hand.
// Each is an Ornstein-Uhlenbeck process that acts as a generalised force on the car, piecewise linear over time (hat
// functions 0.25 s apart). Their effect on the motion is found by replaying the drive with pushes, so it has the right
// correlation over time and between channels.
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

using Sizes = std::array<double, kDisturbances>;  // of each kind, as a multiple of its usual size

constexpr std::size_t placeOf(Disturbed kind) {
    return static_cast<std::size_t>(kind);
}
constexpr std::string_view nameOf(Disturbed kind) {
    return kDisturbedNames[placeOf(kind)];
}

// Usual size of a disturbance of this car: N (longitudinal, lateral), N m (yaw, roll), rad at the road wheels
// (steering).
double usualSize(Disturbed kind, const VehicleParams& car);

struct Disturbances {
    Eigen::MatrixXd columns;              // rows x impulses: change of the rows by each impulse at its usual size
    std::vector<Disturbed> kinds;         // kind of each column
    std::vector<double> times;            // s, time of each column's hat
    Eigen::MatrixXd correlation_factor;   // of one kind: heights of the hats x impulses
    Eigen::VectorXd by_start_speed = {};  // change of the rows per m/s of start speed

    Eigen::Index hats() const { return correlation_factor.rows(); }  // of one kind
    // Heights of the hats, all kinds one after the other, for the given impulses.
    Eigen::VectorXd heights(const Eigen::VectorXd& impulses) const;
};

// Disturbances of a drive, linear about its replay by `subject`.
Disturbances disturbances(const Replays& replays, const RecordedDrive& drive, const Subject& subject);

}  // namespace tread::diagnose::model
