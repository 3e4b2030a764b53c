#include "blind/world/disturbance.h"

#include <cmath>

namespace tread::blind::world {

Pushing wandering(const Disturbance& disturbance, double step, std::uint64_t seed) {
    // Exact discretisation: the next value is the last one decayed plus noise that restores the variance.
    const double kept = std::exp(-step / disturbance.correlation_time);
    const double fresh = std::sqrt(1 - kept * kept);
    Random random(seed);
    const auto deviation = [&](double sd) { return sd * random.normal(); };
    Push now{.force = {deviation(disturbance.fx), deviation(disturbance.fy), 0},
             .moment = {deviation(disturbance.roll_moment), 0, deviation(disturbance.yaw_moment)}};
    return [=](double, const VehicleInput&, const VehicleOutput&) mutable {
        const Push before = now;
        const auto next = [&](double value, double sd) { return kept * value + fresh * sd * random.normal(); };
        now.force.x() = next(now.force.x(), disturbance.fx);
        now.force.y() = next(now.force.y(), disturbance.fy);
        now.moment.x() = next(now.moment.x(), disturbance.roll_moment);
        now.moment.z() = next(now.moment.z(), disturbance.yaw_moment);
        return before;
    };
}

}  // namespace tread::blind::world
