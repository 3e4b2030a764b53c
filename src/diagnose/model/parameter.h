// What the fit may move: the uncertain numbers of car and instruments, and the knobs of the effects. Each is a
// direction in the space of the subject's numbers, in units of its prior standard deviation.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/catalogue/effect.h"
#include "diagnose/settings.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::diagnose::model {

using catalogue::Effect;
using recording::KnownWithin;
using recording::Subject;

struct Parameter {
    struct Move {
        std::string path;
        double nominal;
        double by;  // change for one unit of the parameter
    };
    std::vector<Move> moves;
    // In units: what is physically possible, and not more than so many standard deviations.
    double lowest = -kSettings.largest_tolerance;
    double highest = kSettings.largest_tolerance;
    bool instruments_only = false;  // changes readings, not the drive

    const std::string& name() const { return moves.front().path; }
};

void move(Subject& subject, const Parameter& parameter, double units);

// A tolerance t is taken as the standard deviation t / sqrt(3) of a uniform distribution. `same`: the share of it
// that counts for what is the same from day to day, car and instruments but for their zeros (D15).
std::vector<Parameter> nuisances(const Subject& nominal, const std::vector<KnownWithin>& tolerances, double same = 1);

// Indices of parameters, one list behind the other.
std::vector<Eigen::Index> joined(const std::vector<Eigen::Index>& some, const std::vector<Eigen::Index>& more);

// One parameter as a mixture of others: so many units of each do what one unit of it does.
struct Share {
    Eigen::Index of;  // index among all parameters
    double units;
};
// Nothing when the others do not move all of its numbers, each number by one of them.
std::vector<Share> mixture(const Parameter& parameter, const std::vector<Parameter>& all,
                           const std::vector<Eigen::Index>& others);

// One per knob that moves something: the car may lack the part, or a share of nothing may be asked for (D16).
std::vector<Parameter> knobsOf(const Effect& effect, const Subject& nominal);

}  // namespace tread::diagnose::model
