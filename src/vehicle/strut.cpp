#include "vehicle/strut.h"

#include <algorithm>
#include <cmath>

#include "vehicle/tyre_load.h"

namespace tread {
namespace {

// The stop of the strut: its stiffness over that of the tyre, and the compression over which it sets in.
constexpr double kStopStiffness = 3;
constexpr double kStopOnset = 0.1;  // of the tyre's radius
constexpr int kIterations = 60;
constexpr double kTolerance = 1e-12;  // m

// Force of the strut on the wheel at compression x, and its slope.
struct StrutForce {
    const StrutParams& strut;
    double stop_stiffness;
    double stop_onset;  // m
    double start;       // m, compression at the start of the step
    double partner;
    double per_second;  // 1 over the step

    ForceAndSlope operator()(double x) const {
        const double damping = (x > start ? strut.bump : strut.rebound) * per_second;
        ForceAndSlope f{strut.stiffness * x + damping * (x - start), strut.stiffness + damping};
        if (f.value > strut.most_force) f = {strut.most_force, 0};
        const ForceAndSlope stop = onset(x - strut.travel, stop_stiffness, stop_onset);
        return {f.value + stop.value + strut.anti_roll_bar * (x - partner), f.slope + stop.slope + strut.anti_roll_bar};
    }
};

// Normal force of the road at compression x, and its slope with x.
struct RoadForce {
    const StrutParams& strut;
    const TyreParams& tyre;
    const StrutPush& push;
    double start;
    double before;  // m, deflection at the start of the step, for the tyre's damping
    double per_second;

    double deflection(double x) const { return push.deflection - push.lift * x; }

    ForceAndSlope operator()(double x) const {
        const double rate = push.closing - push.lift * (x - start) * per_second;
        const double pressed = deflection(x) - before;
        const double damping = (pressed > 0 ? strut.tyre_bump : strut.tyre_rebound) * per_second;
        const TyreLoad load = tyreLoad(tyre, TyreDeflection{.value = deflection(x), .rate = rate, .fall = push.closing},
                                       damping * pressed);
        const double slope = load.by_deflection + load.by_rate * per_second + (load.by_deflection > 0 ? damping : 0);
        return {load.load, -push.lift * slope};
    }
};

// [guess] Of what swings without end, so much is taken in roll and pitch.
constexpr double kClear = 0.7;

// Strut and tyre with damping of both stand between body and road as one damper, that of the two in series, beside the
// two springs in series. Held over a step as at its start, with s = stiffness * yielding * dt and d = damping *
// yielding, a damper of d = 1 - s/4 takes the whole motion of the body together with the spring, one of more turns it
// round, and one of 2 - s/2 swings it without end. Up and down it takes no more than the whole; in roll and pitch,
// where wheels far outside of the mass yield more, it keeps clear of swinging, or roll would set how well the
// car is damped.
StrutParams overStep(StrutParams strut, const TyreParams& tyre, const StrutPush& push, double dt) {
    const double radial = radialStiffness(tyre);
    const double stiffness = strut.stiffness * radial / (strut.stiffness + radial);
    const auto whole = [&](double yielding) { return std::max(1 - 0.25 * stiffness * yielding * dt, 0.0); };
    const double heave = whole(push.heaving), turn = kClear * 2 * whole(push.turning);
    const double most = std::min(heave / push.heaving, turn / push.turning);
    const auto limit = [most](double& a, double& b) {
        if (!(a > 0 && b > 0) || a * b <= most * (a + b)) return;
        const double share = most * (a + b) / (a * b);
        a *= share;
        b *= share;
    };
    limit(strut.bump, strut.tyre_bump);
    limit(strut.rebound, strut.tyre_rebound);
    return strut;
}

// What the dampers see at the start of the step.
struct DampedFrom {
    double compression;  // m, of the strut
    double deflection;   // m, of the tyre
};
// A wheel that comes down within the step counts as if it had touched all the time, strut and tyre in proportion: the
// damping then meets the whole speed, as in stock, and not what is left of the step.
DampedFrom dampedFrom(const StrutParams& strut, const StrutPush& push, double compression) {
    const double deflection = push.before - push.lift * compression;
    if (deflection >= 0 || !(strut.tyre_bump > 0)) return {compression, std::max(deflection, 0.0)};
    const double of_tyre = strut.bump / (strut.bump + strut.tyre_bump);
    return {compression + (1 - of_tyre) * deflection / push.lift, of_tyre * deflection};
}

}  // namespace

StrutYield yield(const StrutParams& params, const TyreParams& tyre, const StrutPush& push, double compression,
                 double partner, double dt) {
    const StrutParams strut = overStep(params, tyre, push, dt);
    const bool reaches = push.deflection > 0;
    const DampedFrom from = reaches ? dampedFrom(strut, push, compression) : DampedFrom{compression, 0};
    const double stop = std::min(strut.stop, kStopStiffness * radialStiffness(tyre));
    const StrutForce spring{strut, stop, kStopOnset * tyre.parameters.Ro, from.compression, partner, 1 / dt};
    const RoadForce road{strut, tyre, push, compression, from.deflection, 1 / dt};

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
