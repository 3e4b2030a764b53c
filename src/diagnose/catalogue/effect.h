// A cause of a gap between model and car: named numbers whose defaults are neutral, and which are set free together.
//
// A new effect of numbers that exist needs no compiling: a file of OwnEffects, named in diagnosis.yaml. New physics is
// C++: give the sub-model that it belongs to a number with a neutral default (say `double trail_lag = 0;` in
// SteeringParams, its line in `describe`, and what it does in advance()), and register the effect in one line of any
// source file that is linked:
//
//     const bool kTrailLag = tread::diagnose::catalogue::addEffect({.name = "trail_lag",
//         .question = "Does the trail follow late?", .source = "guess", .knobs = {{.paths = {"steering.trail_lag"}, .typical = 0.02}}});
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "recording/subject.h"
#include "tread/describe.h"

namespace tread::diagnose::catalogue {

using recording::Subject;

enum class Direction { either, up, down };  // of a change that is physically possible
constexpr auto enumNames(Direction) {
    return std::array<std::string_view, 3>{"either", "up", "down"};
}

// One free parameter of an effect. It moves its paths together, from the nominal value of each:
// value = nominal + share change, or nominal (1 + share change) when `relative`.
struct Knob {
    // In Subject: "front.tyre.lambda.Ky", "road.grade", "instruments.yaw_rate.bias". Those of parts that a car does not
    // have are left out; without any left the effect does not apply to that car.
    std::vector<std::string> paths;
    double typical = kRequired;
    bool relative = false;
    Direction direction = Direction::either;
    std::vector<double> shares = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(paths),
              About{"", "numbers that it moves: of the car, of road, wind or instruments (road.grade)"});
        field(TREAD_FIELD(typical), About{"-",
                                          "size of the change that one meets in practice, in the SI unit of the number "
                                          "or as a fraction of it: standard deviation of its prior",
                                          kPositive});
        field(TREAD_FIELD(relative), About{"", "the change is a fraction of the nominal value"});
        field(TREAD_FIELD(direction), About{"", "of a change that is physically possible"});
        field(TREAD_FIELD(shares), About{"-", "of each path, -1 against the others; none: 1 for all"});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.paths.empty()) complain("paths", "found no path, expected that of a number, e.g. mass");
        if (!self.shares.empty() && self.shares.size() != self.paths.size())
            complain("shares", "expected one share for each path, or none");
    }
};
static_assert(describesEveryMember<Knob>());

struct Effect {
    std::string name;
    std::string question;
    std::string source;
    std::vector<Knob> knobs;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name, e.g. tyre_relaxation"});
        field(TREAD_FIELD(question), About{"", "what it asks, in plain words"});
        field(TREAD_FIELD(source), About{"", "of the typical sizes"});
        field(TREAD_FIELD(knobs), About{"", "what is free, each with its own change"});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.name.empty()) complain("name", "found no name, expected a word");
        if (self.knobs.empty()) complain("knobs", "found no knob, expected at least one with its paths");
    }
};
static_assert(describesEveryMember<Effect>());

// A file of effects that a user adds.
struct OwnEffects {
    std::vector<Effect> catalogue;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(catalogue), About{"", "effects besides those that tread knows"});
    }
};
static_assert(describesEveryMember<OwnEffects>());

// Throws LoadError: also for a path that no car has, and for a name that is taken.
std::vector<Effect> loadOwnEffects(const std::filesystem::path& file);

// Changes the numbers of a knob, within their limits; `subject` has the nominal ones. False when it has none of them.
bool move(Subject& subject, const Knob& knob, double change);

// Whether the subject has a number that the effect moves.
bool applies(const Effect& effect, Subject subject);

// The effects that tread knows, in the order of `tread describe effects`, and those that were added.
const std::vector<Effect>& effectCatalogue();

// Adds one at the start of the program; true.
bool addEffect(Effect effect);

}  // namespace tread::diagnose::catalogue
