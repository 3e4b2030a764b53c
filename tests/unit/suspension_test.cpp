#include "tread/suspension.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::suspension_test {
namespace {

constexpr double kRounding = 1e-9;

SuspensionParams springAlone() {
    SuspensionParams p;
    p.spring = 20000;
    p.damper = {.bump = 0, .rebound = 0};
    return p;
}

double forceAt(const SuspensionParams& p, const SuspensionInput& input) {
    return forces(p, input).force;
}

TEST(Suspension, SpringCarriesStaticForceAtZeroTravelAndGrowsInCompression) {
    const SuspensionParams p = springAlone();
    EXPECT_NEAR(forceAt(p, {0, 0, 0, 3000}), 3000, kRounding);
    EXPECT_NEAR(forceAt(p, {0.05, 0, 0, 3000}), 4000, kRounding);
    EXPECT_NEAR(forceAt(p, {-0.05, 0, 0, 3000}), 2000, kRounding);
}

TEST(Suspension, SpringDoesNotPull) {
    const SuspensionForce hanging = forces(springAlone(), {-0.2, 0, 0, 3000});
    EXPECT_EQ(hanging.force, 0);
    EXPECT_EQ(hanging.by_travel, 0);
}

TEST(Suspension, DamperOpposesMotionDifferentlyInBumpAndRebound) {
    SuspensionParams p = springAlone();
    p.damper = {.bump = 1000, .rebound = 2000};
    EXPECT_NEAR(forceAt(p, {0, 0.5, 0, 3000}), 3500, kRounding) << "compression is resisted";
    EXPECT_NEAR(forceAt(p, {0, -0.5, 0, 3000}), 2000, kRounding) << "extension pulls the body down";
}

TEST(Suspension, DryFrictionOpposesMotionWithConstantForce) {
    SuspensionParams p = springAlone();
    p.damper.friction = 150;
    EXPECT_NEAR(forceAt(p, {0, 0.1, 0, 3000}), 3150, 1e-6);
    EXPECT_NEAR(forceAt(p, {0, -0.1, 0, 3000}), 2850, 1e-6);
    EXPECT_EQ(forceAt(p, {0, 0, 0, 3000}), 3000);
}

TEST(Suspension, AntiRollBarActsOnTheDifferenceAloneAndPushesBothWheelsOppositely) {
    SuspensionParams p = springAlone();
    p.anti_roll_bar = 10000;
    const double plain = 3000 + 20000 * 0.03;
    EXPECT_NEAR(forceAt(p, {0.03, 0, 0.03, 3000}), plain, kRounding) << "heave leaves it slack";
    EXPECT_NEAR(forceAt(p, {0.03, 0, 0.01, 3000}), plain + 200, kRounding);
    EXPECT_NEAR(forceAt(p, {0.01, 0, 0.03, 3000}), 3000 + 200 - 200, kRounding);
}

TEST(Suspension, StopsPushBackBeyondTheirClearance) {
    SuspensionParams p = springAlone();
    p.bump_stop = {.clearance = 0.05, .stiffness = 50000, .progression = 1e6};
    p.rebound_stop = {.clearance = 0.06, .stiffness = 80000, .progression = 0};
    EXPECT_NEAR(forceAt(p, {0.05, 0, 0, 3000}), 4000, kRounding) << "just met";
    EXPECT_NEAR(forceAt(p, {0.07, 0, 0, 3000}), 3000 + 1400 + 50000 * 0.02 + 1e6 * 0.0004, 1e-6);
    EXPECT_NEAR(forceAt(p, {-0.08, 0, 0, 3000}), 3000 - 1600 - 80000 * 0.02, 1e-6) << "pulls the body down";
}

TEST(Suspension, SlopesAreTheDerivativesOfTheForce) {
    SuspensionParams p = springAlone();
    p.damper = {.bump = 1000, .rebound = 2000, .friction = 100};
    p.anti_roll_bar = 10000;
    p.bump_stop = {.clearance = 0.05, .stiffness = 50000, .progression = 1e6};
    p.rebound_stop = {.clearance = 0.06, .stiffness = 80000, .progression = 2e6};
    constexpr double kSmall = 1e-7;
    for (const double travel : {-0.2, -0.09, -0.03, 0.02, 0.08}) {
        for (const double rate : {-0.4, -0.003, 0.002, 0.7}) {
            const SuspensionForce at = forces(p, {travel, rate, 0.01, 3000});
            const double by_travel =
                (forceAt(p, {travel + kSmall, rate, 0.01, 3000}) - forceAt(p, {travel - kSmall, rate, 0.01, 3000})) /
                (2 * kSmall);
            const double by_rate =
                (forceAt(p, {travel, rate + kSmall, 0.01, 3000}) - forceAt(p, {travel, rate - kSmall, 0.01, 3000})) /
                (2 * kSmall);
            EXPECT_NEAR(at.by_travel, by_travel, 1e-4 * by_travel + 1) << travel;
            EXPECT_NEAR(at.by_rate, by_rate, 1e-4 * by_rate + 1) << rate;
        }
    }
}

TEST(Suspension, AnglesMirrorEachOther) {
    SuspensionParams p = springAlone();
    p.camber = -0.01;
    p.camber_by_travel = -0.3;
    p.toe = 0.002;
    p.toe_by_travel = 0.05;
    const WheelAngles left = angles(p, 0.04, true), right = angles(p, 0.04, false);
    EXPECT_EQ(left.camber, -right.camber);
    EXPECT_EQ(left.toe, -right.toe);
}

TEST(Suspension, AnglesHaveTheSignsOfTheirDescription) {
    SuspensionParams p = springAlone();
    p.camber = 0.01;
    EXPECT_LT(angles(p, 0, true).camber, 0) << "outwards on the left: the top goes to the left";
    EXPECT_GT(angles(p, 0, false).camber, 0);
    p.toe = 0.01;
    EXPECT_LT(angles(p, 0, true).toe, 0) << "toe-in on the left: the wheel points to the right";
    EXPECT_GT(angles(p, 0, false).toe, 0);
    p = springAlone();
    p.camber_by_travel = -0.2;
    p.toe_by_travel = -0.1;
    EXPECT_NEAR(angles(p, 0.05, false).camber, -0.01, kRounding) << "compression leans the top inwards";
    EXPECT_NEAR(angles(p, 0.05, false).toe, -0.005, kRounding) << "compression toes the wheel out";
}

TEST(Suspension, CurvesTakeThePlaceOfNumbersAndGoOnWithTheirSlopes) {
    SuspensionParams p = springAlone();
    p.damper = {.bump = 1000, .rebound = 2000};
    SuspensionParams curved = p;
    curved.spring_curve = {{{-0.1, -2000}, {0, 0}, {0.1, 2000}}};
    curved.damper.bump_curve = {{{0, 0}, {0.2, 200}, {0.3, 300}}};
    curved.damper.rebound_curve = {{{0, 0}, {0.2, 400}}};
    for (const double travel : {-0.14, -0.05, 0.0, 0.03, 0.15}) {
        for (const double rate : {-0.5, -0.1, 0.0, 0.15, 0.9}) {
            const SuspensionForce a = forces(p, {travel, rate, 0, 3000}), b = forces(curved, {travel, rate, 0, 3000});
            EXPECT_NEAR(a.force, b.force, 1e-9) << "a straight curve is a number";
            EXPECT_NEAR(a.by_travel, b.by_travel, 1e-6);
            EXPECT_NEAR(a.by_rate, b.by_rate, 1e-6);
        }
    }
    curved.spring_curve = {{{-0.1, -1500}, {0, 0}, {0.05, 1000}, {0.1, 3000}}};
    EXPECT_NEAR(forceAt(curved, {0.075, 0, 0, 3000}), 5000, kRounding);
    EXPECT_NEAR(forces(curved, {0.2, 0, 0, 3000}).by_travel, 40000, 1e-6) << "progressive";
    EXPECT_NEAR(forceAt(curved, {0.2, 0, 0, 3000}), 3000 + 3000 + 40000 * 0.1, 1e-9);
}

TEST(Suspension, ComplianceHasTheSignsOfItsDescription) {
    SuspensionParams p = springAlone();
    p.steer_by_lateral_force = -1e-6;
    p.steer_by_longitudinal_force = 2e-6;
    p.camber_by_lateral_force = 3e-6;
    const WheelAngles left = compliance(p, 1000, 500, true), right = compliance(p, 1000, 500, false);
    EXPECT_NEAR(left.toe, -0.0005 - 0.002, 1e-15) << "driving toes in: the left wheel to the right";
    EXPECT_NEAR(right.toe, -0.0005 + 0.002, 1e-15);
    EXPECT_NEAR(left.camber, 0.0015, 1e-15) << "a force to the left leans the top to the right, on both sides";
    EXPECT_EQ(left.camber, right.camber);
}

// ---- Recession ----

constexpr double kWheelMass = 40;  // kg

SuspensionParams soft(double damping) {
    SuspensionParams p = springAlone();
    p.longitudinal_compliance = 2e-6;
    p.longitudinal_damping = damping;
    return p;
}

TEST(Recession, SwingsWithTheMassOfTheWheelOnTheBush) {
    const SuspensionParams p = soft(500);
    const double stiffness = 1 / 2e-6, decay = 500 / (2 * kWheelMass);
    const double frequency = std::sqrt(stiffness / kWheelMass - decay * decay);
    const double dt = 0.0005, rest = 1000 / stiffness;
    Recession r;
    r.push = 1000 / kWheelMass;
    for (int k = 1; k <= 400; ++k) {
        advance(r, p, kWheelMass, dt);
        takePush(r, p, kWheelMass, 1000 / kWheelMass, dt);
        const double t = k * dt;
        const double exact =
            rest * (1 - std::exp(-decay * t) * (std::cos(frequency * t) + decay / frequency * std::sin(frequency * t)));
        EXPECT_NEAR(r.travel, exact, 0.01 * rest) << t;
    }
}

TEST(Recession, ComesToRestWhereForceAndFrameBalanceTheBush) {
    const SuspensionParams p = soft(8000);
    Recession r;
    for (int k = 0; k < 2000; ++k) {
        advance(r, p, kWheelMass, 0.001);
        takePush(r, p, kWheelMass, -3000 / kWheelMass + 6, 0.001);
    }
    EXPECT_NEAR(r.travel, 2e-6 * (-3000 + kWheelMass * 6), 1e-12);
    EXPECT_NEAR(r.rate, 0, 1e-12);
}

TEST(Recession, AHardBushDoesNotRing) {
    SuspensionParams p = soft(0);
    for (const double compliance : {1e-9, 1e-10, 1e-12}) {
        p.longitudinal_compliance = compliance;
        Recession r;
        for (int k = 0; k < 100; ++k) {
            advance(r, p, kWheelMass, 0.001);
            takePush(r, p, kWheelMass, (k < 10 ? 1000 : 2000) / kWheelMass, 0.001);
            ASSERT_LT(std::abs(r.travel), 2 * 2000 * compliance);
        }
        EXPECT_NEAR(r.travel, 2000 * compliance, 20 * compliance);
        EXPECT_NEAR(r.rate, 0, 1e-4);
    }
}

}  // namespace
}  // namespace tread::suspension_test
