// Parameters of a fit: the uncertain numbers of car and instruments, and the knobs of the effects. Each is a direction
// in the space of the subject's numbers, in units of its prior standard deviation.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/catalogue/effect.h"
#include "inference/bounded_step.h"
#include "recording/recorded_drive.h"
#include "recording/subject.h"

namespace tread::diagnose::model {

using catalogue::Effect;
using recording::Drives;
using recording::KnownWithin;
using recording::RecordedDrive;
using recording::Subject;

// Bound, in units, of a parameter whose numbers have neither limits nor a plausible range.
inline constexpr double kWidest = 12;

struct Parameter {
    struct Move {
        std::string path;
        double nominal;
        double by;  // change of the number per unit of the parameter
    };
    std::vector<Move> moves;
    // Of a parameter that stands for something else than the numbers that it moves, such as a temperature: its name,
    // with the unit, and its change per unit of the parameter. Empty: it stands for the first number that it moves.
    std::string quantity = {};
    double quantity_by = 0;
    // The only recording that the parameter concerns, and its name; null: it concerns all.
    const recording::Recording* only = nullptr;
    std::string only_name = {};
    // Bounds in units: where all numbers are within their physical limits and plausible ranges (D15).
    double lowest = -kInfinity;
    double highest = kInfinity;
    double physical_lowest = -kInfinity;  // the same by the physical limits alone
    double physical_highest = kInfinity;
    bool instruments_only = false;  // changes the readings only, not the motion
    bool of_the_day = false;        // wind of all drives: no number of car, road or instruments
    bool of_both = false;           // of the car before and after the change alike: it moves references too
    // The parameter of which this is an imperfection; it moves no number. -1: none.
    Eigen::Index imperfection_of = -1;

    // True at an end of the plausible ranges. A physical limit is a value as any other: a bar that is not there.
    bool implausibleAt(double units) const;
    const std::string& path() const { return moves.front().path; }
    std::string name() const {
        if (!quantity.empty()) return quantity;
        return only ? path() + " in " + only_name : of_both ? path() + " of both cars" : path();
    }
    bool concerns(const RecordedDrive& drive) const { return !only || only == drive.recording; }
};

void move(Subject& subject, const Parameter& parameter, double units);

// The subject moved by all parameters that concern the drive: one value per parameter, in its units.
Subject movedIn(const RecordedDrive& drive, Subject subject, const std::vector<Parameter>& parameters,
                const Eigen::VectorXd& units);

// A tolerance t becomes the standard deviation t / sqrt(3) of a uniform distribution. `same` below 1: of the
// same car on another day. What stays the same, that is the car, and the instruments except for their zeros, has this
// share of its tolerance; what changes with weather and load differs by more, if the file allows it (D15a).
std::vector<Parameter> nuisances(const Subject& nominal, const std::vector<KnownWithin>& tolerances, double same = 1);

// The temperature of the tyres on another day: it changes stiffness and friction of all four together, by no more than
// the tolerances told. Nothing where they leave no room (D15b).
std::optional<Parameter> temperatureOfTheTyres(const Subject& nominal, const std::vector<KnownWithin>& tolerances);

// The wind: half of its variance is that of a day, the same in all drives, and half that of each drive. With
// references, the wind of both runs (D15).
std::vector<Parameter> nuisancesOfTheWind(const Subject& nominal, const std::vector<KnownWithin>& tolerances,
                                          Drives drives);

// What the references leave open of the car before: numbers that its change left alone (D45c).
std::vector<Parameter> nuisancesOfBoth(const Subject& before, const std::vector<KnownWithin>& left_open);

// Bounds of some parameters: of their values, and of steps from a point.
inference::Bounds boundsOf(const std::vector<Parameter>& all, const std::vector<Eigen::Index>& some);
inference::Bounds boundsAbout(const Eigen::VectorXd& point, const std::vector<Parameter>& all,
                              const std::vector<Eigen::Index>& some);

// Indices of parameters: `some`, then `more`.
std::vector<Eigen::Index> joined(const std::vector<Eigen::Index>& some, const std::vector<Eigen::Index>& more);

// One term of a parameter written as a mixture of others: one unit of the parameter does what `units` of this one and
// the corresponding units of the other terms do together.
struct Share {
    Eigen::Index of;  // index into all parameters
    double units;
};
// The parameter as a mixture of `others`; empty unless each of its numbers is moved in every drive by one of them that
// moves nothing else.
std::vector<Share> mixture(const Parameter& parameter, const std::vector<Parameter>& all,
                           const std::vector<Eigen::Index>& others);

// One parameter per knob. A knob that moves nothing is left out: the car lacks the part, or the knob is relative to a
// number that is 0 (D16).
std::vector<Parameter> knobsOf(const Effect& effect, const Subject& nominal);

}  // namespace tread::diagnose::model
