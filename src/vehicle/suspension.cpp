#include "tread/suspension.h"

#include <cassert>
#include <numbers>

#include "vehicle/suspension_forces.h"

namespace tread {
namespace {

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

Line<double> along(const Curve& curve, double x) {
    const auto& points = curve.points;
    assert(points.size() > 1);
    std::size_t right = 1;
    while (right + 1 < points.size() && points[right].x < x) ++right;
    const Curve::Point &a = points[right - 1], &b = points[right];
    const double slope = (b.y - a.y) / (b.x - a.x);
    return {a.y + slope * (x - a.x), slope};
}

SuspensionForce forces(const SuspensionParams& params, const SuspensionInput& input) {
    return suspensionForces(params, input);
}

WheelAngles angles(const SuspensionParams& params, double travel, bool left) {
    return suspensionAngles(params, travel, left);
}

WheelAngles compliance(const SuspensionParams& params, double fx, double fy, bool left) {
    return suspensionCompliance(params, fx, fy, left);
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
