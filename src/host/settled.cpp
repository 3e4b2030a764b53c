#include "host/settled.h"

#include <cmath>

namespace tread::host {
namespace {

constexpr double kNoEquilibrium = 0.01;  // m/s2 or rad/s2 left after settling
constexpr double kPullsAside = 0.5;      // the same of a rolling car: play in its steering may leave it a pull
constexpr double kThrottleRounding = 1e-3;

}  // namespace

StartFault startFault(const Equilibrium& rest, double speed, bool needs_throttle) {
    if (!std::isfinite(rest.acceleration)) return StartFault::broke_down;
    if (rest.acceleration >= (speed > 0 ? kPullsAside : kNoEquilibrium)) return StartFault::no_equilibrium;
    if (speed > 0 && needs_throttle && (rest.throttle < -kThrottleRounding || rest.throttle > 1 + kThrottleRounding))
        return StartFault::too_fast;
    return StartFault::none;
}

}  // namespace tread::host
