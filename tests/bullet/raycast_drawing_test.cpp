// Wheels drawn between two steps of the world belong to the chassis that is drawn.

#include <LinearMath/btDefaultMotionState.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_drawing_test {
namespace {

using namespace scene;

constexpr bool kDouble = sizeof(btScalar) == sizeof(double);

// A car whose chassis has a motion state, in a world of 60 steps a second.
struct Drawn {
    explicit Drawn(const Setup& setup = {}) : car(world, setup) {
        world.addPlane();
        state.setWorldTransform(car.chassis->getWorldTransform());
        car.chassis->setMotionState(&state);
        car.chassis->setLinearVelocity(vector(0, 0, setup.speed));
    }
    void draw(double seconds) { world.dynamics.stepSimulation(scalar(seconds), 10, scalar(1.0 / 60)); }
    btTransform shown() const {
        btTransform pose;
        state.getWorldTransform(pose);
        return pose;
    }
    World world;
    Car<RaycastVehicle> car;
    btDefaultMotionState state;
};

TEST(RaycastVehicleDrawing, AtTheEndOfAStepIsWhatBulletShows) {
    World world;
    world.addPlane();
    Car<RaycastVehicle> car(world, {.speed = 10});
    car.steer(0.1);
    run(world, 1, 60);
    for (int i = 0; i < 4; ++i) {
        car.vehicle->updateWheelTransform(i, false);
        const btTransform &bullet = car.vehicle->getWheelTransformWS(i), own = car.vehicle->drawnWheel(i);
        EXPECT_LT((own.getOrigin() - bullet.getOrigin()).length(), kDouble ? 1e-12 : 1e-5);
        for (int row = 0; row < 3; ++row)
            EXPECT_LT((own.getBasis()[row] - bullet.getBasis()[row]).length(), kDouble ? 1e-12 : 1e-5);
    }
}

// At 144 pictures a second a wheel turns as far as the drawn car goes, in every picture.
TEST(RaycastVehicleDrawing, WheelsTurnWithTheWayThatIsDrawn) {
    Drawn scene({.speed = 10});
    for (int i = 0; i < 144; ++i) scene.draw(1.0 / 144);
    const auto turn = [&](const btTransform& wheel) {
        const btVector3 spoke = scene.shown().getBasis().transpose() * wheel.getBasis().getColumn(2);
        return std::atan2(double(spoke.y()), double(spoke.z()));
    };
    double worst = 0, worst_of_bullet = 0;
    double before = turn(scene.car.vehicle->drawnWheel(0)), z = scene.shown().getOrigin().z();
    scene.car.vehicle->updateWheelTransform(0, true);
    double before_of_bullet = turn(scene.car.vehicle->getWheelTransformWS(0));
    const double radius = 10 / scene.car.vehicle->telemetry(0).spin;
    for (int i = 0; i < 200; ++i) {
        scene.draw(1.0 / 144);
        const auto off = [&](double now, double last) {
            const double way = scene.shown().getOrigin().z() - z;
            return std::abs(std::remainder(std::abs(std::remainder(now - last, 2 * M_PI)) - way / radius, 2 * M_PI));
        };
        const double now = turn(scene.car.vehicle->drawnWheel(0));
        scene.car.vehicle->updateWheelTransform(0, true);
        const double now_of_bullet = turn(scene.car.vehicle->getWheelTransformWS(0));
        worst = std::max(worst, off(now, before));
        worst_of_bullet = std::max(worst_of_bullet, off(now_of_bullet, before_of_bullet));
        before = now;
        before_of_bullet = now_of_bullet;
        z = scene.shown().getOrigin().z();
    }
    EXPECT_LT(worst, 0.02) << "rad";
    EXPECT_GT(worst_of_bullet, 0.2) << "rad: it shows the wheel of the last step on the chassis of another instant";
}

// A car that bounces: what is drawn of a wheel goes up and down as smoothly as the body does, with no jerk in the
// rhythm of steps and pictures.
TEST(RaycastVehicleDrawing, SuspensionBelongsToTheDrawnBody) {
    Drawn scene({.damping = 0.5, .height = 0.58, .speed = 5});
    for (int i = 0; i < 60; ++i) scene.draw(1.0 / 144);
    std::vector<double> own, bullet;
    for (int i = 0; i < 100; ++i) {
        scene.draw(1.0 / 144);
        own.push_back(scene.car.vehicle->drawnWheel(0).getOrigin().y());
        scene.car.vehicle->updateWheelTransform(0, true);
        bullet.push_back(scene.car.vehicle->getWheelTransformWS(0).getOrigin().y());
    }
    const auto jerks = [](const std::vector<double>& y) {
        double sum = 0;
        for (std::size_t i = 2; i < y.size(); ++i) sum += std::abs(y[i] - 2 * y[i - 1] + y[i - 2]);
        return sum;
    };
    EXPECT_LT(jerks(own), 0.25 * jerks(bullet));
    EXPECT_GT(*std::max_element(own.begin(), own.end()) - *std::min_element(own.begin(), own.end()), 0.005)
        << "it moves";
}

TEST(RaycastVehicleDrawing, SteeringComesWithTheChassis) {
    Drawn scene({.speed = 8});
    double worst = 0, last = 0;
    for (int i = 0; i < 288; ++i) {
        scene.car.steer(0.3 * i / 288);  // 0.15 rad/s
        scene.draw(1.0 / 144);
        const btTransform wheel = scene.car.vehicle->drawnWheel(0);
        const btVector3 axle = scene.shown().getBasis().transpose() * wheel.getBasis().getColumn(0);
        const double steer = std::atan2(-double(axle.z()), double(axle.x()));
        if (i > 20) worst = std::max(worst, std::abs(steer - last - 0.15 / 144));
        last = steer;
    }
    EXPECT_LT(worst, 0.15 / 144) << "rad; held over the steps it would jump by 0.15/60 at a time";
    EXPECT_GT(last, 0.29);
}

TEST(RaycastVehicleDrawing, WheelsThatAreNotThereAreAtTheChassis) {
    Drawn scene;
    scene.draw(0.1);
    EXPECT_EQ(scene.car.vehicle->drawnWheel(4), scene.car.vehicle->getChassisWorldTransform());
    EXPECT_EQ(scene.car.vehicle->drawnWheel(-1), scene.car.vehicle->getChassisWorldTransform());
}

}  // namespace
}  // namespace tread::raycast_drawing_test
