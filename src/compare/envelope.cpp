#include "compare/envelope.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tread {
namespace {

// Points of the curve closer than this share of the tolerance add nothing to the envelope.
constexpr double kThinning = 0.02;

struct CurvePoint {
    double x, y;
    double x_tolerance, y_tolerance;
};

const std::vector<double>& valuesOf(const Log& log, std::string_view name, const char* which) {
    const Channel* channel = log.find(name);
    if (!channel) throw std::invalid_argument("the " + std::string(which) + " log has no channel " + std::string(name));
    return channel->values;
}

// Distance from a to b in units of the tolerance at a.
double distance(const CurvePoint& a, double x, double y) {
    return std::hypot((x - a.x) / a.x_tolerance, (y - a.y) / a.y_tolerance);
}

std::vector<CurvePoint> thinnedCurve(const std::vector<double>& x, const std::vector<double>& y,
                                     const EnvelopeTolerance& tolerance) {
    std::vector<CurvePoint> curve;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
        const bool last = i + 1 == x.size();
        if (!curve.empty() && !last && distance(curve.back(), x[i], y[i]) < kThinning) continue;
        if (!curve.empty() && x[i] == curve.back().x && y[i] == curve.back().y) continue;
        curve.push_back({x[i], y[i], tolerance.x_offset + tolerance.x_gain * std::abs(x[i]),
                         tolerance.y_offset + tolerance.y_gain * std::abs(y[i])});
    }
    return curve;
}

// Distance to the curve in units of the tolerance: scaled by it, the swept ellipse is a disc, so the nearest point
// counts.
double distanceToCurve(const std::vector<CurvePoint>& curve, double x, double y) {
    double nearest = kInfinity;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const CurvePoint &a = curve[i], &b = curve[i + 1];
        const double sx = 0.5 * (a.x_tolerance + b.x_tolerance), sy = 0.5 * (a.y_tolerance + b.y_tolerance);
        const double ux = (b.x - a.x) / sx, uy = (b.y - a.y) / sy;
        const double px = (x - a.x) / sx, py = (y - a.y) / sy;
        const double along = std::clamp((px * ux + py * uy) / (ux * ux + uy * uy), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(px - along * ux, py - along * uy));
    }
    return nearest;
}

// The envelope of the swept ellipses (the curve's normal in scaled coordinates), as in TU Munich's validation
// framework.
void drawBoundaries(const std::vector<CurvePoint>& curve, EnvelopeJudgement& judgement) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const CurvePoint& before = curve[i == 0 ? 0 : i - 1];
        const CurvePoint& behind = curve[i + 1 == curve.size() ? i : i + 1];
        const CurvePoint& here = curve[i];
        const double dx = behind.x - before.x, dy = behind.y - before.y;
        const double d = std::hypot(dx * here.y_tolerance, dy * here.x_tolerance);
        if (d == 0) continue;
        const double to_x = -dy * here.x_tolerance * here.x_tolerance / d;
        const double to_y = dx * here.y_tolerance * here.y_tolerance / d;
        judgement.top.push_back({here.x + to_x, here.y + to_y});
        judgement.bottom.push_back({here.x - to_x, here.y - to_y});
    }
}

}  // namespace

EnvelopeJudgement judgeEnvelope(const Log& simulated, const Log& measured, std::string_view x_channel,
                                std::string_view y_channel, const EnvelopeTolerance& tolerance) {
    const auto curve = thinnedCurve(valuesOf(simulated, x_channel, "simulated"),
                                    valuesOf(simulated, y_channel, "simulated"), tolerance);
    const std::vector<double>& x = valuesOf(measured, x_channel, "measured");
    const std::vector<double>& y = valuesOf(measured, y_channel, "measured");

    EnvelopeJudgement judgement;
    if (curve.size() < 2) throw std::invalid_argument("the simulated curve has fewer than two different points");
    drawBoundaries(curve, judgement);
    const auto by_x = [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; };
    const auto [lowest, highest] = std::minmax_element(curve.begin(), curve.end(), by_x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double away = distanceToCurve(curve, x[i], y[i]);
        const bool covered = std::isfinite(away) && x[i] >= lowest->x && x[i] <= highest->x;
        if (!covered && !(away <= 1)) {
            ++judgement.not_covered;
            continue;
        }
        ++judgement.judged;
        judgement.worst = std::max(judgement.worst, away);
        if (away <= 1) continue;
        ++judgement.outside;
        if (!judgement.first_outside_time) judgement.first_outside_time = measured.channels.front().values[i];
    }
    judgement.inside = judgement.judged > 0 && judgement.outside == 0;
    return judgement;
}

}  // namespace tread
