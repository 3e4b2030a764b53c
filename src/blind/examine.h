// What the drives of a blind case show of what is wrong with its car: fills in the formula of shows.h with tread.
//
// Changes (delta) are taken at the true car, with the driver's inputs as its instruments recorded them: also without
// the fault these show the same. What can absorb a change is taken about the true car without any fault: absorbed is
// what a sound car could show. (About the nominal car, once for all cases, it would cost a tenth. Of seven cases that
// changed the nats by 1 to 20 % in five, of one from 6.2 to 4.8, of one from 194 to 310: columns that point a little
// elsewhere absorb less of a large change.) Not counted: noise of the recorded inputs, spikes. A rival may also have a
// sign that its effect cannot have: separation is what is left at least.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "blind/drives.h"
#include "blind/shows.h"
#include "blind/truth.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace tread {

// What can absorb changes in one drive from which to learn.
struct ExaminedDrive {
    Drive drive;
    std::vector<double> times;              // s, of the readings
    std::vector<double> speed;              // m/s, at these times
    Eigen::MatrixXd tolerances, rivals;     // of shows.h
    std::array<Eigen::MatrixXd, 4> by_hat;  // along, aside, roll, yaw: rows x hats of kUnitPush, kHat apart
    Eigen::MatrixXd differences;            // of one drive against others, of one standard deviation each
    Eigen::VectorXd by_start_speed;         // per m/s
};
inline constexpr double kHat = 0.1;       // s
inline constexpr double kUnitPush = 100;  // N or N m

struct Examination {
    std::vector<ExaminedDrive> drives;
    std::vector<diagnose::catalogue::Effect> effects;
    std::vector<Rival> rivals;  // effects that this car can have
};

// About a car, with what is left open of it. `effects`: the catalogue. `threads`: 0 for all.
// Throws SimulationError when the car cannot be driven.
Examination examination(const recording::Subject& about, const std::vector<Drive>& drives,
                        const std::vector<OpenNumber>& open, const std::vector<diagnose::catalogue::Effect>& effects,
                        int threads = 0);

// The rows of a log: blocks of every gauge of the car, one channel after the other.
Eigen::VectorXd shownRows(const Log& log);

// Noise and pushes in a drive of this car, whose readings without them these are (readingsOf()); no columns besides.
ShownDrive hiding(const ExaminedDrive& drive, const Truth& truth, const Log& readings);

// Of each thing that is wrong. Throws SimulationError when the car without it cannot be driven.
std::map<std::string, Shows> examined(const Examination& examination, const DrawnCase& drawn, int threads = 0);

}  // namespace tread
