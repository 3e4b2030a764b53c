// Effects of body, air and road.

#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> bodyEffects() {
    return {
        {.name = "mass",
         .question = "Is the car heavier or lighter than the model (load, fuel, passengers)?",
         .source = "calculated: two persons in a 1.4 t car",
         .knobs = {{.paths = {"mass"}, .typical = 0.1, .relative = true}}},
        {.name = "yaw_inertia",
         .question = "Is the yaw moment of inertia larger or smaller?",
         .source = "guess: estimates from mass and wheelbase err by about 10 %",
         .knobs = {{.paths = {"inertia.yaw"}, .typical = 0.1, .relative = true}}},
        {.name = "roll_inertia",
         .question = "Is the roll moment of inertia larger or smaller?",
         .source = "guess: estimates err by about 15 %; roof load",
         .knobs = {{.paths = {"inertia.roll"}, .typical = 0.2, .relative = true}}},
        {.name = "pitch_inertia",
         .question = "Is the pitch moment of inertia larger or smaller?",
         .source = "guess: estimates err by about 15 %",
         .knobs = {{.paths = {"inertia.pitch"}, .typical = 0.15, .relative = true}}},
        {.name = "cg_fore_aft",
         .question = "Is the centre of gravity further forward or rearward?",
         .source = "calculated: 100 kg in the boot of a 1.4 t car",
         .knobs = {{.paths = {"front_axle_distance"}, .typical = 0.1}}},
        {.name = "cg_height",
         .question = "Is the centre of gravity higher or lower?",
         .source = "guess: roof load, or a 10 % error in the estimated height",
         .knobs = {{.paths = {"centre_of_gravity_height"}, .typical = 0.06}}},
        {.name = "load_offset",
         .question = "Is the centre of gravity offset to the left or right?",
         .source = "calculated: 80 kg driver alone, 0.38 m off centre in a 1.4 t car",
         .knobs = {{.paths = {"lateral_offset"}, .typical = 0.025}}},
        {.name = "load",
         .question = "Does the car carry more or less load at some place (mass, centre of gravity and inertia)?",
         .source = "calculated: 100 kg of luggage or passengers, 1.2 m behind and 0.4 m above the centre of gravity",
         .knobs = {{.paths = {"load.mass"}, .typical = 100},
                   {.paths = {"load.moment_x"}, .typical = 120},
                   {.paths = {"load.moment_z"}, .typical = 40}}},
        {.name = "roof_load",
         .question = "Does the car carry a load on its roof?",
         .source = "calculated: permitted roof loads are 50 to 100 kg, about 1 m above the centre of gravity",
         .knobs =
             {{.paths = {"load.mass", "load.moment_z"}, .typical = 60, .direction = Direction::up, .shares = {1, 1}},
              {.paths = {"load.moment_z"}, .typical = 10}}},
        {.name = "fuel",
         .question = "Is the tank fuller or emptier?",
         .source = "calculated: half a tank of 50 l, below the rear seat: 0.9 m behind the centre of gravity and "
                   "0.25 m below it; at most a tank of 75 l",
         .knobs = {{.paths = {"load.mass", "load.moment_x", "load.moment_z"},
                    .typical = 20,
                    .shares = {1, -0.9, -0.25},
                    .largest = 55}}},
    };
}

std::vector<Effect> surroundingsEffects() {
    return {
        {.name = "aero_drag",
         .question = "Is the aerodynamic drag higher or lower?",
         .source = "guess: roof box, open windows, or an optimistic data sheet",
         .knobs = {{.paths = {"aero.drag_area"}, .typical = 0.12}}},
        {.name = "aero_lift",
         .question = "Is the aerodynamic lift at the axles higher or lower?",
         .source = "guess: lift coefficients of passenger cars are -0.05 to 0.15 per axle",
         .knobs = {{.paths = {"aero.front_lift_area"}, .typical = 0.15},
                   {.paths = {"aero.rear_lift_area"}, .typical = 0.15}}},
        {.name = "wind",
         .question = "Was there a steady wind?",
         .source = "guess: light to moderate breeze, 3 to 6 m/s",
         .knobs = {{.paths = {"wind.x"}, .typical = 4}, {.paths = {"wind.y"}, .typical = 4}}},
        {.name = "grade",
         .question = "Is the road uphill or downhill?",
         .source = "guess: proving grounds are level to within about 1 %",
         .knobs = {{.paths = {"road.grade"}, .typical = 0.01}}},
        {.name = "bank",
         .question = "Does the road have a crossfall?",
         .source = "guess: roads have a crossfall of 1.5 to 2.5 % for drainage",
         .knobs = {{.paths = {"road.bank"}, .typical = 0.015}}},
    };
}

}  // namespace tread::diagnose::catalogue
