// Anti-lock braking and stability control on the whole car: what they are for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

#include "shared/vehicles.h"

namespace tread::vehicle_braking_control_test {
namespace {

constexpr double kStep = 0.001;  // s

// Good grip under the left wheels, little under the right ones.
class SplitRoad final : public Road {
public:
    SplitRoad(double left, double right) : left_(left), right_(right) {}
    RoadContact contact(const Vector3& centre_W, std::size_t) const override {
        RoadContact contact;
        contact.point_W = {centre_W.x(), centre_W.y(), 0};
        contact.friction = centre_W.y() > 0 ? left_ : right_;
        return contact;
    }

private:
    double left_, right_;
};

struct Stop {
    double distance = 0;      // m
    double largest_yaw = 0;   // rad
    double locked_share = 0;  // share of time above walking speed in which a wheel is locked
    int dumps = 0;            // of the front left wheel, above 5 m/s
    double time = 0;          // s, above 5 m/s
    double lateral = 0;       // m
};

// Full pedal from a speed; the driver steers as he is told.
Stop stop(
    VehicleParams params, const Road& road, double speed, bool anti_lock,
    const std::function<double(const VehicleOutput&)>& steer = [](const VehicleOutput&) { return 0; }) {
    params.brakes.anti_lock.enabled = anti_lock;
    reference::Car car = reference::settled(params, road, {.speed = speed});
    Stop result;
    auto before = AntiLockState::Phase::idle;
    double locked = 0, rolling = 0;
    VehicleInput in = car.input;
    for (int k = 0; k < 15000 && car.motion.velocity_W.norm() > 0.05; ++k) {
        in.throttle = 0;
        in.brake = std::min(1.0, k * kStep / 0.1);
        in.clutch = 1;
        const VehicleOutput out = car.output();
        in.steering_wheel_angle = steer(out);
        car.step(in, kStep);
        result.largest_yaw = std::max(result.largest_yaw, std::abs(out.chassis.yaw));
        if (out.chassis.vx < 5) continue;
        result.time += kStep;
        const auto phase = car.state.brakes.anti_lock.wheels.front_left.phase;
        result.dumps += phase == AntiLockState::Phase::dump && before != phase;
        before = phase;
        for (std::size_t i = 0; i < kWheels; ++i) locked += out.wheel[i].slip_ratio < -0.9 ? kStep / 4 : 0;
        rolling += kStep;
    }
    result.distance = car.motion.position_W.x();
    result.lateral = car.motion.position_W.y();
    result.locked_share = locked / rolling;
    return result;
}

TEST(AntiLock, StopsShorterThanLockedWheelsOnDryRoad) {
    const PlaneRoad dry;
    for (const VehicleParams& params : {reference::compact(), reference::rearDriveSedan()}) {
        const Stop locked = stop(params, dry, 100 / 3.6, false), controlled = stop(params, dry, 100 / 3.6, true);
        std::printf("%s: %.1f m with locked wheels, %.1f m with ABS, %.1f cycles/s\n", params.name.c_str(),
                    locked.distance, controlled.distance, controlled.dumps / controlled.time);
        EXPECT_LT(controlled.distance, locked.distance);
        EXPECT_GT(locked.locked_share, 0.3);
        EXPECT_LT(controlled.locked_share, 0.02);
        EXPECT_GE(controlled.dumps / controlled.time, 5);
        EXPECT_LE(controlled.dumps / controlled.time, 12);
    }
}

TEST(AntiLock, StopsShorterOnWetRoadAndOnIceToo) {
    for (const double friction : {0.2, 0.6}) {
        const PlaneRoad road(0, 0, friction);
        const Stop locked = stop(reference::compact(), road, 60 / 3.6, false);
        const Stop controlled = stop(reference::compact(), road, 60 / 3.6, true);
        EXPECT_LT(controlled.distance, locked.distance) << friction;
        EXPECT_LT(controlled.locked_share, 0.1) << friction;
    }
}

TEST(AntiLock, CarStaysSteerableOnSplitFriction) {
    const SplitRoad road(1, 0.3);
    // A driver who holds his heading.
    const auto hold = [](const VehicleOutput& out) {
        return std::clamp(-10 * out.chassis.yaw - 4 * out.chassis.yaw_rate - 2 * out.chassis.y, -4.0, 4.0);
    };
    const Stop locked = stop(reference::compact(), road, 80 / 3.6, false, hold);
    const Stop controlled = stop(reference::compact(), road, 80 / 3.6, true, hold);
    std::printf("split friction: yaw %.1f deg, side %.2f m with ABS; %.0f deg without\n",
                controlled.largest_yaw * 180 / std::numbers::pi, controlled.lateral,
                locked.largest_yaw * 180 / std::numbers::pi);
    EXPECT_LT(controlled.largest_yaw, 15 * std::numbers::pi / 180);
    EXPECT_LT(std::abs(controlled.lateral), 1.0);
    EXPECT_GT(locked.largest_yaw, 3 * controlled.largest_yaw);
}

TEST(AntiLock, LeavesAGentleStopAlone) {
    const PlaneRoad dry;
    VehicleParams with = reference::compact(), without = with;
    with.brakes.anti_lock.enabled = true;
    reference::Car a = reference::settled(with, dry, {.speed = 20}),
                   b = reference::settled(without, dry, {.speed = 20});
    VehicleInput in = a.input;
    in.throttle = 0;
    in.brake = 0.25;
    for (int k = 0; k < 3000; ++k) {
        a.step(in, kStep);
        b.step(in, kStep);
    }
    EXPECT_NEAR(a.motion.position_W.x(), b.motion.position_W.x(), 1e-3);
}

TEST(AntiLock, LetsTheCarStandStill) {
    const PlaneRoad slope(0.15, 0, 1);
    VehicleParams params = reference::compact();
    params.brakes.anti_lock.enabled = true;
    reference::Car car = reference::settled(params, slope, {.input = {.brake = 0.8}});
    const Vector3 start = car.motion.position_W;
    for (int k = 0; k < 5000; ++k) car.step(kStep);
    EXPECT_LT((car.motion.position_W - start).norm(), 1e-5);
}

// ---- Sine with dwell, FMVSS 126 ----

struct DwellResult {
    double after_1_00 = 0;    // yaw rate over its second peak, 1.00 s after completion of steer
    double after_1_75 = 0;    // 1.75 s after
    double displacement = 0;  // m, lateral, 1.07 s after beginning of steer
    double largest_sideslip = 0;
};

DwellResult sineWithDwell(const VehicleParams& params, double amplitude) {
    constexpr double kFrequency = 0.7, kDwell = 0.5, kBegin = 0.1;
    const PlaneRoad road;
    reference::Car car = reference::settled(params, road, {.speed = 80 / 3.6});
    const double three_quarters = 0.75 / kFrequency, completion = 1 / kFrequency + kDwell;
    const auto steer = [&](double t) {
        if (t < 0 || t > completion) return 0.0;
        const double phase = t < three_quarters ? t : std::max(three_quarters, t - kDwell);
        return amplitude * std::sin(2 * std::numbers::pi * kFrequency * phase);
    };
    DwellResult result;
    double second_peak = 0, at_1_00 = 0, at_1_75 = 0;
    VehicleInput in = car.input;
    for (int k = 1; k * kStep < kBegin + completion + 1.8; ++k) {
        const double t = k * kStep - kBegin;
        in.throttle = 0;
        in.clutch = 1;  // coasting
        in.steering_wheel_angle = steer(t);
        car.step(in, kStep);
        const VehicleOutput out = car.output();
        if (t > 0.5 / kFrequency && t < completion) second_peak = std::min(second_peak, out.chassis.yaw_rate);
        if (t <= 1.07) result.displacement = out.chassis.y;
        if (t <= completion + 1.00) at_1_00 = out.chassis.yaw_rate;
        if (t <= completion + 1.75) at_1_75 = out.chassis.yaw_rate;
        result.largest_sideslip = std::max(result.largest_sideslip, std::abs(out.chassis.sideslip));
    }
    result.after_1_00 = at_1_00 / second_peak;
    result.after_1_75 = at_1_75 / second_peak;
    return result;
}

// Steering-wheel angle at 0.3 g in slowly increasing steer at 80 km/h.
double angleAt03g(const VehicleParams& params) {
    const PlaneRoad road;
    reference::Car car = reference::settled(params, road, {.speed = 80 / 3.6});
    VehicleInput in = car.input;
    for (int k = 1; k < 20000; ++k) {
        in.steering_wheel_angle = 13.5 * std::numbers::pi / 180 * k * kStep;
        car.step(in, kStep);
        if (car.output().chassis.ay > 0.3 * kStandardGravity) break;
    }
    return in.steering_wheel_angle;
}

TEST(StabilityControl, PassesSineWithDwellWhereTheSameCarWithoutItSpins) {
    VehicleParams without = reference::rearDriveSedan();
    // A car that oversteers at the limit: worn tyres at the rear.
    without.rear.tyre.lambda.muy *= 0.85;
    VehicleParams with = without;
    with.brakes.anti_lock.enabled = true;
    with.brakes.stability_control.enabled = true;

    const double a = angleAt03g(without);
    const double most = std::max(6.5 * a, 270 * std::numbers::pi / 180);
    int spins = 0;
    for (double amplitude = 1.5 * a;; amplitude += 0.5 * a) {
        amplitude = std::min(amplitude, most);
        const DwellResult on = sineWithDwell(with, amplitude), off = sineWithDwell(without, amplitude);
        std::printf(
            "%3.0f deg: with ESC %5.1f %% %5.1f %%, %.2f m, sideslip %4.1f deg; without %5.1f %% %5.1f %%, "
            "%.2f m, %5.1f deg\n",
            amplitude * 180 / std::numbers::pi, 100 * on.after_1_00, 100 * on.after_1_75, on.displacement,
            on.largest_sideslip * 180 / std::numbers::pi, 100 * off.after_1_00, 100 * off.after_1_75, off.displacement,
            off.largest_sideslip * 180 / std::numbers::pi);
        EXPECT_LE(std::abs(on.after_1_00), 0.35) << amplitude;
        EXPECT_LE(std::abs(on.after_1_75), 0.20) << amplitude;
        if (amplitude >= 5 * a) {
            EXPECT_GE(std::abs(on.displacement), 1.83) << amplitude;
        }
        spins += off.after_1_75 > 0.2;
        if (amplitude >= most) break;
    }
    EXPECT_GT(spins, 0) << "or the test would show nothing";
}

// N m s, asked for in a fast turn at 80 km/h that comes near the limit.
double askedFor(double step) {
    const PlaneRoad road;
    VehicleParams params = reference::compact();
    params.brakes.stability_control.enabled = true;
    reference::Car car = reference::settled(params, road, {.speed = 80 / 3.6});
    VehicleInput in = car.input;
    double sum = 0;
    for (int k = 1; k * step < 2; ++k) {
        in.steering_wheel_angle = std::min(500 * k * step, 70.0) * std::numbers::pi / 180;
        car.step(in, step);
        sum += car.output().brakes.stability_control * step;
    }
    return sum;
}

TEST(StabilityControl, DoesTheSameInLongSteps) {
    const double fine = askedFor(0.0005);
    ASSERT_GT(fine, 10);
    EXPECT_NEAR(askedFor(0.001), fine, 0.05 * fine);
    EXPECT_NEAR(askedFor(0.004), fine, 0.05 * fine);
}

TEST(StabilityControl, StaysOutOfOrdinaryDriving) {
    const PlaneRoad road;
    VehicleParams without = reference::compact(), with = without;
    with.brakes.stability_control.enabled = true;
    reference::Car a = reference::settled(with, road, {.speed = 80 / 3.6});
    VehicleInput in = a.input;
    double largest = 0;
    for (int k = 1; k <= 4000; ++k) {
        in.steering_wheel_angle = 0.5 * std::sin(2 * std::numbers::pi * 0.5 * k * kStep);
        a.step(in, kStep);
        largest = std::max(largest, a.output().brakes.stability_control);
    }
    EXPECT_EQ(largest, 0) << "about 4 m/s2";
}

}  // namespace
}  // namespace tread::vehicle_braking_control_test
