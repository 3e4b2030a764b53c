#include "report/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "report/replay_road.h"
#include "shared/base64.h"
#include "tread/road_surface.h"

namespace tread::replay_test {
namespace {

using Json = nlohmann::json;

// Straight on at 20 m/s for 2 s, 1 kHz.
Log straightOn() {
    Log log{{{"time", "s", {}}, {"chassis.x", "m", {}}, {"chassis.y", "m", {}}, {"chassis.yaw", "rad", {}}}};
    for (int i = 0; i <= 2000; ++i) {
        const std::array row{0.001 * i, 0.02 * i, 0.0, 0.0};
        for (std::size_t k = 0; k < row.size(); ++k) log.channels[k].values.push_back(row[k]);
    }
    return log;
}

void add(Log& log, const std::string& name, const std::string& unit, double value) {
    log.channels.push_back({name, unit, std::vector<double>(log.samples(), value)});
}

Json replayed(const Log& log, const ReplayScene& scene = {}) {
    return Json::parse(replayData({{"car", log, typicalCarShape()}}, scene));
}

std::vector<float> channel(const Json& holder, const char* name) {
    return unpacked<float>(holder["channels"][name].get<std::string>());
}

TEST(Replay, ALogThatDoesNotSayWhereTheCarIsHasNone) {
    Log log = straightOn();
    log.channels.pop_back();
    EXPECT_EQ(replayData({{"car", log, typicalCarShape()}}, {}), "");
}

TEST(Replay, FramesKeepTheirTimesAndTheLastRow) {
    const Json car = replayed(straightOn())["cars"][0];
    const auto time = unpacked<double>(car["time"].get<std::string>());
    ASSERT_EQ(time.size(), 101u) << "50 frames a second";
    EXPECT_EQ(time.back(), 2.0);
    const auto x = channel(car, "x");
    for (std::size_t i = 0; i < time.size(); ++i) EXPECT_NEAR(x[i], 20 * time[i], 1e-5);
}

TEST(Replay, WheelsTurnAsFarAsTheirSpinSaysAndStandOnTheRoadOfALevelCar) {
    Log log = straightOn();
    add(log, "wheel.rear_left.spin", "rad/s", 64.0);
    for (const char* level : {"chassis.roll", "chassis.pitch", "wheel.rear_left.steer"}) add(log, level, "rad", 0);
    add(log, "chassis.z", "m", 0.54);
    add(log, "wheel.rear_left.camber", "rad", -0.02);
    const Json wheel = replayed(log)["cars"][0]["wheels"][2];
    EXPECT_NEAR(channel(wheel, "turn").back(), 128.0, 1e-4);
    EXPECT_NEAR(channel(wheel, "lean").back(), -0.02, 1e-7)
        << "camber against a level road is lean against a level body";
    EXPECT_FALSE(wheel["channels"].contains("load")) << "what is not logged is not shown";
}

TEST(Replay, AWheelThatLeansWithItsBodyHasNoLeanOfItsOwn) {
    Log log = straightOn();
    add(log, "chassis.roll", "rad", 0.05);
    for (const char* level : {"chassis.pitch", "wheel.front_left.steer"}) add(log, level, "rad", 0);
    add(log, "chassis.z", "m", 0.54);
    add(log, "wheel.front_left.camber", "rad", 0.05);  // right side down: the top goes to the right
    EXPECT_NEAR(channel(replayed(log)["cars"][0]["wheels"][0], "lean").back(), 0.0, 1e-7);
}

TEST(Replay, ACarWithoutLoggedHeightStandsOnTheRoad) {
    ReplayScene scene;
    scene.road.grade = 0.1;
    const Json car = replayed(straightOn(), scene)["cars"][0];
    EXPECT_NEAR(channel(car, "z").back(), 0.1 * 40 + typicalCarShape().height, 1e-5);
}

TEST(ReplayRoad, APlaneNeedsNoMesh) {
    const std::array<Point, 2> way{{{0, 0}, {100, 0}}};
    RoadParams plane;
    plane.grade = 0.05;
    plane.bank = 0.02;
    const auto road = replayRoad(plane, way);
    EXPECT_TRUE(road["mesh"].is_null());
    EXPECT_EQ(road["grade"], 0.05);
}

TEST(ReplayRoad, TheMeshHasTheHeightsOfTheRoadAboveItsPlane) {
    RoadParams params;
    params.grade = 0.03;
    Obstacle bump;
    bump.x = 5;
    bump.length = 1;
    bump.height = 0.04;
    params.obstacles.push_back(bump);
    const std::array<Point, 3> way{{{0, 0}, {5, 0}, {10, 0}}};
    const auto mesh = replayRoad(params, way)["mesh"];
    ASSERT_FALSE(mesh.is_null());
    const auto steps = unpacked<std::uint16_t>(mesh["heights"].get<std::string>());
    const RoadSurface surface(params);
    std::size_t next = 0;
    double highest = 0;
    for (const auto& tile : mesh["tiles"]) {
        const int cells = tile[2];
        for (int i = 0; i <= cells; ++i) {
            for (int j = 0; j <= cells; ++j) {
                const double side = mesh["tile"], x = side * (tile[0].get<double>() + double(i) / cells),
                             y = side * (tile[1].get<double>() + double(j) / cells);
                const double height = mesh["lowest"].get<double>() + mesh["step"].get<double>() * steps.at(next++);
                EXPECT_NEAR(height, surface.at(x, y).height - params.grade * x, 1e-6);
                highest = std::max(highest, height);
            }
        }
    }
    EXPECT_EQ(next, steps.size());
    EXPECT_NEAR(highest, 0.04, 1e-6);
}

TEST(ReplayRoad, PatchesEndWhereTheDrawnRoadEnds) {
    RoadParams params;
    params.friction = 0.8;
    FrictionPatch near, far;
    near.friction = far.friction = 0.5;
    near.x_from = 10;
    near.y_from = 0;
    far.x_from = 1000;
    params.friction_patches = {near, far};
    const std::array<Point, 2> way{{{0, 0}, {100, 0}}};
    const auto road = replayRoad(params, way);
    ASSERT_EQ(road["patches"].size(), 1u) << "the other one lies far away";
    EXPECT_DOUBLE_EQ(road["patches"][0]["friction"], 0.4);
    EXPECT_EQ(road["patches"][0]["area"][0], 10);
    EXPECT_EQ(road["patches"][0]["area"][1], road["area"][1]);
}

}  // namespace
}  // namespace tread::replay_test
