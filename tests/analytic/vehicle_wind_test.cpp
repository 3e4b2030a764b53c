// Wind on the whole car, against balances of forces.

#include <gtest/gtest.h>

#include <cmath>

#include "shared/vehicles.h"

namespace tread::vehicle_wind_test {
namespace {

constexpr double kStep = 0.001;  // s

VehicleParams withSides() {
    VehicleParams params = reference::compact();
    params.aero.side_force_area = {{{0, 0}, {0.6, 1.4}}};
    params.aero.yaw_moment_volume = {{{0, 0}, {0.6, 0.9}}};
    params.aero.roll_moment_volume = {{{0, 0}, {0.6, 0.3}}};
    return params;
}

TEST(Wind, StandingCarTakesTheSideForceOfASteadyCrosswindWithItsTyres) {
    const PlaneRoad road;
    reference::Car car = reference::settled(withSides(), road, {.input = {.brake = 1}});
    double before = 0;
    for (std::size_t i = 0; i < kWheels; ++i) before += car.state.wheels[i].fy;
    car.wind_W = {0, 18, 0};
    for (int k = 0; k < 12000; ++k) car.step(kStep);
    double after = 0;
    for (std::size_t i = 0; i < kWheels; ++i) after += reference::roadForce(car, i).force_W.y();
    const AeroParams& aero = car.vehicle.params.aero;
    const double pressure = 0.5 * aero.air_density * 18 * 18;
    EXPECT_NEAR(after - before, -pressure * (1.4 + aero.drag_area), 0.5) << "side force and the drag of the wind";
    EXPECT_LT(std::abs(car.output().chassis.vy), 1e-6);
}

TEST(Wind, RoadCarriesTheMomentOfTheWindOnAStandingCar) {
    const PlaneRoad road;
    reference::Car car = reference::settled(withSides(), road, {.input = {.brake = 1}});
    // Moment of the road's forces and of the weight about the x axis of the world.
    const auto moment = [&] {
        double sum = car.motion.position_W.cross(car.vehicle.params.mass * car.gravity_W).x();
        for (std::size_t i = 0; i < kWheels; ++i) {
            const reference::RoadForce force = reference::roadForce(car, i);
            sum += force.point_W.cross(force.force_W).x();
        }
        return sum;
    };
    const double before = moment();
    car.wind_W = {0, -18, 0};
    for (int k = 0; k < 6000; ++k) car.step(kStep);
    const AeroParams& aero = car.vehicle.params.aero;
    const double pressure = 0.5 * aero.air_density * 18 * 18;
    // Blowing to the right, at `height`: the road holds against it.
    const double of_wind = pressure * ((1.4 + aero.drag_area) * aero.height + 0.3);
    EXPECT_NEAR(moment() - before, -of_wind, 0.01 * of_wind);
}

TEST(Wind, HeadwindIsFeltAsSpeedThroughTheAir) {
    const PlaneRoad road;
    const VehicleParams params = reference::compact();
    const auto drag = [&](double speed, double wind) {
        const Vehicle car = prepare(params);
        const Equilibrium rest =
            equilibrium(car, {.road = road, .wind_W = {-wind, 0, 0}}, {.speed = speed, .input = {}});
        EXPECT_LT(rest.acceleration, 1e-5);
        double force = 0;
        for (std::size_t i = 0; i < kWheels; ++i) force += rest.state.wheels[i].fx;
        return force;
    };
    const double more = 0.5 * params.aero.air_density * params.aero.drag_area * (30 * 30 - 20 * 20);
    EXPECT_NEAR(drag(20, 10) - drag(20, 0), more, 0.02 * more) << "the lift changes the rolling resistance a little";
}

TEST(Wind, CarWithTheWindAtItsSpeedFeelsNone) {
    const PlaneRoad road;
    VehicleParams params = reference::compact(), bare = params;
    bare.aero.drag_area = bare.aero.front_lift_area = bare.aero.rear_lift_area = 0;
    const Equilibrium with =
        equilibrium(prepare(params), {.road = road, .wind_W = {20, 0, 0}}, {.speed = 20, .input = {}});
    const Equilibrium without = equilibrium(prepare(bare), {.road = road}, {.speed = 20, .input = {}});
    EXPECT_NEAR(with.throttle, without.throttle, 1e-6);
}

TEST(Wind, CrosswindPushesADrivingCarAndYawsItAwayFromTheWind) {
    const PlaneRoad road;
    reference::Car car = reference::settled(withSides(), road, {.speed = 30});
    car.wind_W = {0, 15, 0};  // from the right to the left
    for (int k = 0; k < 500; ++k) car.step(kStep);
    EXPECT_GT(car.motion.position_W.y(), 0);
    EXPECT_GT(car.output().chassis.yaw_rate, 0);
    EXPECT_GT(0, car.output().chassis.roll) << "leans to the left";
}

}  // namespace
}  // namespace tread::vehicle_wind_test
