// Differentials on the whole car: their torque must not upset the implicit step of the tyres.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "shared/vehicles.h"

namespace tread::vehicle_differential_test {
namespace {

class SplitRoad final : public Road {
public:
    RoadContact contact(const Vector3& centre_W, std::size_t) const override {
        RoadContact contact;
        contact.point_W = {centre_W.x(), centre_W.y(), 0};
        contact.friction = centre_W.y() > 0 ? 1 : 0.15;
        return contact;
    }
};

// Full throttle from standstill, both sides of the car on different grip.
reference::Car launched(
    VehicleParams params, const Road& road, double time, double step,
    const std::function<void(const reference::Car&)>& look = [](const reference::Car&) {}) {
    reference::Car car = reference::settled(params, road, {.input = {.brake = 0.2}});
    VehicleInput in;
    for (int k = 1; k * step < time + 1e-9; ++k) {
        in.throttle = std::min(1.0, k * step / 0.2);
        // Hold the heading.
        const ChassisOutput c = car.output().chassis;
        in.steering_wheel_angle = std::clamp(-8 * c.yaw - 2 * c.yaw_rate - 0.3 * c.y, -4.0, 4.0);
        car.step(in, step);
        look(car);
    }
    return car;
}

TEST(DifferentialOnACar, LockedAxleDrivesOffOnSplitGripWhereAnOpenOneSpins) {
    const SplitRoad road;
    VehicleParams open = reference::compact(), locked = open, limited = open;
    locked.driveline.front_differential = LockedDifferential{};
    limited.driveline.front_differential = LimitedSlipDifferential{.preload = 80, .locking_driving = 0.3};
    const double free = launched(open, road, 4, 0.001).motion.velocity_W.x();
    const double held = launched(locked, road, 4, 0.001).motion.velocity_W.x();
    const double some = launched(limited, road, 4, 0.001).motion.velocity_W.x();
    EXPECT_GT(held, 1.5 * free);
    EXPECT_GT(some, 1.15 * free);
    EXPECT_LT(some, held);
}

TEST(DifferentialOnACar, LockedWheelsTurnAlike) {
    // The tyre on ice trembles at the frequency of its contact mass, as it does with any step; what that leaves between
    // the speeds of the wheels vanishes with the square of the step.
    const SplitRoad road;
    VehicleParams params = reference::compact();
    params.driveline.front_differential = LockedDifferential{};
    const auto difference = [&](double step) {
        double largest = 0;
        launched(params, road, 3, step, [&](const reference::Car& car) {
            if (car.motion.velocity_W.x() < 1) return;  // the release of the brakes shakes the wheels
            largest = std::max(largest, std::abs(car.state.wheels.front_left.spin - car.state.wheels.front_right.spin));
        });
        return largest;
    };
    const double coarse = difference(0.001);
    EXPECT_LT(coarse, 0.5) << "rad/s, of some 20";
    EXPECT_LT(difference(0.0005), 0.4 * coarse);
}

TEST(DifferentialOnACar, AHalvedStepConvergesToTheSameDrive) {
    const SplitRoad road;
    for (const bool locked : {true, false}) {
        VehicleParams params = reference::rearDriveSedan();
        params.driveline.front_share = 0.4;
        if (locked) {
            params.driveline.rear_differential = params.driveline.front_differential = LockedDifferential{};
            params.driveline.centre_differential = LockedDifferential{};
        } else {
            const LimitedSlipDifferential limited{
                .preload = 60, .locking_driving = 0.35, .locking_coasting = 0.2, .viscosity = 5};
            params.driveline.rear_differential = limited;
            params.driveline.centre_differential = limited;
        }
        const double coarse = launched(params, road, 2.5, 0.001).motion.position_W.x();
        const double fine = launched(params, road, 2.5, 0.00025).motion.position_W.x();
        EXPECT_NEAR(coarse, fine, 0.002 * fine) << (locked ? "locked" : "limited slip");
    }
}

TEST(DifferentialOnACar, LockedAxleUndersteersInASlowTurn) {
    const PlaneRoad road;
    const auto yawRate = [&](const VehicleParams& params) {
        reference::Car car = reference::settled(params, road, {.speed = 4});
        VehicleInput in = car.input;
        for (int k = 1; k <= 4000; ++k) {
            in.steering_wheel_angle = std::min(6.0, 4.0 * k * 0.001);
            car.step(in, 0.001);
        }
        return car.output().chassis.yaw_rate / car.output().chassis.vx;
    };
    VehicleParams open = reference::rearDriveSedan(), locked = open;
    locked.driveline.rear_differential = LockedDifferential{};
    EXPECT_LT(yawRate(locked), 0.97 * yawRate(open));
}

}  // namespace
}  // namespace tread::vehicle_differential_test
