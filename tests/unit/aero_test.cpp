#include "tread/aero.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::aero_test {
namespace {

constexpr double kRounding = 1e-9;

AeroParams params() {
    return {.air_density = 1.2, .drag_area = 0.6, .front_lift_area = 0.1, .rear_lift_area = -0.2, .height = 0.5};
}

TEST(Aero, DragIsHalfDensityTimesAreaTimesSpeedSquaredAgainstTheMotion) {
    const AeroForces forward = forces(params(), {30, 0, 0});
    EXPECT_NEAR(forward.drag_B.x(), -0.5 * 1.2 * 0.6 * 900, kRounding);
    EXPECT_EQ(forward.drag_B.y(), 0);
    const Vector3 oblique(30, -4, 1);
    const AeroForces sideways = forces(params(), oblique);
    EXPECT_NEAR(sideways.drag_B.norm(), 0.5 * 1.2 * 0.6 * oblique.squaredNorm(), kRounding);
    EXPECT_NEAR(sideways.drag_B.normalized().dot(oblique.normalized()), -1, kRounding);
}

TEST(Aero, DragHoldsACarBackThatRollsBackwards) {
    EXPECT_GT(forces(params(), {-10, 0, 0}).drag_B.x(), 0);
}

TEST(Aero, LiftOfEachAxleGrowsWithForwardSpeedSquared) {
    const AeroForces at = forces(params(), {20, 5, 0});
    EXPECT_NEAR(at.front_lift, 0.5 * 1.2 * 0.1 * 400, kRounding);
    EXPECT_NEAR(at.rear_lift, -0.5 * 1.2 * 0.2 * 400, kRounding) << "negative presses the axle down";
}

TEST(Aero, NothingWithoutAreasOrWithoutAir) {
    const AeroForces none = forces({}, {40, 3, 1});
    EXPECT_EQ(none.drag_B, Vector3::Zero());
    EXPECT_EQ(none.front_lift, 0);
    AeroParams vacuum = params();
    vacuum.air_density = 0;
    EXPECT_EQ(forces(vacuum, {40, 3, 1}).drag_B.norm(), 0);
    EXPECT_EQ(forces(params(), Vector3::Zero()).drag_B.norm(), 0);
}

// ---- Sideslip ----

AeroParams withSide() {
    AeroParams p = params();
    p.side_force_area = {{{0, 0}, {0.5, 1.0}, {1.5, 1.8}}};
    p.yaw_moment_volume = {{{0, 0}, {0.5, 0.7}}};
    p.roll_moment_volume = {{{0, 0}, {0.5, 0.2}}};
    return p;
}

TEST(Aero, SideForceAndMomentsFollowTheirCurvesOverSideslip) {
    const double angle = 0.25, speed = 40;
    const double pressure = 0.5 * 1.2 * speed * speed;
    const AeroForces air = forces(withSide(), {speed * std::cos(angle), speed * std::sin(angle), 0});
    EXPECT_NEAR(air.side_force, -pressure * 0.5, 1e-9) << "moving to the left, pushed to the right";
    EXPECT_NEAR(air.yaw_moment, -pressure * 0.35, 1e-9) << "the nose turns away from the wind";
    EXPECT_NEAR(air.roll_moment, pressure * 0.1, 1e-9) << "the roof leans away from the wind";
}

TEST(Aero, SideslipToTheOtherSideIsTheMirrorImage) {
    const AeroForces left = forces(withSide(), {30, 9, 0}), right = forces(withSide(), {30, -9, 0});
    EXPECT_EQ(left.side_force, -right.side_force);
    EXPECT_EQ(left.yaw_moment, -right.yaw_moment);
    EXPECT_EQ(left.roll_moment, -right.roll_moment);
    EXPECT_EQ(left.drag_B.x(), right.drag_B.x());
    EXPECT_EQ(forces(withSide(), {30, 0, 0}).side_force, 0);
}

}  // namespace
}  // namespace tread::aero_test
