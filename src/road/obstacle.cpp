// The average of a profile f over [s - a, s + a] is (F(s + a) - F(s - a)) / 2a with its integral F, and its slope
// (f(s + a) - f(s - a)) / 2a: exact for steps, too.

#include "road/obstacle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/math/elementary.h"

namespace tread {
namespace {

// From 0 at s = 0 to 1 at s = rise.
double slopeUp(double s, double rise) {
    return rise > 0 ? std::clamp(s / rise, 0.0, 1.0) : (s >= 0 ? 1.0 : 0.0);
}
double slopeUpIntegral(double s, double rise) {
    if (s <= 0) return 0;
    return s < rise ? 0.5 * s * s / rise : s - 0.5 * rise;
}

}  // namespace

ObstacleSurface::ObstacleSurface(const Obstacle& obstacle)
    : obstacle_(obstacle),
      cosine_(std::holds_alternative<CosineShape>(obstacle.shape)),
      rise_(std::holds_alternative<RampShape>(obstacle.shape) ? std::get<RampShape>(obstacle.shape).rise : 0),
      direction_x_(cosine(obstacle.heading)),
      direction_y_(sine(obstacle.heading)) {}

double ObstacleSurface::profile(double s) const {
    if (s < 0 || s > obstacle_.length) return 0;
    if (cosine_) return 0.5 * (1 - cosine(2 * std::numbers::pi * s / obstacle_.length));
    return slopeUp(s, rise_) - slopeUp(s - (obstacle_.length - rise_), rise_) * (rise_ > 0 ? 1 : 0);
}

double ObstacleSurface::profileSlope(double s) const {
    if (s < 0 || s > obstacle_.length) return 0;
    if (cosine_) {
        const double wave = 2 * std::numbers::pi / obstacle_.length;
        return 0.5 * wave * sine(wave * s);
    }
    if (rise_ <= 0) return 0;
    return s < rise_ ? 1 / rise_ : s > obstacle_.length - rise_ ? -1 / rise_ : 0;
}

double ObstacleSurface::profileIntegral(double s) const {
    if (cosine_) {
        const double within = std::clamp(s, 0.0, obstacle_.length);
        const double wave = 2 * std::numbers::pi / obstacle_.length;
        return 0.5 * (within - sine(wave * within) / wave);
    }
    return slopeUpIntegral(s, rise_) - slopeUpIntegral(s - (obstacle_.length - rise_), rise_);
}

ObstacleSurface::Value ObstacleSurface::along(double s, double half) const {
    if (half <= 0) return {profile(s), profileSlope(s)};
    return {(profileIntegral(s + half) - profileIntegral(s - half)) / (2 * half),
            (profile(s + half) - profile(s - half)) / (2 * half)};
}

ObstacleSurface::Value ObstacleSurface::across(double t, double half) const {
    const double side = 0.5 * obstacle_.width - std::abs(t);  // m inside its edge
    if (side >= half) return {1, 0};
    if (side <= -half) return {0, 0};
    return {0.5 * (side + half) / half, (t > 0 ? -0.5 : 0.5) / half};
}

SurfacePoint ObstacleSurface::at(double x, double y, double half_side) const {
    const double dx = x - obstacle_.x, dy = y - obstacle_.y;
    const double s = direction_x_ * dx + direction_y_ * dy;
    const double t = -direction_y_ * dx + direction_x_ * dy;
    if (s + half_side < 0 || s - half_side > obstacle_.length) return {};
    const Value f = along(s, half_side), g = across(t, half_side);
    const double by_s = obstacle_.height * f.slope * g.value, by_t = obstacle_.height * f.value * g.slope;
    return {obstacle_.height * f.value * g.value, direction_x_ * by_s - direction_y_ * by_t,
            direction_y_ * by_s + direction_x_ * by_t};
}

}  // namespace tread
