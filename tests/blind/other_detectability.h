// Detectability of the faults of the other car, by the formula of blind/detectability/detectability.h.
//
// Changes by faults are taken at the true car, without day-to-day differences, with the driver inputs as its
// instruments recorded them. Columns of tolerances and rivals are taken about the true car without its faults (about
// the plain nominal car they were wrong by up to a factor of two), responses to pushes about the plain car, once for
// all cases. Without references, all shared numbers are uncertain (tolerance of the description of the car over sqrt 3,
// or the spread of other_errors.h), and so is the day. With references the noise counts twice, and only the two days
// are uncertain.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "blind/detectability/detectability.h"
#include "blind/detectability/hats.h"
#include "blind/other_draw.h"
#include "blind/other_measure.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {

using tread::blind::detectability::kHatSpacing;  // between the pushes from whose responses those of a process are made,
                                                 // as of the first generator

// Directions in the space of the shared numbers. Columns: one standard deviation of each uncertain number, of each
// circumstance of a day and of a drive; one typical size of each knob of the rivals.
struct Directions {
    std::vector<std::string> paths;
    Eigen::VectorXd steps;  // finite difference of each number
    Eigen::MatrixXd open, days, drives, knobs;
    std::vector<tread::diagnose::catalogue::Effect> effects;
    std::vector<tread::blind::detectability::Rival> rivals;
};
Directions directionsOf(const tread::recording::Subject& nominal,
                        const std::vector<tread::diagnose::catalogue::Effect>& effects);

// Response of the plain car to pushes in a training drive. Rows: means over 50 ms, channel by channel.
struct Pushed {
    tread::blind::drives::Drive drive;
    std::vector<double> speed, way;       // m/s, m, at the peaks of the hats
    std::array<Eigen::MatrixXd, 4> hats;  // to 1 N longitudinal and lateral, 1 N m of roll and of yaw
    Eigen::VectorXd start;                // to one standard deviation of the initial speed
};
// One element for each training drive.
std::vector<Pushed> pushedDrives(const Truth& plain, const std::vector<tread::blind::drives::Drive>& drives);

// Effects whose typical size changes the readings of the training drives clearly beyond their noise.
std::vector<tread::diagnose::catalogue::Effect> detectableEffects(
    const Truth& plain, const tread::recording::Subject& nominal, const Directions& directions,
    const std::vector<tread::blind::drives::Drive>& drives);

// By name of the fault.
struct Shown {
    std::map<std::string, tread::blind::key::Detectability> with_references, without_references;
};
Shown shown(const std::vector<Pushed>& pushed, const Directions& directions, const Drawn& drawn,
            const ProvingGround& ground);

}  // namespace other_car
