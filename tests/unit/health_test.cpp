#include "run/health.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "base/fields/numbers.h"
#include "run/simulate.h"

namespace tread::health_test {
namespace {

std::string complaint(const VehicleOutput& output) {
    try {
        checkHealth(output, 1.25);
        return "";
    } catch (const SimulationError& error) {
        return error.what();
    }
}

TEST(Health, DrivingCarIsHealthy) {
    VehicleOutput output;
    output.chassis.vx = 50;
    output.chassis.roll = 0.1;
    EXPECT_EQ(complaint(output), "");
}

TEST(Health, NumberThatIsNotFiniteIsNamed) {
    VehicleOutput output;
    output.chassis.ay = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint(output),
              "the simulation broke down at t = 1.25 s: chassis.ay is nan (a parameter far from that of a real car, or "
              "a step that is too long, can do this)");
    output = {};
    output.wheel[2].spin = std::numeric_limits<double>::infinity();
    EXPECT_EQ(complaint(output).substr(0, 63), "the simulation broke down at t = 1.25 s: wheel.rear_left.spin i");
}

TEST(Health, EachStateOfTheCarHasABound) {
    VehicleOutput output;
    output.driveline.engine_speed = 6e306;
    EXPECT_EQ(
        complaint(output),
        "the simulation broke down at t = 1.25 s: driveline.engine_speed is 6e+306 rad/s, more than 20000 rad/s (a "
        "parameter far from that of a real car, or a step that is too long, can do this)");
    const auto complainsOf = [](const std::string& path, auto&& change) {
        VehicleOutput changed;
        change(changed);
        EXPECT_NE(complaint(changed).find(": " + path + " is "), std::string::npos) << complaint(changed);
    };
    complainsOf("chassis.yaw_rate", [](VehicleOutput& car) { car.chassis.yaw_rate = -1e5; });
    complainsOf("wheel.front_right.spin", [](VehicleOutput& car) { car.wheel[1].spin = -1e5; });
    complainsOf("wheel.rear_left.travel", [](VehicleOutput& car) { car.wheel[2].travel = 11; });
    complainsOf("wheel.rear_right.patch_v", [](VehicleOutput& car) { car.wheel[3].patch_v = 11; });
    complainsOf("wheel.front_left.brake_temperature", [](VehicleOutput& car) { car.wheel[0].brake_temperature = 5e3; });
    complainsOf("wheel.rear_left.temperature",
                [](VehicleOutput& car) { car.wheel[2].temperature = std::numeric_limits<double>::quiet_NaN(); });
}

TEST(Health, CarThatLiesOnItsSideOrFliesAwayIsNamed) {
    VehicleOutput output;
    output.chassis.roll = 1.6;
    EXPECT_EQ(complaint(output), "the car rolled over at t = 1.25 s: chassis.roll is 92 deg, chassis.pitch 0 deg");
    output = {};
    output.chassis.vz = -300;
    EXPECT_EQ(
        complaint(output),
        "the car left the bounds of the simulation at t = 1.25 s: its speed (chassis.vx, vy, vz) is 300 m/s, more "
        "than 200 m/s");
    output = {};
    output.chassis.x = 2e6;
    EXPECT_EQ(
        complaint(output),
        "the car left the bounds of the simulation at t = 1.25 s: it is 2e+06 m from the origin (chassis.x, y, z)");
}

}  // namespace
}  // namespace tread::health_test
