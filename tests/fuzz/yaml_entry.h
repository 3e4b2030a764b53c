// What the fuzzer and the replay of its corpus do with a text: read it as a tyre and as a struct with every kind of
// field. It must end in an object that is written and read back the same, or in a LoadError that says something.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/yaml/read.h"
#include "base/yaml/write.h"
#include "fuzz/demand.h"
#include "tread/tyre.h"
#include "tread/wheels.h"

namespace tread::fuzz {

struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(to), About{"rad", "final angle"}); }
};

struct Keep {
    static constexpr std::string_view kName = "keep";
    double tolerance = 0.5;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tolerance), About{"-", "how closely", kFraction});
    }
};

enum class Drive { front, rear, all };
constexpr auto enumNames(Drive) {
    return std::array<std::string_view, 3>{"front", "rear", "all"};
}

struct Step {
    std::variant<Keep, Ramp> action;
    std::vector<Step> steps;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(action), About{"", "action"});
        field(TREAD_FIELD(steps), About{"", "steps"});
    }
};

struct Everything {
    std::string name;
    Drive drive = Drive::front;
    bool locked = false;
    int gears = 5;
    double mass = kRequired;
    double temperature = 290;
    PerAxle<Keep> axle;
    Curve torque;
    std::vector<double> ratios;
    std::vector<std::string> words;
    std::vector<Step> steps;
    std::optional<double> lag;
    std::optional<Ramp> ramp;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name"});
        field(TREAD_FIELD(drive), About{"", "driven axle"});
        field(TREAD_FIELD(locked), About{"", "locked differential"});
        field(TREAD_FIELD(gears), About{"-", "number of gears", Limits{1, 10}});
        field(TREAD_FIELD(mass), About{"kg", "mass", kPositive});
        field(TREAD_FIELD(temperature), About{"K", "temperature", kNonNegative});
        field(TREAD_FIELD(axle), About{"", "axles"});
        field(TREAD_FIELD(torque), About{"N m", "torque", kAny, 0, "rad/s"});
        field(TREAD_FIELD(ratios), About{"-", "ratios"});
        field(TREAD_FIELD(words), About{"", "words"});
        field(TREAD_FIELD(steps), About{"", "steps"});
        field(TREAD_FIELD(lag), About{"s", "lag"});
        field(TREAD_FIELD(ramp), About{"", "ramp"});
    }
    static void check(const auto& self, auto&& complain) {
        if (std::ssize(self.ratios) > self.gears) complain("ratios", "found more ratios than gears");
    }
};
static_assert(describesEveryMember<Everything>());

// True when the text was taken.
template <Described T>
bool readAs(std::string_view text) {
    T object;
    try {
        object = readYamlText<T>(text, "fuzz.yaml");
    } catch (const LoadError& error) {
        demand(!error.problems().empty());
        for (const Problem& problem : error.problems()) demand(problem.file == "fuzz.yaml" && !problem.text.empty());
        return false;
    }
    const std::string written = writeYaml(object);
    demand(writeYaml(readYamlText<T>(written, "written.yaml")) == written);
    return true;
}

inline bool readHostileYaml(std::string_view text) {
    const bool is_tyre = readAs<TyreParams>(text);
    const bool is_everything = readAs<Everything>(text);
    return is_tyre || is_everything;
}

}  // namespace tread::fuzz
