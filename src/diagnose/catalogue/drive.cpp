// Effects of driveline and brakes.

#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {
namespace {

// The brake of one wheel that does not release it.
Effect draggingBrake(const std::string& axle, const std::string& side) {
    return {.name = "brake_drag_" + axle + "_" + side,
            .question = "Does the " + axle + " " + side + " brake drag with the pedal released (stuck caliper)?",
            .source = "guess: a good brake drags with 2 to 5 N m, one that gets hot on the road with 50 to 150 N m",
            .knobs = {{.paths = {axle + "." + side + ".brake_drag"}, .typical = 60, .direction = Direction::up}}};
}

}  // namespace

std::vector<Effect> drivelineEffects() {
    return {
        {.name = "drive_gain",
         .question = "Does the engine or motor deliver more or less torque for the same pedal position or command?",
         .source = "guess: scatter between engines of one type, weather and fuel: up to 10 %",
         .knobs = {{.paths = {"driveline.engine.torque_scale", "driveline.motor.torque", "driveline.motor.power",
                              "instruments.command.gain"},
                    .typical = 0.1,
                    .relative = true}}},
        {.name = "engine_braking",
         .question = "Is the drag torque or regeneration with the throttle closed larger or smaller?",
         .source = "guess: a cold engine drags about 50 % more than a warm one",
         .knobs = {{.paths = {"driveline.engine.drag_scale", "driveline.motor.lift_off_regeneration"},
                    .typical = 0.3,
                    .relative = true}}},
        {.name = "drive_response",
         .question = "Does the drive torque follow the pedal, or the force a command, with a lag?",
         .source = "guess: 0.05 s (naturally aspirated) to 0.3 s (turbocharged); 0.1 s behind a command",
         .knobs = {{.paths = {"driveline.engine.response_time", "driveline.motor.response_time",
                              "instruments.command.lag"},
                    .typical = 0.12,
                    .direction = Direction::up}}},
        {.name = "drive_delay",
         .question = "Does the longitudinal force of an automated car answer its command after a dead time?",
         .source = "guess: 0.05 s of bus and control unit",
         .knobs = {{.paths = {"instruments.command.delay"}, .typical = 0.05, .direction = Direction::up}}},
        {.name = "differential_locking",
         .question = "Does a differential lock partially (limited slip)? Not for locked or torque-vectoring ones.",
         .source = "guess: from 0.1 (friction of an open differential) to 0.33 (torque bias ratio of 2)",
         .knobs = {{.paths = {"driveline.front_differential.open.locking",
                              "driveline.front_differential.limited_slip.locking_driving",
                              "driveline.front_differential.limited_slip.locking_coasting",
                              "driveline.rear_differential.open.locking",
                              "driveline.rear_differential.limited_slip.locking_driving",
                              "driveline.rear_differential.limited_slip.locking_coasting"},
                    .typical = 0.2,
                    .direction = Direction::up}}},
        {.name = "shaft_stiffness",
         .question = "Is the torsional stiffness of the drive shafts higher or lower?",
         .source = "guess",
         .knobs = {{.paths = {"driveline.shaft_stiffness"}, .typical = 0.35, .relative = true}}},
    };
}

std::vector<Effect> brakeEffects() {
    return {
        {.name = "brake_gain",
         .question = "Do the brakes deliver more or less torque for the same pedal position?",
         .source = "guess: pad friction varies by 10 % with batch and bedding-in",
         .knobs = {{.paths = {"brakes.full_pedal_torque"}, .typical = 0.12, .relative = true}}},
        {.name = "brake_balance",
         .question = "Is the front share of the brake torque larger or smaller?",
         .source = "guess: different pads on one axle",
         .knobs = {{.paths = {"brakes.front_share"}, .typical = 0.06}}},
        {.name = "brake_fade",
         .question = "Do the brakes fade when the discs get hot? The discs need a heat capacity.",
         .source = "guess: a fifth of the torque lost at a temperature rise of 200 K",
         .knobs = {{.paths = {"brakes.front_disc.fade", "brakes.rear_disc.fade"},
                    .typical = 0.001,
                    .direction = Direction::up}}},
        {.name = "brake_delay",
         .question = "Do the brakes respond late to the pedal (delay, lag)?",
         .source = "guess: 0.05 to 0.15 s with a vacuum booster",
         .knobs = {{.paths = {"brakes.delay"}, .typical = 0.06, .direction = Direction::up},
                   {.paths = {"brakes.lag"}, .typical = 0.06, .direction = Direction::up}}},
        draggingBrake("front", "left"),
        draggingBrake("front", "right"),
        draggingBrake("rear", "left"),
        draggingBrake("rear", "right"),
        {.name = "anti_lock",
         .question = "Does the car have active anti-lock brakes (ABS) although its file has none?",
         .source = "definition: 1 is full intervention",
         .knobs = {{.paths = {"brakes.anti_lock.authority_offset"}, .typical = 1, .direction = Direction::up}},
         .at_limit = true},
        {.name = "stability_control",
         .question = "Does the car have active stability control (ESC) although its file has none?",
         .source = "definition: 1 is full intervention",
         .knobs = {{.paths = {"brakes.stability_control.authority_offset"}, .typical = 1, .direction = Direction::up}},
         .at_limit = true},
    };
}

}  // namespace tread::diagnose::catalogue
