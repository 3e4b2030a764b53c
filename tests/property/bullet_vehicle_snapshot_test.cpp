// Motion, state and input of a car in a Bullet world are all of it: put back into it, it drives on bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "run/world.h"
#include "shared/vehicle_run.h"
#include "tread/bullet_vehicle.h"
#include "tread/equilibrium.h"
#include "tread/road_surface.h"

namespace tread::bullet_vehicle_snapshot_test {
namespace {

constexpr double kStep = 1 / 120.0;  // s, of several substeps

VehicleInput wild(int step) {
    return {.steering_wheel_angle = 2 * std::sin(0.1 * step),
            .throttle = step % 60 < 30 ? 0.8 : 0,
            .brake = step % 60 < 45 ? 0 : 0.9};
}

bool same(const ChassisMotion& a, const ChassisMotion& b) {
    return a.position_W == b.position_W && a.orientation.coeffs() == b.orientation.coeffs() &&
           a.velocity_W == b.velocity_W && a.angular_velocity_W == b.angular_velocity_W;
}

TEST(BulletVehicleSnapshot, IsDrivenAgainBitForBit) {
    const VehicleParams params = shared::compact();
    World world(params);
    RoadParams rough;
    rough.grade = 0.03;
    rough.roughness.road_class = RoadClass::C;
    const auto road = makeRoad(rough);
    BulletVehicle car(params, world.chassis(), *road);
    const Equilibrium start = equilibrium(car.vehicle(), {*road}, {.speed = 20, .input = {}});
    car.restore(start.motion, start.state, start.input);
    const auto drive = [&](int from, int to) {
        for (int i = from; i < to; ++i) {
            car.setInput(wild(i));
            car.plan(kStep);
            world.step(kStep);
            car.observe();
        }
    };
    drive(0, 100);
    const ChassisMotion motion = car.motion();
    const VehicleState state = car.state();
    drive(100, 300);
    const ChassisMotion end = car.motion();
    const VehicleState end_state = car.state();
    EXPECT_FALSE(same(motion, end));

    for (int repeat = 0; repeat < 2; ++repeat) {
        car.restore(motion, state, wild(99));
        drive(100, 300);
        EXPECT_TRUE(same(car.motion(), end));
        EXPECT_EQ(std::memcmp(&car.state(), &end_state, sizeof end_state), 0);
    }
}

}  // namespace
}  // namespace tread::bullet_vehicle_snapshot_test
