// The parts of a driveline on the whole car: no transient at the start, and what an electric car does with its brakes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shared/vehicles.h"

namespace tread::vehicle_driveline_test {
namespace {

constexpr double kStep = 0.001;  // s

VehicleParams withConverter() {
    VehicleParams params = reference::rearDriveSedan();
    params.name = "converter";
    params.driveline.coupling =
        TorqueConverterParams{.capacity = {{{0, 0.0042}, {0.6, 0.0039}, {0.85, 0.0025}, {1, 0}}},
                              .torque_ratio = {{{0, 2.1}, {0.85, 1}}},
                              .lock_up_torque = 250,
                              .lock_up_speed_ratio = 0.85,
                              .lock_up_gear = 3};
    return params;
}

VehicleParams electric() {
    VehicleParams params = reference::compact();
    params.name = "electric";
    params.driveline.engine.reset();
    params.driveline.motor = MotorParams{.torque = 250,
                                         .power = 100e3,
                                         .speed_limit = 1500,
                                         .inertia = 0.06,
                                         .drag = {{{0, 0.5}, {1500, 3}}},
                                         .lift_off_regeneration = 0.15,
                                         .brake_regeneration = 0.6};
    params.driveline.gearbox = {.ratios = {1}, .final_drive = 9, .efficiency = 0.97, .inertia = 0.005};
    return params;
}

VehicleParams locked() {
    VehicleParams params = reference::compact();
    params.name = "all axles locked";
    params.driveline.front_share = 0.5;
    params.driveline.front_differential = params.driveline.rear_differential = LockedDifferential{};
    params.driveline.centre_differential = LockedDifferential{};
    return params;
}

std::vector<VehicleParams> cars() {
    VehicleParams lagging = reference::compact();
    lagging.name = "lag and map";
    lagging.driveline.engine->response_time = 0.2;
    lagging.driveline.engine->part_load = {{0.3, {{{80, 60}, {700, 5}}}}};
    return {reference::compact(), reference::rearDriveSedan(), withConverter(), electric(), lagging};
}

TEST(DrivelineOfACar, RollsOnFromItsEquilibriumWithoutATransient) {
    const PlaneRoad road;
    std::vector<VehicleParams> all = cars();
    all.push_back(locked());
    for (const VehicleParams& params : all) {
        for (const double speed : {7.0, 22.0, 33.0}) {
            reference::Car car = reference::settled(params, road, {.speed = speed});
            const VehicleOutput start = car.output();
            double engine = 0, torque = 0;
            for (int k = 0; k < 2000; ++k) {
                car.step(kStep);
                const VehicleOutput now = car.output();
                engine = std::max(engine, std::abs(now.driveline.engine_speed - start.driveline.engine_speed));
                torque = std::max(torque,
                                  std::abs(now.wheel.rear_left.drive_torque + now.wheel.front_left.drive_torque -
                                           start.wheel.rear_left.drive_torque - start.wheel.front_left.drive_torque));
            }
            EXPECT_NEAR(car.output().chassis.vx, speed, 2e-3) << params.name;
            EXPECT_LT(engine, 0.1) << params.name << " at " << speed;
            EXPECT_LT(torque, 0.6) << params.name << " at " << speed;
        }
    }
}

TEST(DrivelineOfACar, IdlesFromTheFirstStepOnWhileTheBrakeHoldsTheCar) {
    const PlaneRoad road;
    for (const VehicleParams& params : cars()) {
        reference::Car car = reference::settled(params, road, {.input = {.brake = 0.5}});
        const double start = car.state.driveline.engine_speed;
        const Vector3 place = car.motion.position_W;
        for (int k = 0; k < 2000; ++k) {
            car.step(kStep);
            ASSERT_NEAR(car.state.driveline.engine_speed, start, 1e-3) << params.name << " after " << k;
        }
        EXPECT_LT((car.motion.position_W - place).norm(), 1e-4) << params.name;
    }
}

TEST(DrivelineOfACar, ConverterCreepsWhenTheBrakeIsReleased) {
    const PlaneRoad road;
    reference::Car car = reference::settled(withConverter(), road, {.input = {.brake = 0.5}});
    for (int k = 0; k < 8000; ++k) car.step(VehicleInput{}, kStep);
    const double speed = car.motion.velocity_W.x();
    EXPECT_GT(speed, 1);
    EXPECT_LT(speed, 4);
}

TEST(DrivelineOfACar, BlendedBrakingSlowsTheCarAsItsBrakesAloneWould) {
    const PlaneRoad road;
    const auto stopped = [&](double share) {
        VehicleParams params = electric();
        params.driveline.motor->lift_off_regeneration = 0;
        params.driveline.motor->brake_regeneration = share;
        params.brakes.front_disc.heat_capacity = params.brakes.rear_disc.heat_capacity = 5000;
        reference::Car car = reference::settled(params, road, {.speed = 22});
        VehicleInput in = car.input;
        in.throttle = 0;
        for (int k = 1; car.motion.velocity_W.x() > 8; ++k) {
            in.brake = std::min(0.3, k * 0.002);
            car.step(in, kStep);
        }
        return car;
    };
    const reference::Car blended = stopped(0.6), alone = stopped(0);
    EXPECT_NEAR(blended.motion.position_W.x(), alone.motion.position_W.x(), 0.01 * alone.motion.position_W.x());
    EXPECT_LT(blended.state.brakes.heating.front_left, 0.6 * alone.state.brakes.heating.front_left);
}

}  // namespace
}  // namespace tread::vehicle_driveline_test
