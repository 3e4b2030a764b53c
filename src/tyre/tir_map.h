// How the keys of an ISO .tir file (MF 5.0 to 5.2, PAC2002) map to the paper's parameters in its axes (y right, z
// down).
//
// With the axes turned, Fy, My and Mz change sign, alpha and camber do not. D is the sign of PDY1: +1 in .tir files, -1
// in the tables of Pacejka's books.
#pragma once

#include <numbers>
#include <string_view>

#include "tread/tyre.h"

namespace tread {

// What the value of a key is multiplied by to give the paper's parameter.
enum class TirRule {
    same,
    minus,
    d,
    minus_d,
    two_over_pi,  // the paper has arctan(..) in (67) where MF 5.2 has (2/pi) arctan(..)
    radius,       // moments over Fz: MF 5.2 divides by R0
    minus_radius,
    radius_per_load,  // ... and by the nominal load
    minus_radius_per_load,
    length,  // dimensions: from the units of the file
    force,
    stiffness,
    damping,
};

struct TirKey {
    std::string_view key;
    double TyreCoefficients::*parameter;
    TirRule rule;
};

// What the factors depend on; SI.
struct TirScale {
    double d = 1;
    double radius = 1;
    double nominal_load = 1;
    double length = 1;  // of the file's unit
    double force = 1;
    double time = 1;
};

constexpr double factor(TirRule rule, const TirScale& scale) {
    using enum TirRule;
    switch (rule) {
        case same:
            return 1;
        case minus:
            return -1;
        case d:
            return scale.d;
        case minus_d:
            return -scale.d;
        case two_over_pi:
            return 2 / std::numbers::pi;
        case radius:
            return scale.radius;
        case minus_radius:
            return -scale.radius;
        case radius_per_load:
            return scale.radius / scale.nominal_load;
        case minus_radius_per_load:
            return -scale.radius / scale.nominal_load;
        case length:
            return scale.length;
        case force:
            return scale.force;
        case stiffness:
            return scale.force / scale.length;
        case damping:
            return scale.force * scale.time / scale.length;
    }
    return 1;
}

namespace tir {

using C = TyreCoefficients;
using enum TirRule;

// A key is required where the paper's parameter has no default.
inline constexpr TirKey kCoefficients[] = {{"FNOMIN", &C::Fzo, force},
                                           {"UNLOADED_RADIUS", &C::Ro, length},
                                           {"VERTICAL_STIFFNESS", &C::pz1, stiffness},
                                           {"VERTICAL_DAMPING", &C::pz2, damping},
                                           {"PCX1", &C::pCx1, same},
                                           {"PDX1", &C::pDx1, same},
                                           {"PDX2", &C::pDx2, same},
                                           {"PEX1", &C::pEx1, same},
                                           {"PEX2", &C::pEx2, same},
                                           {"PEX3", &C::pEx3, same},
                                           {"PEX4", &C::pEx4, same},
                                           {"PKX1", &C::pKx1, same},
                                           {"PKX2", &C::pKx2, same},
                                           {"PKX3", &C::pKx3, minus},
                                           {"PHX1", &C::pHx1, same},
                                           {"PHX2", &C::pHx2, same},
                                           {"PVX1", &C::pVx1, same},
                                           {"PVX2", &C::pVx2, same},
                                           {"RBX1", &C::rBx1, same},
                                           {"RBX2", &C::rBx2, same},
                                           {"RCX1", &C::rCx1, same},
                                           {"RHX1", &C::rHx1, same},
                                           {"PCY1", &C::pCy1, same},
                                           {"PDY1", &C::pDy1, d},
                                           {"PDY2", &C::pDy2, d},
                                           {"PDY3", &C::pDy3, same},
                                           {"PEY1", &C::pEy1, same},
                                           {"PEY2", &C::pEy2, same},
                                           {"PEY3", &C::pEy3, same},
                                           {"PEY4", &C::pEy4, same},
                                           {"PKY1", &C::pKy1, minus},
                                           {"PKY2", &C::pKy2, same},
                                           {"PKY3", &C::pKy3, same},
                                           {"PHY1", &C::pHy1, same},
                                           {"PHY2", &C::pHy2, same},
                                           {"PHY3", &C::pHy3, same},
                                           {"PVY1", &C::pVy1, minus},
                                           {"PVY2", &C::pVy2, minus},
                                           {"PVY3", &C::pVy3, minus},
                                           {"PVY4", &C::pVy4, minus},
                                           {"RBY1", &C::rBy1, same},
                                           {"RBY2", &C::rBy2, same},
                                           {"RBY3", &C::rBy3, same},
                                           {"RCY1", &C::rCy1, same},
                                           {"RHY1", &C::rHy1, same},
                                           {"RVY1", &C::rVy1, minus_d},
                                           {"RVY2", &C::rVy2, minus_d},
                                           {"RVY3", &C::rVy3, minus_d},
                                           {"RVY4", &C::rVy4, same},
                                           {"RVY5", &C::rVy5, same},
                                           {"RVY6", &C::rVy6, same},
                                           {"QBZ1", &C::qBz1, same},
                                           {"QBZ2", &C::qBz2, same},
                                           {"QBZ3", &C::qBz3, same},
                                           {"QBZ4", &C::qBz4, same},
                                           {"QBZ5", &C::qBz5, same},
                                           {"QBZ9", &C::qBz9, same},
                                           {"QBZ10", &C::qBz10, minus_d},
                                           {"QCZ1", &C::qCz1, same},
                                           {"QDZ1", &C::qDz1, same},
                                           {"QDZ2", &C::qDz2, same},
                                           {"QDZ3", &C::qDz3, same},
                                           {"QDZ4", &C::qDz4, same},
                                           {"QDZ6", &C::qDz6, minus},
                                           {"QDZ7", &C::qDz7, minus},
                                           {"QDZ8", &C::qDz8, minus},
                                           {"QDZ9", &C::qDz9, minus},
                                           {"QEZ1", &C::qEz1, same},
                                           {"QEZ2", &C::qEz2, same},
                                           {"QEZ3", &C::qEz3, same},
                                           {"QEZ4", &C::qEz4, two_over_pi},
                                           {"QEZ5", &C::qEz5, two_over_pi},
                                           {"QHZ1", &C::qHz1, same},
                                           {"QHZ2", &C::qHz2, same},
                                           {"QHZ3", &C::qHz3, same},
                                           {"QHZ4", &C::qHz4, same},
                                           {"SSZ1", &C::ssz1, minus},
                                           {"SSZ2", &C::ssz2, same},
                                           {"SSZ3", &C::ssz3, minus},
                                           {"SSZ4", &C::ssz4, minus},
                                           {"QSX3", &C::qx1, minus_radius_per_load},
                                           {"QSX2", &C::qx2, minus_radius},
                                           {"QSY1", &C::qy1, radius},
                                           {"QSY2", &C::qy2, radius_per_load}};

struct ScalingKey {
    std::string_view key;
    double TyreScaling::*parameter;
};

using S = TyreScaling;
inline constexpr ScalingKey kScaling[] = {
    {"LFZO", &S::Fzo}, {"LCX", &S::Cx},    {"LMUX", &S::mux}, {"LEX", &S::Ex},  {"LKX", &S::Kx},  {"LHX", &S::Hx},
    {"LVX", &S::Vx},   {"LCY", &S::Cy},    {"LMUY", &S::muy}, {"LEY", &S::Ey},  {"LKY", &S::Ky},  {"LHY", &S::Hy},
    {"LVY", &S::Vy},   {"LGAY", &S::gy},   {"LTR", &S::t},    {"LRES", &S::Mr}, {"LGAZ", &S::gz}, {"LXAL", &S::xa},
    {"LYKA", &S::yk},  {"LVYKA", &S::Vyk}, {"LS", &S::s},     {"LMX", &S::Mx},  {"LMY", &S::My},  {"LCZ", &S::Cz}};

// Terms that the 1997 model does not have, with the value that takes them out of MF 5.2 or PAC2002.
struct ForeignKey {
    std::string_view key;
    double neutral;
};
inline constexpr ForeignKey kForeign[] = {{"PDX3", 0},
                                          {"REX1", 0},
                                          {"REX2", 0},
                                          {"REY1", 0},
                                          {"REY2", 0},
                                          {"RHY2", 0},
                                          {"QSX1", 0},
                                          {"QSY3", 0},
                                          {"QSY4", 0},
                                          {"LGAX", 1},
                                          {"LVMX", 1},
                                          {"LSGKP", 1},
                                          {"LSGAL", 1},
                                          {"LGYR", 1},
                                          {"LKG", 1},
                                          {"QSX4", 0},
                                          {"QSX5", 0},
                                          {"QSX6", 0},
                                          {"QSX7", 0},
                                          {"QSX8", 0},
                                          {"QSX9", 0},
                                          {"QSX10", 0},
                                          {"QSX11", 0},
                                          {"QSY5", 0},
                                          {"QSY6", 0},
                                          {"QSY7", 0},
                                          {"QSY8", 0},
                                          {"PKY4", 2},
                                          {"PKY5", 0},
                                          {"PKY6", 0},
                                          {"PKY7", 0},
                                          {"QTZ1", 0},
                                          {"MBELT", 0},
                                          {"DYNAMIC_STIFFNESS", 0},
                                          {"DYNAMIC_DAMPING", 0},
                                          {"PTX4", 0},
                                          {"PTY3", 0}};

}  // namespace tir
}  // namespace tread
