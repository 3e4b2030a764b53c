// A chassis that falls onto its wheels comes to rest as it does on the stock vehicle's, whatever its springs, dampers,
// wheels and mass.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_drop_test {
namespace {

using namespace scene;

struct Drop {
    double stiffness = 60;  // per mass, as stock takes it
    double damping = 0.3;   // in compression, over 2 sqrt(stiffness); in extension a third more
    double radius = 0.35;   // m
    double mass = 800;      // kg
    int wheels = 4;
    double height = 0.5;      // m, above touching down
    double substep = 0.02;    // s, tread's
    double rate = 60;         // 1/s, of steps
    double travel = 100;      // m, to the stop
    double most_force = 1e9;  // N
    double spread = 1;        // square of the wheels' distance in roll and pitch over that of the mass

    double sag() const { return kGravity / (wheels * stiffness); }
    // Long enough that an undamped landing leaves something of it.
    double length() const { return std::max(radius, 1.3 * (sag() + std::sqrt(sag() * sag() + 2 * height * sag()))); }
    std::string name() const {
        return "stiffness " + std::to_string(stiffness) + ", damping " + std::to_string(damping) + ", radius " +
               std::to_string(radius) + " m, " + std::to_string(mass) + " kg on " + std::to_string(wheels) +
               " wheels from " + std::to_string(height) + " m at substeps of " + std::to_string(substep) + " s";
    }
};

constexpr double kSeconds = 8;

struct Landing {
    bool finite = true;
    double rebound = 0;  // m, above the height of rest, after the deepest point
    double settled = 0;  // s, until the height stays within 2 % of the drop
    double height = 0;   // m, over the last tenth of the time

    bool settles() const { return finite && settled < kSeconds - 0.2; }
};

Landing landing(const std::vector<double>& heights, const Drop& drop) {
    const double touch = drop.length() + drop.radius, rest = touch - drop.sag();
    Landing seen;
    std::size_t low = 0;
    while (low + 1 < heights.size() && heights[low] > touch) ++low;
    while (low + 1 < heights.size() && heights[low + 1] < heights[low]) ++low;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        seen.finite &= std::isfinite(heights[i]);
        if (i >= low) seen.rebound = std::max(seen.rebound, heights[i] - rest);
        if (!(std::abs(heights[i] - rest) < 0.02 * drop.height)) seen.settled = static_cast<double>(i + 1) / drop.rate;
    }
    const std::size_t last = heights.size() / 10;
    for (std::size_t i = heights.size() - last; i < heights.size(); ++i)
        seen.height += heights[i] / static_cast<double>(last);
    return seen;
}

template <class Vehicle>
Landing land(const Drop& drop) {
    World world;
    world.addPlane();
    btCompoundShape none;  // the chassis itself never touches the ground
    btDefaultVehicleRaycaster raycaster(&world.dynamics);
    // Wheels on a circle, wide enough not to tip over.
    const double around = std::max(4 * drop.radius, 1.5 * drop.length());
    const double inertia = 0.5 * drop.mass * around * around;
    btRigidBody chassis(scalar(drop.mass), nullptr, &none,
                        vector(inertia / drop.spread, inertia, inertia / drop.spread));
    const double start = drop.length() + drop.radius + drop.height;
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, start, 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);

    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = scalar(drop.stiffness);
    tuning.m_suspensionCompression = scalar(drop.damping * 2 * std::sqrt(drop.stiffness));
    tuning.m_suspensionDamping = scalar(4.0 / 3 * drop.damping * 2 * std::sqrt(drop.stiffness));
    tuning.m_maxSuspensionForce = scalar(drop.most_force);
    tuning.m_maxSuspensionTravelCm = scalar(100 * drop.travel);
    tuning.m_frictionSlip = 1;
    Vehicle vehicle(tuning, &chassis, &raycaster);
    world.dynamics.addVehicle(&vehicle);
    vehicle.setCoordinateSystem(0, 1, 2);
    for (int i = 0; i < drop.wheels; ++i) {
        const double at = 2 * std::numbers::pi * (i + 0.5) / drop.wheels;
        vehicle.addWheel(vector(around * std::sin(at), 0, around * std::cos(at)), vector(0, -1, 0), vector(-1, 0, 0),
                         scalar(drop.length()), scalar(drop.radius), tuning, std::cos(at) > 0);
    }
    if constexpr (std::is_same_v<Vehicle, RaycastVehicle>) vehicle.setSubstep(drop.substep);

    std::vector<double> heights;
    for (int i = 0; i < kSeconds * drop.rate; ++i) {
        run(world, 1 / drop.rate, drop.rate);
        heights.push_back(chassis.getCenterOfMassPosition().y());
    }
    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    return landing(heights, drop);
}

