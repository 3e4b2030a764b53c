// What the drives of the other car show of what is wrong with it: fills in the formula of blind/shows.h.
//
// Changes (delta) are taken at the true car, as it is on no day in particular, with the inputs of the driver as its
// instruments recorded them. What numbers and rivals can absorb is taken about the true car, too, but without what is
// wrong: about the plain nominal car it came out wrong by up to a factor of two. What pushes do is taken about the
// plain car, once for all cases.
// Without references all that is known within a tolerance is open: the shared numbers (tolerance of the vehicle's
// description over sqrt 3, or where it states none the spread of other_errors.h) and the day. With references the noise
// counts twice and only the two days are open.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "blind/examine.h"
#include "blind/other_draw.h"
#include "blind/other_measure.h"
#include "blind/shows.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {

using tread::kHat;  // between the pushes from whose responses those of a process are made, as of the first generator

// What can change a car, each as changes of the shared numbers: of one standard deviation that is left open, of one of
// a day, of one from drive to drive; of one typical size of each knob of the rivals.
struct Directions {
    std::vector<std::string> paths;
    Eigen::VectorXd steps;  // of each number, of differences
    Eigen::MatrixXd open, days, drives, knobs;
    std::vector<tread::diagnose::catalogue::Effect> effects;
    std::vector<tread::Rival> rivals;
};
Directions directionsOf(const tread::recording::Subject& nominal,
                        const std::vector<tread::diagnose::catalogue::Effect>& effects);

// What pushes do in a drive from which to learn; rows are the means of 50 ms of one channel after the other.
struct Pushed {
    tread::Drive drive;
    std::vector<double> speed, way;       // m/s, m: where the hats have their tops
    std::array<Eigen::MatrixXd, 4> hats;  // of 1 N along and aside, 1 N m of roll and of yaw
    Eigen::VectorXd start;                // of one standard deviation of the speed at the start
};
// Of the drives that are not held out.
std::vector<Pushed> pushedDrives(const Truth& plain, const std::vector<tread::Drive>& drives);

// Those whose typical size changes the readings of a car by more than their noise.
std::vector<tread::diagnose::catalogue::Effect> shownEffects(const Truth& plain,
                                                             const tread::recording::Subject& nominal,
                                                             const Directions& directions,
                                                             const std::vector<tread::Drive>& drives);

struct Shown {
    std::map<std::string, tread::Shows> with_references, without_references;
};
Shown shown(const std::vector<Pushed>& pushed, const Directions& directions, const Drawn& drawn,
            const ProvingGround& ground);

}  // namespace other_car
