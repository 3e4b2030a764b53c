// A body on wheels of its own, without a game around it: what its struts, tyres and spinning wheels do to it.

#include "vehicle/wheeled_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "vehicle/strut.h"
#include "vehicle/tyre_load.h"

namespace tread::wheeled_body_test {
namespace {

constexpr double kMass = 1000;  // kg
constexpr double kRadius = 0.3;

// z up, x forward; four wheels 1 m before and behind, 0.7 m beside the centre of gravity.
WheeledBody bodyOn(const StrutParams& strut, const TyreParams& tyre) {
    WheeledBody body;
    body.mass = kMass;
    body.inverse_inertia = {1.0 / 400, 1.0 / 1200, 1.0 / 1400};
    body.wheel_count = 4;
    for (std::size_t i = 0; i < 4; ++i) {
        BodyWheel& wheel = body.wheels[i];
        wheel.top_B = {i < 2 ? 1.0 : -1.0, i % 2 == 0 ? 0.7 : -0.7, 0};
        wheel.strut = strut;
        wheel.tyre = tyre;
    }
    prepareTyres(body);
    return body;
}

TyreParams tyre() {
    return similarTyre(0.25 * kMass * kStandardGravity, kRadius);
}

struct Scene {
    WheeledBody body;
    ChassisMotion motion;
    WheeledBodyState state;
    std::vector<WheelDemand> demands = std::vector<WheelDemand>(4);
    std::vector<RoadContact> ground = std::vector<RoadContact>(4);

    void step(double dt) { advance(motion, state, body, demands, demands, ground, {0, 0, -kStandardGravity}, dt); }
};

// Spring and tyre with damping in proportion are one spring and damper: a body on them sinks as on these alone.
TEST(WheeledBody, StrutAndTyreInProportionAreOneSpringAndDamper) {
    constexpr double kSpring = 30e3, kDamper = 2500, kStep = 1e-4;
    for (double share : {0.1, 0.4}) {  // of the way, the tyre's
        TyreParams soft = tyre();
        soft.parameters.pz1 = kSpring / share;
        soft.parameters.pz2 = 0;
        StrutParams strut;
        strut.stiffness = kSpring / (1 - share);
        strut.bump = strut.rebound = kDamper / (1 - share);
        strut.tyre_bump = strut.tyre_rebound = kDamper / share;
        Scene scene{.body = bodyOn(strut, soft), .motion = {}, .state = {}};
        scene.motion.position_W = {0, 0, strut.length + kRadius};
        scene.motion.velocity_W = {0, 0, -1};

        double height = strut.length + kRadius, speed = -1;
        for (int i = 0; i < 10000; ++i) {
            scene.step(kStep);
            const double force = 4 * (kSpring * (strut.length + kRadius - height) - kDamper * speed);
            speed += kStep * (force / kMass - kStandardGravity);
            height += kStep * speed;
            ASSERT_NEAR(scene.motion.position_W.z(), height, 2e-4) << i;
            const BodyWheelState& wheel = scene.state.wheels[0];
            ASSERT_NEAR(wheel.deflection, share * (wheel.deflection + wheel.compression), 1e-4) << i;
        }
    }
}

Scene inTheAir(bool reaction) {
    Scene scene{.body = bodyOn({}, tyre()), .motion = {}, .state = {}};
    scene.body.wheel_reaction = reaction;
    scene.motion.position_W = {0, 0, 100};
    for (RoadContact& below : scene.ground) below.exists = false;
    for (WheelDemand& demand : scene.demands) demand.drive_torque = 200;
    return scene;
}

// With it, what the wheels gain of angular momentum the body loses; without, it knows nothing of them.
TEST(WheeledBody, SpinningWheelsTurnItOnlyWithTheirReaction) {
    for (bool reaction : {false, true}) {
        Scene scene = inTheAir(reaction);
        for (int i = 0; i < 500; ++i) scene.step(1e-3);
        double wheels = 0;
        for (std::size_t i = 0; i < 4; ++i) wheels += scene.body.wheels[i].inertia * scene.state.wheels[i].spin;
        EXPECT_GT(wheels, 100);
        const double pitch = scene.motion.angular_velocity_W.y();
        EXPECT_NEAR(1200 * pitch, reaction ? -wheels : 0, 0.01 * wheels);
    }
}

TEST(WheeledBody, SpinningWheelsResistBeingTurnedOnlyWithTheirReaction) {
    for (bool reaction : {false, true}) {
        Scene scene = inTheAir(reaction);
        for (WheelDemand& demand : scene.demands) demand.drive_torque = 0;
        for (std::size_t i = 0; i < 4; ++i) scene.state.wheels[i].spin = 100;
        scene.motion.angular_velocity_W = {0, 0, 0.1};
        scene.step(1e-3);
        // About z turned, an axle along y answers about x: -w x h, of which a step counts half.
        const double couple = 0.1 * 4 * scene.body.wheels[0].inertia * 100;
        EXPECT_NEAR(400 * scene.motion.angular_velocity_W.x(), reaction ? 0.5e-3 * couple : 0, 0.01e-3 * couple);
    }
}

// Of a wheel without ground the tyre remembers the slip of the car's way: none, however fast the car falls.
TEST(WheeledBody, FallingIsNoSlip) {
    Scene scene = inTheAir(false);
    for (WheelDemand& demand : scene.demands) demand.drive_torque = 0;
    scene.motion.velocity_W = {0, 0, -10};
    for (int i = 0; i < 100; ++i) scene.step(1e-3);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(scene.state.wheels[i].motion.Vx, 0, 1e-9);
        EXPECT_NEAR(scene.state.wheels[i].tyre.kappa, 0, 1e-9);
    }
}

// However strong the drive and however long the step, a rim in the air does not run past its limit.
TEST(WheeledBody, DriveLimitHoldsWithinAStep) {
    for (double torque : {100.0, 1e3, 1e6}) {
        for (double dt : {1e-3, 1.0 / 60, 1.0 / 30}) {
            Scene scene = inTheAir(false);
            for (std::size_t i = 0; i < 4; ++i) {
                scene.demands[i].drive_torque = i % 2 == 0 ? torque : -torque;
                scene.demands[i].limit = {.loss = 0, .fades = 6, .ends = 8};
            }
            for (int i = 0; i < 3 / dt; ++i) {
                scene.step(dt);
                for (std::size_t k = 0; k < 4; ++k)
                    ASSERT_LT(std::abs(scene.state.wheels[k].spin) * 0.976 * kRadius, 8 + 1e-6);
            }
            EXPECT_GT(scene.state.wheels[0].spin * 0.976 * kRadius, 6);
            EXPECT_LT(scene.state.wheels[1].spin * 0.976 * kRadius, -6);
        }
    }
}

// A motor's loss: in the air the rim ends where the loss has eaten the force.
TEST(WheeledBody, DriveLossEndsWhereItHasEatenTheForce) {
    Scene scene = inTheAir(false);
    for (std::size_t i = 0; i < 4; ++i) scene.demands[i].limit = {.loss = 100};
    for (int i = 0; i < 200; ++i) scene.step(1.0 / 60);
    EXPECT_NEAR(scene.state.wheels[0].spin * 0.976 * kRadius, 200 / kRadius / 100, 1e-3);
}

}  // namespace
}  // namespace tread::wheeled_body_test
