// Effects of body, air and road.

#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> bodyEffects() {
    return {
        {.name = "mass",
         .question = "Is the car heavier or lighter (load, fuel, passengers)?",
         .source = "calculated: two persons in a car of 1.4 t",
         .knobs = {{.paths = {"mass"}, .typical = 0.1, .relative = true}}},
        {.name = "yaw_inertia",
         .question = "Does the car resist turning about the vertical more or less?",
         .source = "guess: estimates from mass and wheelbase are off by about 10 %",
         .knobs = {{.paths = {"inertia.yaw"}, .typical = 0.1, .relative = true}}},
        {.name = "roll_inertia",
         .question = "Does the body resist rolling more or less?",
         .source = "guess: estimates are off by about 15 %, roof load",
         .knobs = {{.paths = {"inertia.roll"}, .typical = 0.2, .relative = true}}},
        {.name = "pitch_inertia",
         .question = "Does the body resist pitching more or less?",
         .source = "guess: estimates are off by about 15 %",
         .knobs = {{.paths = {"inertia.pitch"}, .typical = 0.15, .relative = true}}},
        {.name = "cg_fore_aft",
         .question = "Does the centre of gravity lie further to the front or rear?",
         .source = "calculated: 100 kg in the boot of a car of 1.4 t",
         .knobs = {{.paths = {"front_axle_distance"}, .typical = 0.1}}},
        {.name = "cg_height",
         .question = "Does the centre of gravity lie higher or lower?",
         .source = "guess: roof load, or an estimate that is off by 10 %",
         .knobs = {{.paths = {"centre_of_gravity_height"}, .typical = 0.06}}},
        {.name = "load_offset",
         .question = "Does the load lie off the middle, to the left or right?",
         .source = "calculated: driver alone, 80 kg 0.38 m off the middle of 1.4 t",
         .knobs = {{.paths = {"lateral_offset"}, .typical = 0.025}}},
    };
}

std::vector<Effect> surroundingsEffects() {
    return {
        {.name = "aero_drag",
         .question = "Does the air hold the car back more or less?",
         .source = "guess: roof box, open windows, or a data sheet that flatters",
         .knobs = {{.paths = {"aero.drag_area"}, .typical = 0.12}}},
        {.name = "aero_lift",
         .question = "Does the air lift or press the axles more or less?",
         .source = "guess: lift coefficients of cars lie between -0.05 and 0.15 an axle",
         .knobs = {{.paths = {"aero.front_lift_area"}, .typical = 0.15},
                   {.paths = {"aero.rear_lift_area"}, .typical = 0.15}}},
        {.name = "wind",
         .question = "Was there a steady wind?",
         .source = "guess: a light to moderate breeze, 3 to 6 m/s",
         .knobs = {{.paths = {"wind.x"}, .typical = 4}, {.paths = {"wind.y"}, .typical = 4}}},
        {.name = "grade",
         .question = "Does the road rise or fall?",
         .source = "guess: proving grounds are level within about 1 %",
         .knobs = {{.paths = {"road.grade"}, .typical = 0.01}}},
        {.name = "bank",
         .question = "Does the road lean to a side?",
         .source = "guess: roads are banked by 1.5 to 2.5 % for drainage",
         .knobs = {{.paths = {"road.bank"}, .typical = 0.015}}},
    };
}

}  // namespace tread::diagnose::catalogue
