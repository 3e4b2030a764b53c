// What disturbs every real drive and no model: wind, unevenness, a hand that trembles. As generalised forces on the
// car, piecewise linear over time (hats of half a second), so that what they do to the motion is as correlated in time
// and across channels as it really is: what pushes aside is replayed.
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

struct Disturbances {
    Eigen::MatrixXd columns;       // rows x hats, each of the usual size
    std::vector<Disturbed> kinds;  // of each column
    std::vector<double> times;     // s, peak of each hat
};

// Of a drive of the subject; `by_start_speed`: its startSpeedColumn.
Disturbances disturbances(Bench& bench, std::size_t drive, const Subject& subject,
                          const Eigen::VectorXd& by_start_speed);

}  // namespace tread