void expectLikeStock(const Drop& drop, double stock_rate) {
    SCOPED_TRACE(drop.name());
    Drop by_stock = drop;
    by_stock.rate = stock_rate;
    const Landing stock = land<btRaycastVehicle>(by_stock), car = land<RaycastVehicle>(drop);
    ASSERT_TRUE(car.finite);
    EXPECT_LT(car.rebound, stock.rebound + 0.03 * drop.height);
    if (!stock.settles()) return;
    EXPECT_LT(car.settled, 1.5 * stock.settled + 2 / drop.rate);
    EXPECT_NEAR(car.height, stock.height, 0.02 * drop.length());
}

// One step of tread for each of the world's, against stock at the same steps.
TEST(RaycastVehicleDrop, ComesToRestAsTheStockVehicleDoes) {
    for (double stiffness : {5.0, 20.0, 60.0, 120.0, 200.0}) {
        for (double damping : {0.0, 0.1, 0.3, 0.5}) {
            for (double radius : {0.05, 0.35, 1.0})
                expectLikeStock({.stiffness = stiffness, .damping = damping, .radius = radius}, 60);
        }
        for (double height : {0.1, 1.0}) expectLikeStock({.stiffness = stiffness, .height = height}, 60);
    }
}

TEST(RaycastVehicleDrop, OfAnyMassAndNumberOfWheels) {
    for (double stiffness : {20.0, 120.0}) {
        for (double radius : {0.05, 1.0}) {
            for (double mass : {3.0, 40e3})
                expectLikeStock({.stiffness = stiffness, .radius = radius, .mass = mass}, 60);
            for (int wheels : {3, 6}) {
                for (double damping : {0.1, 0.4})
                    expectLikeStock({.stiffness = stiffness, .damping = damping, .radius = radius, .wheels = wheels},
                                    60);
            }
        }
    }
}

// Short substeps follow the motion itself: so does stock at the same.
TEST(RaycastVehicleDrop, InSubstepsOfAMillisecond) {
    for (double stiffness : {5.0, 60.0, 200.0}) {
        for (double damping : {0.1, 0.3, 1.0})
            expectLikeStock({.stiffness = stiffness, .damping = damping, .substep = 0.001}, 1000);
    }
}

// Dampers that at 60 steps a second take more than the motion that there is turn it round in stock. They may not here.
TEST(RaycastVehicleDrop, OverdampedItDoesNotBounce) {
    for (double stiffness : {20.0, 60.0, 200.0}) {
        for (double damping : {1.0, 3.0, 10.0}) {
            const Drop drop{.stiffness = stiffness, .damping = damping};
            SCOPED_TRACE(drop.name());
            const Landing car = land<RaycastVehicle>(drop);
            // It may stand above the height of rest for long, but not above where it touched down.
            EXPECT_LT(car.rebound, drop.sag() + 0.05 * drop.height);
            EXPECT_LT(land<RaycastVehicle>({.stiffness = stiffness, .damping = damping, .substep = 0.001}).rebound,
                      drop.sag() + 0.03 * drop.height);
        }
    }
}

// As a box of a car with its wheels at the corners: roll is quicker than heave.
TEST(RaycastVehicleDrop, WithItsMassBetweenTheWheels) {
    for (double stiffness : {5.0, 20.0, 60.0, 120.0, 200.0}) {
        for (double height : {0.1, 0.5}) expectLikeStock({.stiffness = stiffness, .height = height, .spread = 2}, 60);
    }
}

TEST(RaycastVehicleDrop, WithStocksLargestForceAsGiven) {
    for (double stiffness : {20.0, 60.0, 200.0}) expectLikeStock({.stiffness = stiffness, .most_force = 6000}, 60);
}

// Into the end of the travel, where stock's force grows no more and leaves the rest to the chassis.
TEST(RaycastVehicleDrop, TheEndOfTheTravelDoesNotThrowTheCar) {
    for (double radius : {0.1, 0.35}) {
        for (double travel : {0.05, 0.1}) {
            for (double substep : {0.02, 0.001}) {
                for (double height : {0.5, 2.0}) {
                    const Drop drop{
                        .stiffness = 40, .radius = radius, .height = height, .substep = substep, .travel = travel};
                    SCOPED_TRACE(drop.name());
                    const Landing car = land<RaycastVehicle>(drop);
                    EXPECT_LT(car.rebound, 0.15 * height);
                    EXPECT_LT(car.settled, 3);
                }
            }
        }
    }
}

}  // namespace
}  // namespace tread::raycast_drop_test
