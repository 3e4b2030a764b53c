// The whole car (vehicle.h) and a game's body on struts (wheeled_body.h) hold their wheels in different ways; a wheel
// that is held alike meets the road alike.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <span>

#include "places/places.h"
#include "shared/car_205_60R15.h"
#include "shared/vehicles.h"
#include "vehicle/body.h"
#include "vehicle/tyre_grip.h"
#include "vehicle/wheel.h"
#include "vehicle/wheeled_body.h"

namespace tread::two_cars_test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kStep = 1e-5;  // s: the strut's rate is that over the step, the hub's velocity that at its beginning

class Random {
public:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    Vector3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

private:
    std::mt19937 engine_{17};
};

// A plane under everything.
struct Plane final : Road {
    RoadContact ground;
    RoadContact contact(const Vector3&, std::size_t) const override { return ground; }
};

// A wheel with its camber, on a body in some pose over some plane, as both cars describe it.
struct Scene {
    ChassisMotion motion;
    Plane road;
    Vehicle::Corner corner{};
    WheeledBody body;
    double camber;
    WheelDemand begin, end;
};

Scene sceneOf(Random& random) {
    Scene s;
    const Vector3 lean = random.vector(0.25);
    s.motion.orientation = Eigen::AngleAxisd(random.between(-3, 3), Vector3::UnitZ()) *
                           Eigen::AngleAxisd(lean.x(), Vector3::UnitX()) *
                           Eigen::AngleAxisd(lean.y(), Vector3::UnitY());
    s.motion.position_W = random.vector(100);
    s.motion.velocity_W = random.vector(20);
    s.motion.velocity_W.z() = random.between(-1, 1);
    s.motion.angular_velocity_W = random.vector(1);

    TyreParams tyre = reference::car205();
    tyre.lambda.Cz = random.between(0.7, 1.3);
    tyre.lambda.Kz = random.between(0, 3);
    const Vector3 hub_B(random.between(-2, 2), random.between(-1, 1), random.between(-0.4, -0.1));
    s.corner.hub_B = hub_B;
    s.corner.tyre = tyre;
    s.camber = random.between(-0.1, 0.1);

    // A strut so hard that the tyre gives way, held as the suspension holds the wheel.
    BodyWheel wheel;
    wheel.strut = {.length = 0.3, .stiffness = 1e7, .bump = 0, .rebound = 0, .travel = 1};
    wheel.top_B = hub_B + Vector3(0, 0, wheel.strut.length);
    wheel.left_B = {0, std::cos(s.camber), std::sin(s.camber)};
    wheel.tyre = tyre;
    s.body.mass = 1000;
    s.body.wheel_count = 1;
    s.body.wheels[0] = wheel;
    prepareTyres(s.body);

    // From just out of reach to well pressed in.
    const double radius = tyre.parameters.Ro * random.between(0.7, 1.02);
    const Vector3 n = (Vector3::UnitZ() + random.vector(0.25)).normalized();
    const Vector3 hub_W = s.motion.position_W + s.motion.orientation * hub_B;
    s.road.ground = {.point_W = hub_W - radius * n, .normal_W = n};
    s.road.ground.friction = random.between(0.2, 1.2);
    s.road.ground.velocity_W = random.vector(3);
    s.begin.steer = random.between(-0.5, 0.5);
    s.end = s.begin;
    s.end.steer += kStep * random.between(-2, 2);
    return s;
}

TEST(TwoCars, MeetTheRoadAlike) {
    Random random;
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE(i);
        const Scene s = sceneOf(random);
        ChassisMotion game_motion = s.motion;
        WheeledBodyState state;
        state.wheels[0].compression = random.between(0, 1e-3);
        advance(game_motion, state, s.body, std::span(&s.begin, 1), std::span(&s.end, 1), std::span(&s.road.ground, 1),
                Vector3::Zero(), kStep);
        const BodyWheelState& game = state.wheels[0];

        // The car's wheel where the strut has brought the game's.
        const VehicleState none;
        const BodyFrame body = bodyFrame(predicted(s.motion, {}, {}, kStep), none, Vector3::Zero());
        const WheelPose pose{.displacement_B = {0, 0, game.compression}, .camber = s.camber, .steer = s.end.steer};
        const WheelContact contact = wheelContact(body, s.corner, pose, s.road, 0);
        const double load = tyreLoad(s.corner, contact, body, game.strut_rate).load;
        const TyreMotion motion =
            tyreMotion(contact, body, Vector3(0, 0, 0), 0.0, (s.end.steer - s.begin.steer) / kStep,
                       grippingLoad(s.corner.tyre, game.load));

        const auto& [x, y, z] = game.contact_B;
        EXPECT_LT((contact.point_B - Vector3(x, y, z)).norm(), kRounding);
        EXPECT_NEAR(contact.camber, game.camber, kRounding);
        EXPECT_NEAR(std::max(s.corner.tyre.parameters.Ro - contact.radius, 0.0), game.deflection, kRounding);
        EXPECT_NEAR(motion.Vx, game.motion.Vx, 100 * kRounding);
        EXPECT_NEAR(motion.Vsy, game.motion.Vsy, 100 * kRounding);
        EXPECT_NEAR(motion.psidot, game.motion.psidot, 100 * kRounding);
        EXPECT_NEAR(motion.gamma, game.camber, kRounding);
        EXPECT_EQ(motion.Fz, game.motion.Fz);
        EXPECT_NEAR(load, game.load, 1e-5 * s.corner.tyre.parameters.Fzo) << "steps of " << kStep << " s apart";
        touching += game.touches;
    }
    EXPECT_GT(touching, 1000);
}

