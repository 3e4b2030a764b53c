// The units that the section [UNITS] of a .tir file may name, with their size in SI.
#pragma once

#include <string_view>

namespace tread {

struct TirUnit {
    std::string_view name;
    double si;
};
inline constexpr TirUnit kTirLengths[] = {
    {"M", 1},       {"METER", 1},         {"METERS", 1},         {"METRE", 1},
    {"MM", 1e-3},   {"MILLIMETER", 1e-3}, {"MILLIMETERS", 1e-3}, {"MILLIMETRE", 1e-3},
    {"CM", 1e-2},   {"CENTIMETER", 1e-2}, {"KM", 1e3},           {"KILOMETER", 1e3},
    {"IN", 0.0254}, {"INCH", 0.0254},     {"FT", 0.3048},        {"FOOT", 0.3048}};
inline constexpr TirUnit kTirForces[] = {{"N", 1},
                                         {"NEWTON", 1},
                                         {"NEWTONS", 1},
                                         {"KN", 1e3},
                                         {"KILONEWTON", 1e3},
                                         {"KNEWTON", 1e3},
                                         {"KGF", 9.80665},
                                         {"KILOGRAM_FORCE", 9.80665},
                                         {"LBF", 4.4482216152605},
                                         {"POUND_FORCE", 4.4482216152605}};
inline constexpr TirUnit kTirTimes[] = {{"S", 1},       {"SEC", 1},    {"SECOND", 1},
                                        {"SECONDS", 1}, {"MS", 1e-3},  {"MILLISECOND", 1e-3},
                                        {"MIN", 60},    {"MINUTE", 60}};
// The coefficients of camber are per radian; a file in degrees would not say whether its coefficients are, too.
inline constexpr TirUnit kTirAngles[] = {{"RAD", 1}, {"RADIAN", 1}, {"RADIANS", 1}};

}  // namespace tread
