#include "tread/suspension.h"

#include <cmath>

namespace tread {
namespace {

// Speed over which dry friction builds up. Small enough to be dry, large enough for the implicit wheel equation.
constexpr double kFrictionSpeed = 0.005;  // m/s

struct Push {
    double force = 0;
    double stiffness = 0;
};

// Force of a stop that is compressed by `deflection`.
Push push(const StopParams& stop, double deflection) {
    if (deflection <= 0) return {};
    return {(stop.stiffness + stop.progression * deflection) * deflection,
            stop.stiffness + 2 * stop.progression * deflection};
}

}  // namespace

SuspensionForce forces(const SuspensionParams& params, const SuspensionInput& input) {
    // Spring: carries the static load at zero travel, and cannot pull.
    SuspensionForce total{0, 0, 0};
    const double spring = input.static_force + params.spring * input.travel;
    if (spring > 0) total = {spring, params.spring, 0};

    // Damper and dry friction.
    const double damping = input.rate > 0 ? params.damper.bump : params.damper.rebound;
    const double slide = std::tanh(input.rate / kFrictionSpeed);
    total.force += damping * input.rate + params.damper.friction * slide;
    total.by_rate += damping + params.damper.friction / kFrictionSpeed * (1 - slide * slide);

    // Anti-roll bar.
    total.force += params.anti_roll_bar * (input.travel - input.opposite_travel);
    total.by_travel += params.anti_roll_bar;

    // Stops.
    const Push bump = push(params.bump_stop, input.travel - params.bump_stop.clearance);
    const Push rebound = push(params.rebound_stop, -input.travel - params.rebound_stop.clearance);
    total.force += bump.force - rebound.force;
    total.by_travel += bump.stiffness + rebound.stiffness;
    return total;
}

WheelAngles angles(const SuspensionParams& params, double travel, bool left) {
    const double outwards = left ? -1 : 1;
    return {.camber = outwards * (params.camber + params.camber_by_travel * travel),
            .toe = outwards * (params.toe + params.toe_by_travel * travel)};
}

}  // namespace tread
