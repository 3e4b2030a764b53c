// Effects of driveline and brakes.

#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> drivelineEffects() {
    return {
        {.name = "drive_gain",
         .question = "Does the engine or motor give more or less torque for the same pedal?",
         .source = "guess: engines of one type, weather and fuel differ by up to 10 %",
         .knobs = {{.paths = {"driveline.engine.torque_scale", "driveline.motor.torque", "driveline.motor.power"},
                    .typical = 0.1,
                    .relative = true}}},
        {.name = "engine_braking",
         .question = "Does the engine or motor drag more or less with the throttle closed?",
         .source = "guess: drag grows by half from a warm to a cold engine",
         .knobs = {{.paths = {"driveline.engine.drag_scale", "driveline.motor.lift_off_regeneration"},
                    .typical = 0.3,
                    .relative = true}}},
        {.name = "drive_response",
         .question = "Does the drive torque follow the pedal late?",
         .source = "guess: 0.05 to 0.3 s, naturally aspirated to charged",
         .knobs = {{.paths = {"driveline.engine.response_time", "driveline.motor.response_time"},
                    .typical = 0.12,
                    .direction = Direction::up}}},
        {.name = "differential_locking",
         .question = "Does a differential hold its wheels together (limited slip)? Not for a locked one or vectoring.",
         .source = "guess: from the friction of an open one, 0.1, to a torque bias ratio of 2, 0.33",
         .knobs = {{.paths = {"driveline.front_differential.open.locking",
                              "driveline.front_differential.limited_slip.locking_driving",
                              "driveline.front_differential.limited_slip.locking_coasting",
                              "driveline.rear_differential.open.locking",
                              "driveline.rear_differential.limited_slip.locking_driving",
                              "driveline.rear_differential.limited_slip.locking_coasting"},
                    .typical = 0.2,
                    .direction = Direction::up}}},
        {.name = "shaft_stiffness",
         .question = "Do the drive shafts twist more or less?",
         .source = "guess",
         .knobs = {{.paths = {"driveline.shaft_stiffness"}, .typical = 0.35, .relative = true}}},
    };
}

std::vector<Effect> brakeEffects() {
    return {
        {.name = "brake_gain",
         .question = "Do the brakes give more or less torque for the same pedal?",
         .source = "guess: friction of pads differs by 10 % with batch and bedding",
         .knobs = {{.paths = {"brakes.full_pedal_torque"}, .typical = 0.12, .relative = true}}},
        {.name = "brake_balance",
         .question = "Does the front axle take more or less of the braking?",
         .source = "guess: other pads on one axle",
         .knobs = {{.paths = {"brakes.front_share"}, .typical = 0.06}}},
        {.name = "brake_fade",
         .question = "Do the brakes fade as their discs get hot? Needs a disc with a heat capacity.",
         .source = "guess: a fifth of the torque lost at 200 K",
         .knobs = {{.paths = {"brakes.front_disc.fade", "brakes.rear_disc.fade"},
                    .typical = 0.001,
                    .direction = Direction::up}}},
        {.name = "brake_delay",
         .question = "Do the brakes follow the pedal late (delay and lag)?",
         .source = "guess: 0.05 to 0.15 s with a vacuum booster",
         .knobs = {{.paths = {"brakes.delay"}, .typical = 0.06, .direction = Direction::up},
                   {.paths = {"brakes.lag"}, .typical = 0.06, .direction = Direction::up}}},
        {.name = "anti_lock",
         .question = "Does the car have anti-lock brakes (ABS) that intervene, though its file says no?",
         .source = "definition: 1 is all of its intervention",
         .knobs = {{.paths = {"brakes.anti_lock.authority_offset"}, .typical = 1, .direction = Direction::up}}},
        {.name = "stability_control",
         .question = "Does the car have a stability control (ESC) that brakes single wheels, though its file says no?",
         .source = "definition: 1 is all of its intervention",
         .knobs = {{.paths = {"brakes.stability_control.authority_offset"}, .typical = 1, .direction = Direction::up}}},
    };
}

}  // namespace tread::diagnose::catalogue
