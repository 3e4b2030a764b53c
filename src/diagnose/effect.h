// A cause of a gap between model and car: named numbers whose defaults are neutral, and which are set free together.
#pragma once

#include <string>
#include <vector>

namespace tread {

struct Subject;

enum class Direction { either, up, down };  // of a change that is physically possible

// One free parameter of an effect. It moves its paths together, from the nominal value of each:
// value = nominal + share change, or nominal (1 + share change) when `relative`.
struct Knob {
    // In Subject: "front.tyre.lambda.Ky", "road.grade", "instruments.yaw_rate.bias". Those of parts that a car does not
    // have are left out; without any left the effect does not apply to that car.
    std::vector<std::string> paths;
    double typical = 0;  // size of the change that one meets in practice: standard deviation of its prior
    bool relative = false;
    Direction direction = Direction::either;
    std::vector<double> shares = {};  // of each path, -1 against the others; empty: 1 for all
};

struct Effect {
    std::string name;      // "tyre_relaxation"
    std::string question;  // in plain words: "Do the tyres build up side force later than the model's?"
    std::string source;    // of the typical sizes
    std::vector<Knob> knobs;
};

// Changes the numbers of a knob, within their limits; `subject` has the nominal ones. False when it has none of them.
bool move(Subject& subject, const Knob& knob, double change);

// Whether the subject has a number that the effect moves.
bool applies(const Effect& effect, Subject subject);

// The effects that tread knows, in the order of `tread describe effects`.
const std::vector<Effect>& effectCatalogue();

}  // namespace tread
