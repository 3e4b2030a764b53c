#include "vehicle/strut.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// Side walls are folded when the tyre has given way by this share of its radius; then the rim carries, so many times
// stiffer than the tyre, setting in over this share of the radius.
constexpr double kRimDeflection = 0.35;
constexpr double kRimStiffness = 8;
constexpr double kRimOnset = 0.15;
// A rim on the ground does not bounce: this share of its force is lost on the way back, and added on the way in.
constexpr double kRimLoss = 0.8;
constexpr double kRimLossSpeed = 1.0;  // m/s at which the loss is three quarters complete
// The stop of the strut, over the stiffness of the tyre, and the compression over which it sets in.
constexpr double kStopStiffness = 3;
constexpr double kStopOnset = 0.03;  // m
constexpr int kIterations = 60;
constexpr double kTolerance = 1e-12;  // m

struct Force {
    double value;
    double slope;
};

// Nothing, then a parabola, then a line: a contact without a kink.
Force onset(double x, double stiffness, double width) {
    if (x <= 0) return {0, 0};
    if (x < width) return {0.5 * stiffness * x * x / width, stiffness * x / width};
    return {stiffness * (x - 0.5 * width), stiffness};
}

double radialStiffness(const TyreParams& tyre) {
    return tyre.parameters.pz1 * tyre.lambda.Cz;
}

// Force of the strut on the wheel at compression x, and its slope.
struct StrutForce {
    const StrutParams& strut;
    double stop_stiffness;
    double start;  // m, compression at the start of the step
    double partner;
    double per_second;  // 1 over the step

    Force operator()(double x) const {
        const double damping = (x > start ? strut.bump : strut.rebound) * per_second;
        Force f{strut.stiffness * x + damping * (x - start), strut.stiffness + damping};
        if (f.value > strut.most_force) f = {strut.most_force, 0};
        const Force stop = onset(x - strut.travel, stop_stiffness, kStopOnset);
        return {f.value + stop.value + strut.anti_roll_bar * (x - partner), f.slope + stop.slope + strut.anti_roll_bar};
    }
};

// Normal force of the road at compression x, and its slope with x.
struct TyreForce {
    const TyreParams& tyre;
    const StrutPush& push;
    double start;
    double per_second;

    double deflection(double x) const { return push.deflection - push.lift * x; }

    Force operator()(double x) const {
        const double deflected = deflection(x);
        if (deflected <= 0) return {0, 0};
        const double stiffness = radialStiffness(tyre);
        const double damping = tyre.parameters.pz2 * tyre.lambda.Kz;
        const double rate = push.closing - push.lift * (x - start) * per_second;
        Force f{stiffness * deflected + damping * rate, -push.lift * (stiffness + damping * per_second)};  // (83)
        if (f.value <= 0) f = {0, 0};
        const double beyond = deflected - kRimDeflection * tyre.parameters.Ro;
        if (beyond <= 0) return f;
        const Force rim = onset(beyond, kRimStiffness * stiffness, kRimOnset * tyre.parameters.Ro);
        const double loss = 1 + kRimLoss * std::tanh(push.closing / kRimLossSpeed);
        return {f.value + loss * rim.value, f.slope - push.lift * loss * rim.slope};
    }
};

}  // namespace

StrutYield yield(const StrutParams& strut, const TyreParams& tyre, const StrutPush& push, double compression,
                 double partner, double dt) {
    const StrutForce spring{strut, kStopStiffness * radialStiffness(tyre), compression, partner, 1 / dt};
    const TyreForce road{tyre, push, compression, 1 / dt};

    // The balance rises with x: between full extension and the compression at which the tyre leaves the road it is met.
    double low = 0;
    double high = std::max({compression, partner, push.deflection > 0 ? push.deflection / push.lift : 0.0});
    double x = std::clamp(compression, low, high);
    Force s = spring(x), r = road(x);
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