// A tyre that is pressed flat stands on its rim, and beyond four times its nominal load it grips no more.
TEST(TwoCars, StandOnTheirRims) {
    const TyreParams tyre = reference::car205();
    const double Ro = tyre.parameters.Ro, deflection = 0.6 * Ro;
    const double spring = radialStiffness(tyre) * deflection;
    Vehicle::Corner corner{};
    corner.tyre = tyre;
    Plane road;
    road.ground = {.point_W = {0, 0, deflection - Ro}};
    const BodyFrame body = bodyFrame({}, {}, Vector3::Zero());
    const WheelContact contact = wheelContact(body, corner, {Vector3::Zero(), 0, 0}, road, 0);
    const double car = tyreLoad(corner, contact, body, 0.0).load;
    EXPECT_GT(car, 2 * spring);
    EXPECT_EQ(grippingLoad(tyre, car), 4 * tyre.parameters.Fzo);

    WheeledBody game;
    game.wheel_count = 1;
    game.wheels[0].tyre = tyre;
    game.wheels[0].strut = {.length = 0, .stiffness = 1e12};
    prepareTyres(game);
    WheeledBodyState state;
    ChassisMotion motion;
    const WheelDemand idle;
    advance(motion, state, game, std::span(&idle, 1), std::span(&idle, 1), std::span(&road.ground, 1), Vector3::Zero(),
            kStep);
    EXPECT_NEAR(state.wheels[0].load, car, 1e-4 * car);
    EXPECT_EQ(state.wheels[0].motion.Fz, 4 * tyre.parameters.Fzo);
}

// ---- Grip ----

// The weightings of combined slip (71), (76) are shifted: their tops lie beside zero slip, so much above 1 with the
// rHx1 and rHy1 of these tyres.
constexpr double kWeighting = 0.003;

TEST(Grip, NoForceAlongOrAcrossIsLargerInAnySteadyState) {
    Random random;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile("vehicles/tyres"))) {
        if (entry.path().extension() != ".yaml") continue;
        const TyreParams tyre = loadTyre(entry.path());
        double component = 0, together = 0;
        for (int i = 0; i < 20000; ++i) {
            const double Vx = 20;
            TyreMotion motion;
            motion.Fz = tyre.parameters.Fzo * random.between(0.05, 2);
            motion.gamma = random.between(-0.08, 0.08);
            const double Vsx = -Vx * std::pow(random.between(-1, 1), 3), Vsy = Vx * std::pow(random.between(-1, 1), 3);
            const TyreSteadyState steady = steadyState(tyre, {motion.Fz, motion.gamma, Vx, Vsx, Vsy});
            const double grip = gripOf(tyre, motion, 1);
            component = std::max({component, std::abs(steady.Fx) / grip, std::abs(steady.Fy) / grip});
            together = std::max(together, std::hypot(steady.Fx, steady.Fy) / grip);
        }
        std::printf("%s: at most %.3f of the grip along or across, %.3f in all\n", tyre.name.c_str(), component,
                    together);
        EXPECT_LE(component, 1 + kWeighting) << entry.path();
        EXPECT_GE(component, 0.95) << entry.path();
    }
}

// A road that ends for all wheels at once: for a wheel with mass the worst that can happen to its load.
struct EndingRoad final : Road {
    bool ends = false;
    RoadContact contact(const Vector3&, std::size_t) const override { return {.exists = !ends}; }
};

TEST(Grip, WhatACarcassStoresIsGoneSoonAfterTheLoad) {
    EndingRoad road;
    reference::Car car = reference::settled(reference::compact(), road, {.speed = 25});
    VehicleInput input = car.input;
    input.steering_wheel_angle = 1;
    for (int k = 0; k < 1000; ++k) car.step(input, 0.001);
    const double before = std::abs(car.state.wheels[0].fy);
    ASSERT_GT(before, 1000);
    road.ends = true;
    double impulse = 0;  // N s
    for (int k = 0; k < 30; ++k) {
        car.step(input, 0.001);
        impulse += 0.001 * car.state.wheels[0].fy;
    }
    std::printf("fy %.0f N before, %.2f N 30 ms after, %.2f N s between\n", before, car.state.wheels[0].fy, impulse);
    EXPECT_LT(std::abs(car.state.wheels[0].fy), 0.05 * before);
    EXPECT_LT(std::abs(impulse), 0.005 * before) << "as a force of 5 ms at most";
}

}  // namespace
}  // namespace tread::two_cars_test
