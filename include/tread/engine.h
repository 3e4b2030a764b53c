// What drives the car: a combustion engine behind a clutch or converter, an electric motor at the gearbox, or both.
#pragma once

#include <vector>

#include "tread/api.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

// ---- Combustion engine ----

// Torque of the engine at one position of the throttle pedal.
struct PartLoadParams {
    double throttle = kRequired;
    Curve torque;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(throttle), About{"-", "throttle pedal", {0, 1, true, true}});
        field(TREAD_FIELD(torque),
              About{"N m", "torque at this pedal position versus engine speed, negative where the engine drags", kAny,
                    0.1, "rad/s"}
                  .usually(-5000, 5000)
                  .over(0, 4000));
    }
};
static_assert(describesEveryMember<PartLoadParams>());

struct EngineParams {
    Curve full_load;
    Curve drag{};
    std::vector<PartLoadParams> part_load;
    double inertia = kRequired;
    double idle_speed = kRequired;
    double speed_limit = kRequired;
    double response_time = 0;
    double torque_scale = 1;
    double drag_scale = 1;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(full_load), About{"N m", "torque at full throttle versus engine speed", kAny, 0.05, "rad/s"}
                                          .usually(-5000, 5000)
                                          .over(0, 4000));
        field(
            TREAD_FIELD(drag),
            About{"N m", "drag torque at closed throttle", kNonNegative, 0.2, "rad/s"}.usually(0, 2000).over(0, 4000));
        field(
            TREAD_FIELD(part_load),
            About{"", "torque at throttles between closed and full, rising; none: linear between drag and full_load"});
        field(TREAD_FIELD(inertia), About{"kg m2", "inertia of engine and flywheel", kPositive, 0.2}.usually(1e-6, 10));
        field(TREAD_FIELD(idle_speed), About{"rad/s", "idle speed", kPositive}.usually(30, 600));
        field(TREAD_FIELD(speed_limit), About{"rad/s", "speed at which the fuel is cut", kPositive}.usually(100, 4000));
        field(TREAD_FIELD(response_time),
              About{"s", "time constant with which the torque follows the pedal", kNonNegative, 0.3}.usually(0, 3));
        field(TREAD_FIELD(torque_scale), About{"-", "factor on full_load and part_load", kNonNegative}.usually(0, 5));
        field(TREAD_FIELD(drag_scale),
              About{"-", "factor on drag and on the drag of part_load", kNonNegative}.usually(0, 5));
    }

    static void check(const auto& self, auto&& complain) {
        for (std::size_t i = 1; i < self.part_load.size(); ++i) {
            if (self.part_load[i].throttle <= self.part_load[i - 1].throttle)
                complain("part_load", "the throttle of each entry must be larger than that of the one before");
        }
    }
};
static_assert(describesEveryMember<EngineParams>());

// Net torque at the crankshaft, idle control included. The idle control asks for a torque that falls with speed and is
// none at idle speed; the engine gives the larger of what it and the pedal ask for, so idling is an equilibrium.
TREAD_API double engineTorque(const EngineParams& engine, double throttle, double speed);

// The throttle at which the engine gives a torque; outside 0 to 1 it cannot. Negative where the idle control gives
// more.
TREAD_API double throttleFor(const EngineParams& engine, double torque, double speed);

// ---- Electric motor ----

struct MotorParams {
    double torque = kRequired;
    double power = kRequired;
    double speed_limit = kRequired;
    double no_load_speed = 0;
    double throttle_dead_band = 0;
    double inertia = kRequired;
    Curve drag{};
    double lift_off_regeneration = 0;
    double brake_regeneration = 0;
    double regeneration_speed = 30;
    double response_time = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(torque),
              About{"N m", "largest torque, driving and regenerating", kPositive, 0.05}.usually(0.005, 1e4));
        field(TREAD_FIELD(power),
              About{"W", "largest power at the shaft, driving and regenerating", kPositive, 0.05}.usually(1, 2e6));
        field(TREAD_FIELD(speed_limit), About{"rad/s", "speed at which it stops driving", kPositive}.usually(30, 8000));
        field(TREAD_FIELD(no_load_speed),
              About{"rad/s",
                    "speed to which the driving torque falls linearly, by the back-voltage of a motor without current "
                    "control; 0: it does not fall",
                    kNonNegative}
                  .usually(30, 8000));
        field(TREAD_FIELD(throttle_dead_band),
              About{"-", "throttle up to which it does not drive", {0, 1, false, true}});
        field(TREAD_FIELD(inertia), About{"kg m2", "inertia of the rotor", kPositive, 0.2}.usually(1e-8, 5));
        field(TREAD_FIELD(drag),
              About{"N m", "drag torque of the unpowered motor", kNonNegative, 0.3, "rad/s"}.usually(0, 200).over(
                  0, 8000));
        field(TREAD_FIELD(lift_off_regeneration),
              About{"-", "share of the largest torque that it regenerates at closed throttle", kFraction});
        field(TREAD_FIELD(brake_regeneration),
              About{"-", "share of the brake demand that it regenerates, up to its limits", kFraction});
        field(TREAD_FIELD(regeneration_speed),
              About{"rad/s", "speed below which regeneration fades out towards standstill", kPositive}.usually(0.1,
                                                                                                               1000));
        field(TREAD_FIELD(response_time),
              About{"s", "time constant with which the torque follows the pedal", kNonNegative, 0.3}.usually(0, 2));
    }
};
static_assert(describesEveryMember<MotorParams>());

struct MotorTorque {
    double total;      // N m, at the motor's shaft
    double for_brake;  // N m, not negative: part of it that answers the brake pedal
};

// Torque at a speed; `brake` is what the brake pedal leaves to the motor, N m at its shaft, not negative.
TREAD_API MotorTorque motorTorque(const MotorParams& motor, double throttle, double brake, double speed);

// The throttle at which the motor gives a torque; outside 0 to 1 it cannot.
TREAD_API double throttleFor(const MotorParams& motor, double torque, double speed);

}  // namespace tread
