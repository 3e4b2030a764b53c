#include "vehicle/tyre_load.h"

#include "base/math/elementary.h"

namespace tread {
namespace {

// The rim is so many times stiffer than the tyre, and sets in over this share of its radius.
constexpr double kRimStiffness = 8;
constexpr double kRimOnset = 0.15;
// A rim on the ground does not bounce: this share of its force is lost on the way back, and added on the way in.
constexpr double kRimLoss = 0.8;
constexpr double kRimLossSpeed = 1.0;  // m/s at which the loss is three quarters complete

}  // namespace

ForceAndSlope rimForce(double stiffness, double radius, double deflection, double fall) {
    const double beyond = deflection - kRimDeflection * radius;
    const ForceAndSlope rim = onset(beyond, kRimStiffness * stiffness, kRimOnset * radius);
    const double loss = 1 + kRimLoss * hyperbolicTangent(fall / kRimLossSpeed);
    return {loss * rim.value, loss * rim.slope};
}

}  // namespace tread
