// Many cars as one action: the same as each alone, for any number of threads.
#include "tread/raycast_fleet.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "benchmark/game_scene.h"
#include "stock_vs_tread/scene.h"

namespace tread::raycast_fleet_test {
namespace {

using namespace scene;

// 30 cars, each with its own way to drive; some on platforms that the cars push.
class Lot {
public:
    enum class On { ground, planks, field, mesh };
    explicit Lot(On on) {
        hills.add(world, on == On::field  ? game::Ground::height_field
                         : on == On::mesh ? game::Ground::mesh
                                          : game::Ground::plane);
        for (int i = 0; i < 30; ++i) {
            const btVector3 at = vector(6 * (i % 6), on == On::planks ? 0.2 : 0, 9 * (i / 6));
            if (on == On::planks && i % 6 % 2 == 0)  // two cars each
                world.addBox(5.5, 0.09, 4, 800, at + vector(3, -0.1, 0));
            cars.push_back(std::make_unique<Car<RaycastVehicle>>(
                world, Setup{.speed = on == On::planks ? 0.0 : i % 7,
                             .sleeps = i % 3 == 0,
                             .place = btTransform(btQuaternion::getIdentity(), at)}));
            cars.back()->steer(0.02 * (i % 5 - 2));
            cars.back()->push(on == On::planks ? 400.0 * (i % 3) : 300.0 * (i % 4));
            cars.back()->brake(i % 4 == 3 ? 40 : 0);
        }
    }
    ~Lot() {
        if (fleet) world.dynamics.removeAction(fleet.get());
    }
    void make(int threads) {
        fleet = std::make_unique<RaycastFleet>(threads);
        for (auto& car : cars) {
            world.dynamics.removeVehicle(car->vehicle.get());
            fleet->add(*car->vehicle);
        }
        world.dynamics.addAction(fleet.get());
    }

    game::Hills hills;
    World world;
    std::vector<std::unique_ptr<Car<RaycastVehicle>>> cars;
    std::unique_ptr<RaycastFleet> fleet;
};

bool same(const Lot& a, const Lot& b) {
    for (std::size_t i = 0; i < a.cars.size(); ++i) {
        const btTransform x = a.cars[i]->chassis->getWorldTransform(), y = b.cars[i]->chassis->getWorldTransform();
        const WheelTelemetry s = a.cars[i]->vehicle->telemetry(3), t = b.cars[i]->vehicle->telemetry(3);
        if (!(x == y) || std::memcmp(&s, &t, sizeof s) != 0) return false;
    }
    return true;
}

TEST(RaycastFleet, DoesWhatItsCarsDoAloneBitForBit) {
    Lot alone(Lot::On::ground), one(Lot::On::ground), four(Lot::On::ground);
    one.make(1);
    four.make(4);
    for (int second = 1; second <= 4; ++second) {
        for (Lot* lot : {&alone, &one, &four}) run(lot->world, 1, 60);
        EXPECT_TRUE(same(alone, one)) << second << " s";
        EXPECT_TRUE(same(alone, four)) << second << " s";
    }
    EXPECT_GT(alone.cars[1]->place().z(), 5) << "it has driven";
}

TEST(RaycastFleet, ThreadsMakeNoDifferenceOnGroundThatMoves) {
    Lot one(Lot::On::planks), three(Lot::On::planks), many(Lot::On::planks);
    one.make(1);
    three.make(3);
    many.make(16);
    const btVector3 before = one.cars[0]->place();
    for (Lot* lot : {&one, &three, &many}) run(lot->world, 3, 60);
    EXPECT_TRUE(same(one, three));
    EXPECT_TRUE(same(one, many));
    EXPECT_LT((one.cars[0]->place() - before).length(), 20);
}

// Bullet's shapes and broadphase are asked from all threads at once.
TEST(RaycastFleet, ThreadsMakeNoDifferenceOnHills) {
    for (const Lot::On on : {Lot::On::field, Lot::On::mesh}) {
        Lot alone(on), four(on);
        four.make(4);
        for (Lot* lot : {&alone, &four}) run(lot->world, 3, 60);
        EXPECT_TRUE(same(alone, four));
        EXPECT_GT(alone.cars[1]->place().z(), 3) << "it has driven";
    }
}

TEST(RaycastFleet, CarsComeAndGo) {
    Lot lot(Lot::On::ground);
    lot.make(2);
    EXPECT_EQ(lot.fleet->size(), 30);
    lot.fleet->add(*lot.cars[5]->vehicle);
    EXPECT_EQ(lot.fleet->size(), 30) << "it is there";
    lot.fleet->remove(*lot.cars[5]->vehicle);
    lot.fleet->remove(*lot.cars[5]->vehicle);
    EXPECT_EQ(lot.fleet->size(), 29);
    run(lot.world, 1, 60);
    EXPECT_LT(lot.cars[5]->place().y(), 0.4) << "nothing carries it any more";
    EXPECT_NEAR(lot.cars[6]->place().y(), 0.54, 0.02);
    lot.world.dynamics.addVehicle(lot.cars[5]->vehicle.get());  // back to a life of its own
    run(lot.world, 1, 60);
}

TEST(RaycastFleet, WhatASurfaceThrowsArrives) {
    Lot lot(Lot::On::ground);
    lot.make(2);
    lot.cars[7]->vehicle->setSurface(
        [](const SurfaceQuery&) -> Surface { throw std::runtime_error("no such material"); });
    EXPECT_THROW(run(lot.world, 0.1, 60), std::runtime_error);
    lot.cars[7]->vehicle->clearSurface();
    run(lot.world, 1, 60);
    EXPECT_NEAR(lot.cars[7]->place().y(), 0.54, 0.02) << "and then it goes on";
}

}  // namespace
}  // namespace tread::raycast_fleet_test
