// A cause of a gap between model and car: named numbers whose defaults are neutral, and which are set free together.
#pragma once

#include <string>
#include <vector>

namespace tread {

enum class Direction { either, up, down };  // of a change that is physically possible

// One free parameter of an effect. It moves its paths together, from the nominal value of each:
// value = nominal + change, or nominal (1 + change) when `relative`.
struct Knob {
    std::vector<std::string> paths;  // in Subject: "front.tyre.lambda.Ky", "road.grade", "instruments.yaw_rate.bias"
    double typical = 0;              // size of the change that one meets in practice: standard deviation of its prior
    bool relative = false;
    Direction direction = Direction::either;
};

struct Effect {
    std::string name;      // "tyre_relaxation"
    std::string question;  // in plain words: "Do the tyres build up side force later than the model's?"
    std::string source;    // of the typical sizes
    std::vector<Knob> knobs;
};

// The effects that tread knows, in the order of `tread describe effects`.
const std::vector<Effect>& effectCatalogue();

}  // namespace tread
