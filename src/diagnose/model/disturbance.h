// Forces of a real drive that the model does not have. Disturbances (wind, road unevenness, tremor of the driver's
// hand) are Ornstein-Uhlenbeck processes, piecewise linear over time (sums of hat functions). Errors of the
// model's own forces are slower processes in proportion to these forces. Both act as generalised forces on the car.
// Their effect on the motion is found by replaying the drive with pushes, so it has the right correlation over time and
// between channels.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Disturbances, errors of the model's forces in proportion to these, and errors of the readings: drifts, then errors of
// their scale and of their timing in one drive.
enum class Disturbed {
    longitudinal,
    lateral,
    yaw,
    roll,
    steering,
    longitudinal_error,
    lateral_error,
    yaw_error,
    roll_error,
    rate_reading,
    acceleration_reading,
    angle_reading,
    speed_reading,
    wheel_speed_reading,
    rate_scale,
    acceleration_scale,
    angle_scale,
    rate_timing,
    acceleration_timing,
    angle_timing,
    speed_timing,
    wheel_speed_timing
};
inline constexpr std::array<std::string_view, 22> kDisturbedNames{"longitudinal",
                                                                  "lateral",
                                                                  "yaw",
                                                                  "roll",
                                                                  "steering",
                                                                  "longitudinal error",
                                                                  "lateral error",
                                                                  "yaw error",
                                                                  "roll error",
                                                                  "rate readings",
                                                                  "acceleration readings",
                                                                  "angle readings",
                                                                  "speed readings",
                                                                  "wheel-speed readings",
                                                                  "rate scale",
                                                                  "acceleration scale",
                                                                  "angle scale",
                                                                  "rate timing",
                                                                  "acceleration timing",
                                                                  "angle timing",
                                                                  "speed timing",
                                                                  "wheel-speed timing"};
inline constexpr std::size_t kDisturbances = kDisturbedNames.size();
// The kinds that act at any time. Steering is the last of them.
inline constexpr std::array<Disturbed, 5> kDisturbedKinds{Disturbed::longitudinal, Disturbed::lateral, Disturbed::yaw,
                                                          Disturbed::roll, Disturbed::steering};
inline constexpr std::array<Disturbed, 4> kForceErrors{Disturbed::longitudinal_error, Disturbed::lateral_error,
                                                       Disturbed::yaw_error, Disturbed::roll_error};

using Sizes = std::array<double, kDisturbances>;  // of each kind, as a multiple of its usual size

constexpr std::size_t placeOf(Disturbed kind) {
    return static_cast<std::size_t>(kind);
}
constexpr std::string_view nameOf(Disturbed kind) {
    return kDisturbedNames[placeOf(kind)];
}
// Every kind, in the order of its place.
inline constexpr std::array<Disturbed, kDisturbances> kAllDisturbed = [] {
    std::array<Disturbed, kDisturbances> kinds{};
    for (std::size_t place = 0; place < kDisturbances; ++place) kinds[place] = static_cast<Disturbed>(place);
    return kinds;
}();

// Known from the data sheet of an instrument. The roll angle drifts with the tilt of the road.
constexpr bool isInstruments(Disturbed kind) {
    return kind >= Disturbed::rate_reading && kind != Disturbed::angle_reading;
}

// The errors of readings that a channel can have. Speeds have none of scale: satellites measure speed without a scale,
// and rolling radii hardly change from drive to drive.
struct ReadingErrors {
    Disturbed drift, timing;
    std::optional<Disturbed> scale = {};
};
ReadingErrors readingErrorsOf(std::string_view channel);

// Usual size of a disturbance of this car: N (longitudinal, lateral), N m (yaw, roll), rad at the road wheels
// (steering), unit of the channel (drift of readings), share of the reading (scale), s (timing).
double usualSize(Disturbed kind, const VehicleParams& car);

// Distance of the hats. Fine: those of lateral, yaw and roll forces resolve the roll resonance of a car; longitudinal
// forces and steering excite nothing that fast. Rough: all are twice as far apart as the fine ones, for first
// estimates.
enum class Resolution { fine, rough };

// Hat functions of one kind over a drive.
struct Hats {
    double apart = 0;                    // s, from one peak to the next; the first is at the start of the drive
    Eigen::Index first = 0;              // place of the first impulse among those of all kinds
    Eigen::MatrixXd correlation_factor;  // heights x impulses

    Eigen::Index count() const { return correlation_factor.rows(); }
    Eigen::Index end() const { return first + count(); }
    double peak(Eigen::Index hat) const { return static_cast<double>(hat) * apart; }
};
using HatsOfKinds = std::array<Hats, kDisturbedKinds.size()>;
HatsOfKinds hatsOver(double duration, Resolution resolution);

struct Disturbances {
    Eigen::MatrixXd columns;              // rows x impulses: change of the rows by each impulse at its usual size
    std::vector<Disturbed> kinds;         // kind of each column; those of kDisturbedKinds come first
    std::vector<double> times;            // s, time of each column's hat
    HatsOfKinds hats;                     // of kDisturbedKinds
    Eigen::VectorXd by_start_speed = {};  // change of the rows per m/s of start speed

    const Hats& of(Disturbed kind) const { return hats[placeOf(kind)]; }
    Eigen::Index random() const { return hats.back().end(); }  // number of columns of kDisturbedKinds
    // Heights of the hats of kDisturbedKinds, one kind after the other, for the given impulses of these.
    Eigen::VectorXd heights(const Eigen::VectorXd& impulses) const;
};

// Disturbances of a drive, linear about its replay by `subject`.
Disturbances disturbances(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                          Resolution resolution = Resolution::fine);
// Of several drives, each with its subject.
std::vector<Disturbances> disturbances(const Replays& replays, const std::vector<const RecordedDrive*>& drives,
                                       const std::vector<Subject>& subjects, Resolution resolution = Resolution::fine);

}  // namespace tread::diagnose::model
