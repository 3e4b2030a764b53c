// The two axis systems in which the program speaks of a tyre, and the one table of what changes sign between them.
//
// The paper has x forward, y to the right, z down; ISO 8855 has x forward, y to the left, z up. One becomes the other
// by half a turn about x: y and z components of velocities, forces and moments change sign, everything along x or about
// x does not. Slips and stiffnesses follow from how each system defines them:
//   - kappa = -Vsx/|Vx| in both.
//   - alpha is the tangent of the slip angle. ISO 8855 counts it positive when the contact centre moves to the left,
//     alpha = +Vsy/|Vx| there; the paper's alpha = -Vsy/|Vx| (33) with Vsy to the right is the same number. So a
//     positive alpha gives a force to the right: Fy > 0 in the paper, Fy < 0 in ISO.
//   - Ky and Kx are positive in both: ISO 8855 defines the cornering stiffness as -dFy/dalpha, the paper as dFy/dalpha.
//   - Mz = -t (Fy - SVyk) + Mzr + s Fx (86) holds in both: t does not change; s, an arm along y, does.
//   - Fz is the size of the normal load and Omega the spin, positive forward, in both.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "base/fields/numbers.h"
#include "tread/tyre.h"
#include "tyre_table.h"

namespace tread::program {

enum class Axes { paper, iso };

struct AxisSign {
    std::string_view column;
    int iso;  // value in ISO 8855 axes = sign * value in the paper's axes
};

inline constexpr std::array kAxisSigns = {
    // Motion and load
    AxisSign{"Fz", +1},
    AxisSign{"gamma", +1},  // a rotation about x: positive leans the top to the right
    AxisSign{"Vx", +1},
    AxisSign{"Vsx", +1},
    AxisSign{"Vsy", -1},
    AxisSign{"Omega", +1},
    AxisSign{"psidot", -1},
    // Forces and moments
    AxisSign{"Fx", +1},
    AxisSign{"Fy", -1},
    AxisSign{"Mx", +1},
    AxisSign{"My", -1},  // a torque that brakes forward rolling is negative in ISO, positive in the paper
    AxisSign{"Mz", -1},
    AxisSign{"Fx0", +1},
    AxisSign{"Fy0", -1},
    AxisSign{"SVyk", -1},
    AxisSign{"Mzr", -1},
    // Arms, stiffnesses, friction, slips
    AxisSign{"t", +1},
    AxisSign{"s", -1},
    AxisSign{"Kx", +1},
    AxisSign{"Ky", +1},
    AxisSign{"mux", +1},
    AxisSign{"muy", +1},
    AxisSign{"kappa", +1},
    AxisSign{"alpha", +1},
    // Contact patch against the rim
    AxisSign{"u", +1},
    AxisSign{"v", -1},
    AxisSign{"du", +1},
    AxisSign{"dv", -1},
};

// From the paper's axes to `axes` or back; 0 for a column that the table does not know.
constexpr int axisSign(std::string_view column, Axes axes) {
    for (const AxisSign& sign : kAxisSigns) {
        if (sign.column == column) return axes == Axes::iso ? sign.iso : 1;
    }
    return 0;
}

template <class T>
constexpr bool hasAxisSigns() {
    bool all = true;
    T object{};
    T::describe(object, [&](std::string_view name, auto&&...) { all = all && axisSign(name, Axes::iso) != 0; });
    return all;
}
static_assert(hasAxisSigns<TyreSlip>() && hasAxisSigns<TyreSteadyState>() && hasAxisSigns<TyreMotion>());

// A column for each field of an object in the paper's axes; the columns are in `axes`.
template <class T>
void addFields(Columns& columns, T& object, Axes axes) {
    static_assert(hasAxisSigns<T>());
    for (const Number& n : numbers(object)) columns.add({n.path, n.about}, *n.value, axisSign(n.path, axes));
}

}  // namespace tread::program
