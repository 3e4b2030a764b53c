#include "tread/suspension.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace tread {
namespace {

// Speed over which dry friction builds up. Small enough to be dry, large enough for the implicit wheel equation.
constexpr double kDamperFrictionSpeed = 0.005;  // m/s

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

struct Line {
    double value;
    double slope;
};

// A curve of two points or more, continued beyond its ends with their slopes.
Line along(const Curve& curve, double x) {
    const auto& points = curve.points;
    assert(points.size() > 1);
    std::size_t right = 1;
    while (right + 1 < points.size() && points[right].x < x) ++right;
    const Curve::Point &a = points[right - 1], &b = points[right];
    const double slope = (b.y - a.y) / (b.x - a.x);
    return {a.y + slope * (x - a.x), slope};
}

Line springForce(const SuspensionParams& params, double travel) {
    if (params.spring_curve.empty()) return {params.spring * travel, params.spring};
    return along(params.spring_curve, travel);
}

Line damperForce(const DamperParams& damper, double rate) {
    const bool bump = rate > 0;
    const Curve& curve = bump ? damper.bump_curve : damper.rebound_curve;
    if (!curve.empty()) {
        const Line line = along(curve, bump ? rate : -rate);
        return {bump ? line.value : -line.value, line.slope};
    }
    const double damping = bump ? damper.bump : damper.rebound;
    return {damping * rate, damping};
}

// Spring and damper between wheel and body along x, over the mass of the wheel.
struct Bush {
    double stiffness;  // 1/s2
    double damping;    // 1/s

    Bush(const SuspensionParams& params, double mass)
        : stiffness(1 / (params.longitudinal_compliance * mass)), damping(params.longitudinal_damping / mass) {}
    // Share of a change of rate that the bush lets through in an implicit step of this length.
    double yields(double step) const { return 1 / (1 + step * (damping + step * stiffness)); }
};

}  // namespace

SuspensionForce forces(const SuspensionParams& params, const SuspensionInput& input) {
    // Spring: carries the static load at zero travel, and cannot pull.
    SuspensionForce total{0, 0, 0};
    const Line extra = springForce(params, input.travel);
    const double spring = input.static_force + extra.value;
    if (spring > 0) total = {spring, extra.slope, 0};

    // Damper and dry friction.
    const Line damper = damperForce(params.damper, input.rate);
    double friction = 0, friction_by_rate = 0;
    if (params.damper.friction != 0) {
        const double slide = std::tanh(input.rate / kDamperFrictionSpeed);
        friction = params.damper.friction * slide;
        friction_by_rate = params.damper.friction / kDamperFrictionSpeed * (1 - slide * slide);
    }
    total.force += damper.value + friction;
    total.by_rate += damper.slope + friction_by_rate;

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

WheelAngles compliance(const SuspensionParams& params, double fx, double fy, bool left) {
    WheelAngles lean{.camber = 0, .toe = params.steer_by_lateral_force * fy};
    if (params.steer_by_longitudinal_force != 0) lean.toe += (left ? -1 : 1) * params.steer_by_longitudinal_force * fx;
    // A force to the left pulls the contact to the left: the top leans to the right.
    if (params.camber_by_lateral_force != 0) lean.camber = params.camber_by_lateral_force * fy;
    return lean;
}

void advance(Recession& r, const SuspensionParams& params, double mass, double dt) {
    const Bush bush(params, mass);
    constexpr double kGamma = 1 - 1 / std::numbers::sqrt2;
    const double h = kGamma * dt;
    const auto stage = [&](const Recession& base) {
        Recession end = base;
        end.rate = (base.rate + h * (r.push - bush.stiffness * base.travel)) * bush.yields(h);
        end.travel = base.travel + h * end.rate;
        return end;
    };
    const Recession first = stage(r);
    Recession base = r;
    base.rate += (1 - kGamma) / kGamma * (first.rate - r.rate);
    base.travel += (1 - kGamma) / kGamma * (first.travel - r.travel);
    r = stage(base);
}

void takePush(Recession& r, const SuspensionParams& params, double mass, double push, double dt) {
    const Bush bush(params, mass);
    const double half = 0.5 * dt;
    const double change = half * (push - r.push) * bush.yields(half);
    r.rate += change;
    r.travel += half * change;
    r.push = push;
    r.acceleration = push - bush.stiffness * r.travel - bush.damping * r.rate;
}

}  // namespace tread
