// A car on an uneven road: against the linear model of its ride, against statics, and against itself at smaller steps.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "shared/linear_ride.h"
#include "tread/road_surface.h"

namespace tread::road_ride_test {
namespace {

using reference::Vector14;
using reference::Vector7;

constexpr double kStep = 0.001;  // s

// What the road does to the coordinates of the linear model: tyre springs and dampers move with it, and the loads lean
// with its slopes, along x on the wheel centres, along y on the contacts.
Vector7 roadForces(const reference::Car& car, const RoadSurface& road) {
    const VehicleParams& params = car.vehicle.params;
    const Vector3 v = car.motion.velocity_W;
    Vector7 force = Vector7::Zero();
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = car.vehicle.corners[i];
        const Vector3 hub = car.motion.position_W + car.motion.orientation * corner.hub_B;
        const SurfacePoint ground = road.averaged(hub.x(), hub.y());
        const TyreCoefficients& tyre = corner.tyre.parameters;
        const double rise = ground.slope_x * v.x() + ground.slope_y * v.y();
        const double load = corner.static_force + corner.unsprung_mass * kStandardGravity;
        force(static_cast<int>(3 + i)) += tyre.pz1 * ground.height + tyre.pz2 * rise;
        force(1) -= load * ground.slope_y * params.centre_of_gravity_height;
        force(2) += load * ground.slope_x * (params.centre_of_gravity_height - (tyre.Ro - load / tyre.pz1));
    }
    return force;
}

TEST(RoadRide, RoughRoadMovesBodyAndWheelsAsTheLinearModelSays) {
    constexpr double kSpeed = 20;  // m/s
    for (const VehicleParams& shipped : {reference::compact(), reference::rearDriveSedan()}) {
        const VehicleParams params = reference::linearCar(shipped);
        RoadParams description;
        description.friction = 0;  // nothing but the ride moves
        description.roughness.road_class = RoadClass::A;
        description.roughness.begin = 5;
        const RoadSurface road(description);
        reference::Car car = reference::settled(params, road, {});
        const reference::Car rest = car;
        car.motion.velocity_W.x() = kSpeed;

        const reference::LinearModel model = reference::linearModel(params);
        const Eigen::MatrixXd system = model.system();
        const Eigen::MatrixXd inverse_mass = model.mass.inverse();
        const auto slope = [&](const Vector14& x, const Vector7& force) {
            Vector14 out = system * x;
            out.tail<7>() += inverse_mass * force;
            return out;
        };
        Vector14 x = Vector14::Zero();
        Vector7 force = roadForces(car, road), largest = Vector7::Zero(), error = Vector7::Zero();
        for (double t = 0; t < 10; t += kStep) {
            car.step(kStep);
            const Vector7 next = roadForces(car, road), middle = 0.5 * (force + next);
            const Vector14 k1 = slope(x, force), k2 = slope(x + 0.5 * kStep * k1, middle),
                           k3 = slope(x + 0.5 * kStep * k2, middle), k4 = slope(x + kStep * k3, next);
            x += kStep / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            force = next;
            Vector7 q = reference::coordinates(car, rest);
            for (std::size_t i = 0; i < kWheels; ++i) {
                // The radius is measured from the road.
                const Vector3 hub = car.motion.position_W + car.motion.orientation * car.vehicle.corners[i].hub_B;
                q(static_cast<int>(3 + i)) += road.averaged(hub.x(), hub.y()).height;
            }
            largest = largest.cwiseMax(x.head<7>().cwiseAbs());
            error = error.cwiseMax((x.head<7>() - q).cwiseAbs());
        }
        const Vector7 share = error.cwiseQuotient(largest);
        std::printf(
            "%s on class A at 20 m/s against the linear model: heave %.2f, roll %.2f, pitch %.2f, wheels "
            "%.2f %.2f %.2f %.2f %% of each peak\n",
            params.name.c_str(), 100 * share(0), 100 * share(1), 100 * share(2), 100 * share(3), 100 * share(4),
            100 * share(5), 100 * share(6));
        EXPECT_LT(share.maxCoeff(), 0.02);
    }
}

RoadSurface roadWith(Obstacle obstacle) {
    RoadParams road;
    road.obstacles.push_back(std::move(obstacle));
    return RoadSurface(road);
}

// Slowly onto a kerb of 5 cm and on: the car is 5 cm higher, and level again.
TEST(RoadRide, KerbLiftsTheCarByItsHeight) {
    for (const auto& shape : {decltype(Obstacle::shape){PlankShape{}}, decltype(Obstacle::shape){RampShape{0.4}}}) {
        const RoadSurface road = roadWith({.x = 3, .height = 0.05, .shape = shape});
        reference::Car car = reference::settled(reference::compact(), road, {.speed = 3});
        const VehicleOutput before = car.output();
        double highest_load = 0, climb = 0;
        for (double t = 0; t < 6; t += kStep) {
            car.step(kStep);
            highest_load = std::max(highest_load, car.output().wheel.front_left.load);
            climb = std::max(climb, std::abs(car.output().chassis.pitch - before.chassis.pitch));
        }
        const VehicleOutput after = car.output();
        ASSERT_GT(after.chassis.x, 8) << "all wheels are up";
        EXPECT_NEAR(after.chassis.z - before.chassis.z, 0.05, 1e-4);
        EXPECT_NEAR(after.chassis.pitch, before.chassis.pitch, 1e-4);
        EXPECT_NEAR(after.wheel.front_left.load, before.wheel.front_left.load, 5);
        EXPECT_GT(climb, 0.5 * 0.05 / car.vehicle.params.wheelbase);
        EXPECT_GT(highest_load, 1.1 * before.wheel.front_left.load);
        EXPECT_LT(highest_load, 4 * before.wheel.front_left.load);
    }
}

// A pothole under the left wheels: they fall, the right ones do not.
TEST(RoadRide, PotholeIsFeltOnItsSide) {
    const RoadSurface road = roadWith({.x = 3, .y = 0.8, .length = 0.8, .width = 0.6, .height = -0.05, .shape = {}});
    reference::Car car = reference::settled(reference::compact(), road, {.speed = 10});
    double left = 0, right = 0;
    const double rest = car.output().wheel.front_left.travel;
    for (double t = 0; t < 0.5; t += kStep) {
        car.step(kStep);
        left = std::max(left, rest - car.output().wheel.front_left.travel);
        right = std::max(right, std::abs(rest - car.output().wheel.front_right.travel));
    }
    EXPECT_GT(left, 0.01);
    EXPECT_LT(right, 0.3 * left);
}

// Over a bump at 10 m/s, at ever smaller steps.
struct BumpRun {
    std::vector<double> load, height;  // every 4 ms
};
BumpRun overBump(const RoadSurface& road, double step) {
    reference::Car car = reference::settled(reference::compact(), road, {.speed = 10});
    BumpRun run;
    const int per_row = static_cast<int>(std::lround(0.004 / step));
    for (int k = 1; k * step < 1.2; ++k) {
        car.step(step);
        if (k % per_row != 0) continue;
        run.load.push_back(car.output().wheel.front_left.load);
        run.height.push_back(car.output().chassis.z);
    }
    return run;
}
double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST(RoadRide, BumpConvergesWithTheStep) {
    const RoadSurface road = roadWith({.x = 4, .length = 1, .height = 0.04, .shape = {}});
    const BumpRun fine = overBump(road, 0.000125);
    const double peak = *std::max_element(fine.load.begin(), fine.load.end());
    const double rise = *std::max_element(fine.height.begin(), fine.height.end()) - fine.height.front();
    std::printf("bump of 40 mm at 10 m/s: front wheel load to %.0f N (rest %.0f N), body rises by %.1f mm\n", peak,
                fine.load.front(), 1000 * rise);
    EXPECT_GT(peak, 1.3 * fine.load.front());
    EXPECT_LT(rise, 0.04) << "the body is lifted by less than the bump";
    EXPECT_GT(rise, 0.004);

    double before = 0;
    for (const double step : {0.004, 0.002, 0.001, 0.0005}) {
        const BumpRun run = overBump(road, step);
        const double load = largestDifference(run.load, fine.load) / peak;
        const double height = largestDifference(run.height, fine.height) / rise;
        std::printf("  step %.1f ms: load %.3f %% of its peak, body %.3f %% of its rise\n", 1000 * step, 100 * load,
                    100 * height);
        if (before > 0) {
            EXPECT_LT(load, 0.55 * before) << "at least first order at " << step;
        }
        if (step == 0.001) {
            EXPECT_LT(load, 0.01);
            EXPECT_LT(height, 0.01);
        }
        before = load;
    }
}

}  // namespace
}  // namespace tread::road_ride_test
