// Differentials: what they move from one output to the other besides sharing the torque.
//
// The torque that goes through a differential is shared half and half (the centre one: front_share); a differential
// that is not open moves torque from the faster to the slower output. That torque is found with the inertia of what
// hangs on both outputs, so that it brings their speeds together at the end of a step and never past each other: an
// equal and opposite pair, which conserves momentum, and constant over the step of the tyres as the torque of the
// driveline is.
#pragma once

#include <string_view>
#include <variant>

#include "tread/describe.h"

namespace tread {

// Its gears rub: up to the difference of torques of both outputs of locking * (torque through it).
struct OpenDifferential {
    static constexpr std::string_view kName = "open";
    double locking = 0;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(locking),
              About{"-", "torque difference that its friction holds, divided by the torque sum", kFraction});
    }
};
static_assert(describesEveryMember<OpenDifferential>());

// Plates, ramps, torque-sensing gears or a viscous coupling: up to the difference of torques of both outputs of
// preload + locking * (torque through it), and viscosity * (difference of speeds).
struct LimitedSlipDifferential {
    static constexpr std::string_view kName = "limited_slip";
    double preload = 0;
    double locking_driving = 0;
    double locking_coasting = 0;
    double viscosity = 0;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(preload),
              About{"N m", "torque difference that it holds without load", kNonNegative, 0.3}.usually(0, 2000));
        field(
            TREAD_FIELD(locking_driving),
            About{"-",
                  "torque difference that it holds when driving, divided by the torque sum; with the torque bias ratio "
                  "R of a torque-sensing differential (R - 1) / (R + 1)",
                  kFraction, 0.2});
        field(TREAD_FIELD(locking_coasting),
              About{"-", "torque difference that it holds on overrun, divided by the torque sum", kFraction, 0.2});
        field(TREAD_FIELD(viscosity),
              About{"N m s/rad", "torque difference per speed difference", kNonNegative, 0.3}.usually(0, 2000));
    }
};
static_assert(describesEveryMember<LimitedSlipDifferential>());

struct LockedDifferential {
    static constexpr std::string_view kName = "locked";
    static constexpr void describe(auto&, auto&&) {}
};

// Moves torque to the outer wheel of a turn, whatever the speeds: active torque vectoring.
struct VectoringDifferential {
    static constexpr std::string_view kName = "vectoring";
    double by_lateral_acceleration = 0;
    double largest = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(by_lateral_acceleration),
              About{"N m s2/m", "torque difference, outer minus inner wheel, per lateral acceleration"}.usually(-1000,
                                                                                                                1000));
        field(TREAD_FIELD(largest), About{"N m", "largest torque difference", kNonNegative}.usually(0, 1e4));
    }
};
static_assert(describesEveryMember<VectoringDifferential>());

using CentreDifferential = std::variant<OpenDifferential, LimitedSlipDifferential, LockedDifferential>;
using AxleDifferential =
    std::variant<OpenDifferential, LimitedSlipDifferential, LockedDifferential, VectoringDifferential>;

}  // namespace tread
