#include "vehicle/strut.h"

#include <algorithm>
#include <cmath>

#include "vehicle/tyre_load.h"

namespace tread {
namespace {

// The stop of the strut, over the stiffness of the tyre, and the compression over which it sets in.
constexpr double kStopStiffness = 3;
constexpr double kStopOnset = 0.03;  // m
constexpr int kIterations = 60;
constexpr double kTolerance = 1e-12;  // m

// Force of the strut on the wheel at compression x, and its slope.
struct StrutForce {
    const StrutParams& strut;
    double stop_stiffness;
    double start;  // m, compression at the start of the step
    double partner;
    double per_second;  // 1 over the step

    ForceAndSlope operator()(double x) const {
        const double damping = (x > start ? strut.bump : strut.rebound) * per_second;
        ForceAndSlope f{strut.stiffness * x + damping * (x - start), strut.stiffness + damping};
        if (f.value > strut.most_force) f = {strut.most_force, 0};
        const ForceAndSlope stop = onset(x - strut.travel, stop_stiffness, kStopOnset);
        return {f.value + stop.value + strut.anti_roll_bar * (x - partner), f.slope + stop.slope + strut.anti_roll_bar};
    }
};

// Normal force of the road at compression x, and its slope with x.
struct RoadForce {
    const TyreParams& tyre;
    const StrutPush& push;
    double start;
    double per_second;

    double deflection(double x) const { return push.deflection - push.lift * x; }

    ForceAndSlope operator()(double x) const {
        const double rate = push.closing - push.lift * (x - start) * per_second;
        const TyreLoad load = tyreLoad(tyre, {.value = deflection(x), .rate = rate, .fall = push.closing});
        return {load.load, -push.lift * (load.by_deflection + load.by_rate * per_second)};
    }
};

}  // namespace

StrutYield yield(const StrutParams& strut, const TyreParams& tyre, const StrutPush& push, double compression,
                 double partner, double dt) {
    const StrutForce spring{strut, kStopStiffness * radialStiffness(tyre), compression, partner, 1 / dt};
    const RoadForce road{tyre, push, compression, 1 / dt};

    // The balance rises with x: between full extension and the compression at which the tyre leaves the road it is met.
    double low = 0;
    double high = std::max({compression, partner, push.deflection > 0 ? push.deflection / push.lift : 0.0});
    double x = std::clamp(compression, low, high);
    ForceAndSlope s = spring(x), r = road(x);
    for (int i = 0; i < kIterations && high - low > kTolerance; ++i) {
        const double balance = s.value - push.share * r.value;
        (balance > 0 ? high : low) = x;
        const double slope = s.slope - push.share * r.slope;
        double next = slope > 0 ? x - balance / slope : low;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        if (std::abs(next - x) <= kTolerance) break;
        x = next;
        s = spring(x);
        r = road(x);
    }
    return {x, (x - compression) / dt, s.value, std::max(road.deflection(x), 0.0), r.value};
}

}  // namespace tread
