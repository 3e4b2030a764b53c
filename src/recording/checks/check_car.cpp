#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/math/median.h"
#include "recording/checks/log_checks.h"

namespace tread::recording::checks {

void checkCar(const LogChecks& checks) {
    const std::vector<double>* vx = checks.values("chassis.vx");
    const std::vector<double>* yaw_rate = checks.values("chassis.yaw_rate");
    const std::vector<double>* steer = checks.values("driver.steering_wheel_angle");
    if (!vx || !yaw_rate || !steer) return;
    constexpr double kLeastUndersteer = -0.001, kMostUndersteer = 0.008;  // rad s2/m, range of road cars
    constexpr double kUncertain = 1.35;  // factor by which steering ratio and wheelbase together may be wrong
    // The steering wheel must have stayed within kHeld, rad, for kSettling, s, so that the yaw rate has settled.
    constexpr double kSettling = 0.5, kHeld = 0.05;
    const VehicleParams& car = checks.nominal.vehicle;
    const auto gain = [&](double understeer) {
        std::vector<double> out(vx->size());
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double v = (*vx)[i];
            out[i] = v * (*steer)[i] / car.steering.ratio / std::max(car.wheelbase + understeer * v * v, 0.5);
        }
        return out;
    };
    const double step = medianStep(checks.time());
    const auto before = static_cast<std::size_t>(step > 0 ? kSettling / step : 0);
    const auto gentle = [&](std::size_t i) {
        const bool settled = i >= before && std::abs((*steer)[i] - (*steer)[i - before]) < kHeld;
        return settled && (*vx)[i] > LogChecks::kMoving && std::abs((*vx)[i] * (*yaw_rate)[i]) < LogChecks::kSliding;
    };
    const Relation most = relation(gain(kMostUndersteer), *yaw_rate, gentle),
                   least = relation(gain(kLeastUndersteer), *yaw_rate, gentle);
    if (most.samples < Relation::kFewest || most.spread < 0.02 || most.correlation < Relation::kCorrelated) return;
    if (least.factor < kUncertain && most.factor > 1 / kUncertain) return;
    const double factor = least.factor >= kUncertain ? least.factor : most.factor;
    checks.warn(
        "chassis.yaw_rate",
        fmt::format("is {:.2g} times the value that follows from the steering ratio and wheelbase in gentle turns",
                    factor),
        "With the file of a different car, every effect would be fitted to that difference",
        "Check the vehicle file, its steering ratio, and that the recorded angle is the steering-wheel angle");
}

}  // namespace tread::recording::checks
