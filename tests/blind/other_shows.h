// What the drives of the other car show of what is wrong with it: fills in the formula of blind/shows.h.
//
// Changes (delta) are taken at the true car, as it is on no day in particular, with the inputs of the driver as its
// instruments recorded them. What can absorb a change is taken about the car that errs in nothing and has no structure
// of its own, once for all cases. Without references all that is known within a tolerance is open: the shared
// numbers (tolerance of the vehicle's description over sqrt 3, or where it states none the spread of other_errors.h)
// and the day. With references the noise counts twice and only the two days are open.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "blind/other_draw.h"
#include "blind/other_measure.h"
#include "blind/shows.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {

inline constexpr double kHat = 0.25;  // s, between the pushes from whose responses those of a process are made

// Columns of one drive from which to learn; rows are the means of 50 ms of one channel after the other.
struct Absorbing {
    tread::Drive drive;
    std::vector<double> speed, way;       // m/s, m: where the hats have their tops
    Eigen::MatrixXd open, days, rivals;   // of one standard deviation, of one of a day; of one typical size
    Eigen::MatrixXd drives;               // what differs from drive to drive, the speed at the start too
    std::array<Eigen::MatrixXd, 4> hats;  // of 1 N along and aside, 1 N m of roll and of yaw
};
struct Examination {
    std::vector<Absorbing> drives;
    std::vector<tread::diagnose::catalogue::Effect> effects;  // the rivals
    std::vector<tread::Rival> rivals;
};
// Of the drives that are not held out.
Examination examinationOf(const Truth& plain, const tread::recording::Subject& nominal,
                          const std::vector<tread::diagnose::catalogue::Effect>& effects,
                          const std::vector<tread::Drive>& drives);

// Those whose typical size changes the readings by more than their noise.
std::vector<tread::diagnose::catalogue::Effect> shownEffects(const Examination& examination);

struct Shown {
    std::map<std::string, tread::Shows> with_references, without_references;
};
Shown shown(const Examination& examination, const Drawn& drawn, const ProvingGround& ground);

}  // namespace other_car
