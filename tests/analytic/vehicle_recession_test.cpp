// Longitudinal compliance of the suspension: wheels recede by statics, and nothing else changes.

#include <gtest/gtest.h>

#include <cmath>

#include "shared/vehicles.h"

namespace tread::vehicle_recession_test {
namespace {

constexpr double kStep = 0.001;  // s

TEST(Recession, FollowsTheForceOfBrakingByStatics) {
    const PlaneRoad road;
    VehicleParams params = reference::simplified(reference::compact());
    params.front.suspension.longitudinal_compliance = 2e-6;
    params.rear.suspension.longitudinal_compliance = 1e-6;
    reference::Car car = reference::settled(params, road, {.speed = 30});
    VehicleInput in = car.input;
    in.throttle = 0;
    in.clutch = 1;
    for (double t = 0; t < 1.5; t += kStep) {
        in.brake = std::min(0.3, t);
        car.step(in, kStep);
    }
    const ChassisOutput out = car.output().chassis;
    ASSERT_LT(out.ax, -2);
    for (std::size_t i = 0; i < kWheels; ++i) {
        const AxleParams& axle = i < 2 ? params.front : params.rear;
        const WheelState& wheel = car.state.wheels[i];
        // The wheel brakes itself too: its own mass does not press on the bush. In the axes of the pitching body.
        const double pitch = out.pitch;
        const double road_force = wheel.fx * std::cos(pitch) - wheel.load * std::sin(pitch);
        const double own = axle.unsprung_mass * (out.ax * std::cos(pitch) - kStandardGravity * std::sin(pitch));
        const double expected = axle.suspension.longitudinal_compliance * (road_force - own);
        EXPECT_NEAR(wheel.recession.travel, expected, 0.01 * std::abs(expected));
        EXPECT_LT(wheel.recession.travel, -1e-4) << "braking moves the wheel back";
    }
}

TEST(Recession, DoesNotChangeWhatBrakingOrDrivingDoesToTheCar) {
    // What yields between wheel and body carries the same mean force: momentum is the tyres' affair.
    const PlaneRoad road;
    const auto stop = [&](double compliance) {
        VehicleParams params = reference::simplified(reference::compact());
        params.front.suspension.longitudinal_compliance = params.rear.suspension.longitudinal_compliance = compliance;
        reference::Car car = reference::settled(params, road, {.speed = 25});
        VehicleInput in = car.input;
        in.throttle = 0;
        in.clutch = 1;
        double momentum = 0, from = car.output().chassis.vx;
        for (double t = 0; t < 2; t += kStep) {
            in.brake = std::min(0.3, 2 * t);
            double before = 0, after = 0;
            for (std::size_t i = 0; i < kWheels; ++i) before += car.state.wheels[i].fx;
            car.step(in, kStep);
            for (std::size_t i = 0; i < kWheels; ++i) after += car.state.wheels[i].fx;
            momentum += 0.5 * (before + after) * kStep;
        }
        const double lost = params.mass * (from - car.output().chassis.vx);
        EXPECT_NEAR(-momentum, lost, 1e-3 * lost);
        return car.output().chassis.vx;
    };
    const double rigid = stop(0), soft = stop(2e-6);
    EXPECT_NEAR(soft, rigid, 0.02);
    EXPECT_NE(soft, rigid);
}

TEST(Recession, StandsStillOnASlope) {
    const PlaneRoad slope(0.2, 0);
    VehicleParams params = reference::simplified(reference::compact());
    params.front.suspension.longitudinal_compliance = params.rear.suspension.longitudinal_compliance = 2e-6;
    reference::Car car = reference::settled(params, slope, {.input = {.brake = 1}});
    const double x = car.motion.position_W.x();
    for (int i = 0; i < 10000; ++i) car.step(kStep);
    EXPECT_NEAR(car.motion.position_W.x(), x, 1e-5);
    for (std::size_t i = 0; i < kWheels; ++i) EXPECT_LT(std::abs(car.state.wheels[i].recession.rate), 1e-6);
}

}  // namespace
}  // namespace tread::vehicle_recession_test
