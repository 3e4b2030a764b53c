// Parameters of a fit: the uncertain numbers of car and instruments, and the knobs of the effects. Each is a direction
// in the space of the subject's numbers, in units of its prior standard deviation.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/catalogue/effect.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::diagnose::model {

using catalogue::Effect;
using recording::KnownWithin;
using recording::Subject;

// Bounds within which the car can still be replayed: standard deviations of a nuisance parameter, typical sizes of an
// effect. They decide no verdict: 100 in place of either changes none of the development cases.
inline constexpr double kLargestTolerance = 4, kLargestEffect = 8;
// Typical sizes of an effect that changes readings only: the car can be replayed with any of them, and a delay may be
// 0.5 s where 0.03 s is typical.
inline constexpr double kLargestReading = 20;

struct Parameter {
    struct Move {
        std::string path;
        double nominal;
        double by;  // change of the number per unit of the parameter
    };
    std::vector<Move> moves;
    // Bounds in units: physical limits of the numbers, and kLargestTolerance, kLargestEffect or kLargestReading.
    double lowest = -kLargestTolerance;
    double highest = kLargestTolerance;
    bool instruments_only = false;  // changes the readings only, not the motion

    const std::string& name() const { return moves.front().path; }
};

void move(Subject& subject, const Parameter& parameter, double units);

// A tolerance t becomes the standard deviation t / sqrt(3) of a uniform distribution. `same`: factor on the tolerances
// of what stays the same from day to day, that is the car, and the instruments except for their zeros (D15).
std::vector<Parameter> nuisances(const Subject& nominal, const std::vector<KnownWithin>& tolerances, double same = 1);

// Indices of parameters: `some`, then `more`.
std::vector<Eigen::Index> joined(const std::vector<Eigen::Index>& some, const std::vector<Eigen::Index>& more);

// One term of a parameter written as a mixture of others: one unit of the parameter does what `units` of this one and
// the corresponding units of the other terms do together.
struct Share {
    Eigen::Index of;  // index into all parameters
    double units;
};
// The parameter as a mixture of `others`; empty unless each of its numbers is moved by one of them that moves nothing
// else.
std::vector<Share> mixture(const Parameter& parameter, const std::vector<Parameter>& all,
                           const std::vector<Eigen::Index>& others);

// One parameter per knob. A knob that moves nothing is left out: the car lacks the part, or the knob is relative to a
// number that is 0 (D16).
std::vector<Parameter> knobsOf(const Effect& effect, const Subject& nominal);

}  // namespace tread::diagnose::model
