// The start of a drive is an equilibrium of the car as it is: driven on with what it says, nothing moves.

#include <gtest/gtest.h>

#include <cmath>

#include "shared/equipped_car.h"
#include "shared/vehicles.h"

namespace tread::vehicle_start_test {
namespace {

constexpr double kStep = 0.001;  // s

// The largest of lateral velocity (against the start's), yaw rate and change of speed in a second with the input held.
double largestMotion(reference::Car car) {
    const ChassisOutput start = car.output().chassis;
    double largest = 0;
    for (int k = 0; k < 1000; ++k) {
        car.step(kStep);
        const ChassisOutput now = car.output().chassis;
        for (const double change : {now.vy - start.vy, now.yaw_rate, now.vx - start.vx, now.roll_rate}) {
            largest = std::isfinite(change) ? std::max(largest, std::abs(change)) : INFINITY;
        }
    }
    return largest;
}

TEST(Start, ACarThatPullsIsSteeredAgainstItThroughPlayAndLag) {
    // Conicity, odd tyres, everything else besides: the steering wheel must stand at one end of the play.
    constexpr double kMoves = 1e-4;  // m/s and rad/s: tyres that warm as they roll, and dry friction that settles
    const PlaneRoad road;
    for (const VehicleParams& plain : {reference::compact(), reference::rearDriveSedan()}) {
        const VehicleParams params = shared::withEverything(plain);
        for (const double speed : {8.0, 22.0, 40.0}) {
            const Equilibrium rest = equilibrium(prepare(params), {road}, {.speed = speed});
            EXPECT_LT(rest.acceleration, 1e-6) << params.name << ", " << speed;
            EXPECT_GT(std::abs(rest.input.steering_wheel_angle), 0.5 * params.steering.play);
            EXPECT_LT(largestMotion(reference::settled(params, road, {.speed = speed})), kMoves)
                << params.name << ", " << speed;
        }
    }
}

TEST(Start, WheelsThatRecedeSettleAtEverySpeed) {
    const PlaneRoad road;
    for (const double compliance : {1e-7, 1e-6, 1e-5}) {
        for (const double speed : {2.0, 5.0, 12.0, 30.0}) {
            VehicleParams params = reference::compact();
            for (AxleParams* axle : {&params.front, &params.rear})
                axle->suspension.longitudinal_compliance = compliance;
            const Equilibrium rest = equilibrium(prepare(params), {road}, {.speed = speed});
            EXPECT_LT(rest.acceleration, 1e-6) << compliance << " m/N, " << speed << " m/s";
        }
    }
}

}  // namespace
}  // namespace tread::vehicle_start_test
