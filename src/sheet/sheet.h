// The data sheet of a car: what its parameters make of it, number by number.
//
// One table names every number, its unit, its formula, the parameters that it comes from, and the function that
// computes it; text, page and JSON are made from that table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tread/vehicle.h"

namespace tread::sheet {

struct SheetRow {
    std::string_view group;                 // "Handling"
    std::string_view name;                  // "understeer_gradient"
    std::string_view label;                 // "understeer gradient"
    std::string_view unit;                  // of the value; "-" for pure numbers
    std::string_view formula;               // in one line
    std::vector<std::string_view> sources;  // paths of parameters, or beginnings of them
    std::string_view say = {};              // what the sheet says first, "{}" for the value and its unit
    double value = 0;                       // NaN: there is none
    std::string note = {};                  // what the number alone does not say
};

// What the letters in the formulas mean.
inline constexpr std::string_view kSymbols =
    "m, J: mass, yaw inertia; L, a, b: wheelbase, centre of gravity to front and rear axle; h: its height; t: track; "
    "ms, mu: sprung and unsprung mass; ks, kt: rates of spring and tyre; c, ct: their damping; z, w: rise of body and "
    "wheel; K: understeer gradient (in roll: roll stiffness); v: speed; i: steering ratio; z in g: deceleration";

// A curve of points.
struct SheetCurve {
    std::string name;
    std::vector<double> x, y;
};

struct Sheet {
    std::string name;  // of the car
    std::vector<SheetRow> rows;
    std::vector<SheetCurve> braking;  // rear over front brake force, both over the weight: installed, ideal
};

Sheet sheetOf(const VehicleParams& params);

}  // namespace tread::sheet
