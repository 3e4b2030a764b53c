// Described structs of every kind, for the tests of what visits descriptions.
#pragma once

#include <array>
#include <string_view>

#include "tread/describe.h"

// Not an anonymous namespace: clang 14 wants to see conversions to a type without linkage defined.
namespace tread::sample {

struct Damper {
    double bump = kRequired;
    double friction = 0;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(bump), About{"N s/m", "damping in compression", kNonNegative});
        field(TREAD_FIELD(friction), About{"N", "dry friction", kNonNegative});
    }
};
static_assert(describesEveryMember<Damper>());

// Alternatives of a variant.
struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    double start = 0;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(to), About{"rad", "final angle"});
        field(TREAD_FIELD(start), About{"s", "begin of the ramp"});
    }
};
static_assert(describesEveryMember<Ramp>());

struct Keep {
    static constexpr std::string_view kName = "keep";
    double tolerance = 0.5;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tolerance), About{"-", "how closely", kFraction});
    }
};
static_assert(describesEveryMember<Keep>());

enum class Drive { front, rear, all };
constexpr auto enumNames(Drive) {
    return std::array<std::string_view, 3>{"front", "rear", "all"};
}

}  // namespace tread::sample
