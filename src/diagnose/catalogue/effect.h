// An effect is a possible cause of a gap between model and car: a set of numbers with neutral defaults that are freed
// together.
//
// A new effect of existing numbers needs no compiling: describe it in a file of OwnEffects and name that file in
// diagnosis.yaml. New physics is C++: give the sub-model a number with a neutral default (for example
// `double trail_lag = 0;` in SteeringParams, its line in `describe`, and its use in advance()), and register the effect
// in one line of any source file that is linked:
//
//     const bool kTrailLag = tread::diagnose::catalogue::addEffect(
//         {.name = "trail_lag", .question = "Does the trail build up late?", .source = "guess",
//          .knobs = {{.paths = {"steering.trail_lag"}, .typical = 0.02}}});
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

enum class Direction { either, up, down };  // sign of a change that is physically possible
constexpr auto enumNames(Direction) {
    return std::array<std::string_view, 3>{"either", "up", "down"};
}

// One free parameter of an effect. It moves all its paths together from their nominal values:
// `value = nominal + share * change`, or `nominal * (1 + share * change)` when `relative`.
struct Knob {
    // Paths in Subject, such as "front.tyre.lambda.Ky", "road.grade" or "instruments.yaw_rate.bias". Paths of parts
    // that a car lacks are skipped; if none is left, the effect does not apply to that car.
    std::vector<std::string> paths;
    double typical = kRequired;
    bool relative = false;
    Direction direction = Direction::either;
    std::vector<double> shares = {};
    double largest = kInfinity;

    double share(std::size_t path) const { return shares.empty() ? 1 : shares[path]; }

    // Change of the number at paths[path] by one typical size, where its nominal value is this.
    double typicalChange(std::size_t path, double nominal) const {
        return share(path) * (relative ? typical * nominal : typical);
    }

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(paths),
              About{"", "paths of the numbers to change: of the car, road, wind or instruments, e.g. road.grade"});
        field(TREAD_FIELD(typical),
              About{"-",
                    "typical size of the change in practice, in the SI unit of the number or as a "
                    "fraction of it: standard deviation of its prior",
                    kPositive});
        field(TREAD_FIELD(relative), About{"", "the change is a fraction of the nominal value"});
        field(TREAD_FIELD(direction), About{"", "sign of the change that is physically possible"});
        field(TREAD_FIELD(shares),
              About{"-", "factor of the change for each path; -1: opposite to the others; none: 1 for all"});
        field(TREAD_FIELD(largest),
              About{"-", "largest plausible change, in the unit of typical; none: that of the numbers", kPositive});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.paths.empty()) complain("paths", "found no path, expected the path of a number, e.g. mass");
        if (!self.shares.empty() && self.shares.size() != self.paths.size())
            complain("shares",
                     "the number of shares differs from that of the paths, expected one share for each path, or none");
    }
};
static_assert(describesEveryMember<Knob>());

struct Effect {
    std::string name;
    std::string question;
    std::string source;
    std::vector<Knob> knobs;
    std::vector<std::string> alike = {};
    bool at_limit = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name, e.g. tyre_relaxation"});
        field(TREAD_FIELD(question), About{"", "question that the effect answers, in plain words"});
        field(TREAD_FIELD(source), About{"", "source of the typical sizes"});
        field(TREAD_FIELD(knobs), About{"", "free parameters, each with a change of its own"});
        field(TREAD_FIELD(alike), About{"", "names of effects that can imitate this one in many drives"});
        field(TREAD_FIELD(at_limit), About{"",
                                           "it determines when the car slides: it is tried before a drive is cut where "
                                           "the motions of car and model diverge"});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.name.empty()) complain("name", "found no name, expected a word");
        if (self.knobs.empty()) complain("knobs", "found no knob, expected at least one knob with paths");
    }
};
static_assert(describesEveryMember<Effect>());

// A file of effects added by the user.
struct OwnEffects {
    std::vector<Effect> catalogue;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(catalogue), About{"", "effects in addition to the built-in ones"});
    }
};
static_assert(describesEveryMember<OwnEffects>());

// Throws LoadError, also for a path that no car has and for a name that is already taken.
std::vector<Effect> loadOwnEffects(const std::filesystem::path& file);

// Changes the numbers of a knob within their limits; `subject` holds the nominal values. False when the subject has
// none of these numbers.
bool move(Subject& subject, const Knob& knob, double change);

// True when the subject has at least one number that the effect moves.
bool applies(const Effect& effect, Subject subject);

// Built-in effects in the order of `tread describe effects`, then the registered ones.
const std::vector<Effect>& effectCatalogue();

// Registers an effect during static initialisation. Always returns true.
bool addEffect(Effect effect);

}  // namespace tread::diagnose::catalogue
