// Brakes: from the pedal to the pressures, and to the torque that each wheel's brake can hold.
#pragma once

#include "tread/anti_lock.h"
#include "tread/api.h"
#include "tread/curve.h"
#include "tread/describe.h"
#include "tread/stability_control.h"
#include "tread/state_parts.h"
#include "tread/wheels.h"

namespace tread {

// A valve that lets the pressure of the rear axle rise less above its knee.
struct ProportioningParams {
    double knee = 0;
    double slope = 1;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(knee),
              About{"Pa", "pressure above which the rear pressure rises by `slope`", kNonNegative}.usually(1e5, 2e7));
        field(TREAD_FIELD(slope), About{"-", "rise of the rear over the front pressure above the knee", kFraction});
    }
};
static_assert(describesEveryMember<ProportioningParams>());

// One disc as a lump of one temperature: heat_capacity dT/dt = power - (cooling + cooling_by_speed v) (T - ambient).
// The default capacity is that of 8 kg of iron, a guess.
struct DiscParams {
    double heat_capacity = 4000;
    double cooling = 0;
    double cooling_by_speed = 0;
    Curve friction{};
    double fade = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(heat_capacity),
              About{"J/K", "heat capacity (0: it stays cold)", kNonNegative, 0.2}.usually(1, 2e5));
        field(TREAD_FIELD(cooling), About{"W/K", "heat given off at standstill", kNonNegative, 0.3}.usually(0, 1000));
        field(TREAD_FIELD(cooling_by_speed),
              About{"J/(m K)", "increase of the cooling with speed", kNonNegative, 0.3}.usually(0, 500));
        field(TREAD_FIELD(friction),
              About{"-", "factor on the brake torque versus disc temperature (fade); none: 1", kNonNegative, 0.1, "K"}
                  .usually(0, 2)
                  .over(200, 1500));
        field(TREAD_FIELD(fade), About{"1/K",
                                       "relative loss of brake torque over the heating of the disc, in addition to "
                                       "`friction`: exp(-fade (T - ambient))"}
                                     .usually(-0.01, 0.01));
    }
};
static_assert(describesEveryMember<DiscParams>());

struct BrakeParams {
    double full_pedal_torque = kRequired;
    double front_share = kRequired;
    double full_pedal_pressure = 1e7;
    ProportioningParams rear_proportioning;
    double delay = 0;
    double lag = 0;
    DiscParams front_disc;
    DiscParams rear_disc;
    double ambient_temperature = 293.15;
    double parking_torque = 0;
    AntiLockParams anti_lock;
    StabilityControlParams stability_control;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(full_pedal_torque),
              About{"N m", "brake torque of all four wheels together at full pedal", kNonNegative, 0.1}.usually(0.05,
                                                                                                                2e5));
        field(TREAD_FIELD(front_share), About{"-", "share of the front axle (brake balance)", kFraction, 0.05});
        field(TREAD_FIELD(full_pedal_pressure),
              About{"Pa", "pressure of the master cylinder at full pedal", kPositive}.usually(1e5, 3e7));
        field(TREAD_FIELD(rear_proportioning), About{"", "proportioning valve of the rear axle"});
        field(TREAD_FIELD(delay), About{"s", "time until the pressure follows the pedal", {0, 1}, 0.3});
        field(TREAD_FIELD(lag),
              About{"s", "time constant of the pressure after the delay", kNonNegative, 0.3}.usually(0, 1));
        field(TREAD_FIELD(front_disc), About{"", "each front disc"});
        field(TREAD_FIELD(rear_disc), About{"", "each rear disc"});
        field(TREAD_FIELD(ambient_temperature),
              About{"K", "temperature of the air, and of the discs at the start", kPositive}.usually(220, 340));
        field(TREAD_FIELD(parking_torque),
              About{"N m", "torque of both rear wheels together with the parking brake fully applied", kNonNegative}
                  .usually(0, 1e5));
        field(TREAD_FIELD(anti_lock), About{"", "anti-lock braking (ABS)"});
        field(TREAD_FIELD(stability_control), About{"", "electronic stability control (ESC)"});
    }
};
static_assert(describesEveryMember<BrakeParams>());

struct BrakeState {
    DelayLine pedal;
    PerWheel<double> asked;     // Pa, that the driver and the controllers ask for
    PerWheel<double> pressure;  // Pa
    PerWheel<double> heating;   // K, of the discs above the air
    AntiLockState anti_lock;
    StabilityControlState stability_control;
};

struct BrakeInput {
    double pedal_begin = 0;  // 0 to 1
    double pedal_end = 0;
    double parking_begin = 0;  // 0 to 1
    double parking_end = 0;
    PerWheel<double> spin{};       // rad/s
    PerWheel<double> speed{};      // m/s, of each wheel over ground along its heading
    PerWheel<double> rolling{};    // m/s, spin times effective rolling radius
    PerAxle<double> recovered{};   // N m, of each wheel of the axle, that a motor brakes in place of the brake
    PerWheel<double> commanded{};  // N m, besides what pedal and controllers ask for
    PerWheel<double> drag{};       // N m, of a brake that does not release its wheel
    StabilityControlInput car{};
};

// Torque that the brake of each wheel holds or drags with, N m, not negative.
struct BrakeTorques {
    PerWheel<double> end;   // of the step
    PerWheel<double> mean;  // over it
};

TREAD_API BrakeTorques advance(BrakeState& state, const BrakeParams& params, const BrakeInput& input, double dt);

}  // namespace tread
