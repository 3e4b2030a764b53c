#include "tread/tyre_surroundings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/car_205_60R15.h"

namespace tread::tyre_surroundings_test {
namespace {

double corneringStiffness(const TyreParams& tyre, double load) {
    return steadyState(tyre, {.Fz = load, .gamma = 0, .Vx = 20, .Vsx = 0, .Vsy = 0}).Ky;
}

TEST(TyrePressure, AtTheNominalOneTheTyreIsAsMeasured) {
    const TyreParams tyre = reference::car205();
    const TyreParams same = inflated(tyre, {.radial_stiffness = 0.7, .cornering_stiffness = 0.5});
    EXPECT_EQ(same.lambda.Cz, tyre.lambda.Cz);
    EXPECT_EQ(same.lambda.Ky, tyre.lambda.Ky);
    EXPECT_EQ(same.parameters.pKy2, tyre.parameters.pKy2);
}

TEST(TyrePressure, ScalesStiffnessesLinearly) {
    const TyreParams tyre = reference::car205();
    const TyreParams soft = inflated(tyre, {.inflation = 176000,  // 20 % less
                                            .nominal = 220000,
                                            .radial_stiffness = 0.7,
                                            .slip_stiffness = 0.3,
                                            .cornering_stiffness = 0.5,
                                            .cornering_peak_load = 0});
    EXPECT_NEAR(soft.lambda.Cz, 1 - 0.14, 1e-12);
    const auto Kx = [](const TyreParams& t) { return steadyState(t, {.Fz = 4000, .Vx = 20}).Kx; };
    EXPECT_NEAR(Kx(soft) / Kx(tyre), 1 - 0.06, 1e-12);
    EXPECT_NEAR(corneringStiffness(soft, 4000) / corneringStiffness(tyre, 4000), 1 - 0.1, 1e-12);
}

TEST(TyrePressure, MovesTheLoadAtWhichTheCorneringStiffnessIsLargest) {
    // Equation (53) with both influences of the pressure, written out.
    const TyreParams tyre = reference::car205();
    const TyreCoefficients& p = tyre.parameters;
    const double change = -0.25;
    const TyreParams soft = inflated(
        tyre, {.inflation = 165000, .nominal = 220000, .cornering_stiffness = 0.5, .cornering_peak_load = 0.6});
    for (const double load : {1000.0, 4000.0, 9000.0}) {
        const double Ky =
            p.pKy1 * (1 + 0.5 * change) * p.Fzo * std::sin(2 * std::atan(load / (p.pKy2 * (1 + 0.6 * change) * p.Fzo)));
        EXPECT_NEAR(corneringStiffness(soft, load), Ky, 1e-9 * Ky) << load;
    }
    EXPECT_GT(corneringStiffness(soft, 500), corneringStiffness(tyre, 500)) << "light wheels gain";
    EXPECT_LT(corneringStiffness(soft, 9000), corneringStiffness(tyre, 9000)) << "heavy ones lose";
}

TEST(TyreTemperature, SettlesWhereCoolingEqualsTheSlipPower) {
    const TyreTemperatureParams p{
        .start = 300, .air = 290, .heat_capacity = 3000, .slip_share = 0.6, .cooling = 20, .cooling_by_speed = 1};
    double warming = 0;
    const double power = 5000, speed = -30, settled = 290 + 0.6 * 5000 / (20 + 30) - 300;
    const double time_constant = 3000 / 50.0, dt = 0.01;
    for (int k = 1; k <= 120000; ++k) {
        warming = advanceWarming(warming, p, power, speed, dt);
        if (k == 3000) {
            const double exact = settled * (1 - std::exp(-30 / time_constant));
            EXPECT_NEAR(warming, exact, 1e-4 * exact) << "on its way with the time constant of capacity over cooling";
        }
    }
    EXPECT_NEAR(warming, settled, 1e-3);
}

TEST(TyreTemperature, WithoutHeatCapacityItStays) {
    EXPECT_EQ(advanceWarming(3, {.heat_capacity = 0, .cooling = 100}, 1e4, 30, 0.1), 3);
    EXPECT_FALSE(warms({.heat_capacity = 0}));
    EXPECT_TRUE(warms({.start = 320, .heat_capacity = 0}));
    EXPECT_TRUE(warms({.heat_capacity = 1}));
}

TEST(TyreTemperature, FactorsArePolynomialsAboutTheNominalOne) {
    const TyreTemperatureParams p{
        .nominal = 330, .start = 300, .friction = 0.001, .friction_squared = -2e-5, .stiffness = -0.004};
    EXPECT_EQ(warmth(p, 30).friction, 1);
    EXPECT_EQ(warmth(p, 30).stiffness, 1);
    EXPECT_NEAR(warmth(p, 50).friction, 1 + 0.02 - 2e-5 * 400, 1e-12);
    EXPECT_NEAR(warmth(p, 0).stiffness, 1.12, 1e-12);
    EXPECT_GT(warmth(p, 1000).friction, 0) << "burnt, but not negative";
}

TEST(TyreShift, ConicityChangesSidesWithTheTyreAndPlySteerDoesNot) {
    const TyreSurroundingsParams p{.ply_steer = 0.002, .conicity = 0.01};
    const TyreShift left = shiftOf(p, true), right = shiftOf(p, false);
    EXPECT_EQ(left.slip, right.slip);
    EXPECT_EQ(left.camber, -right.camber);
    EXPECT_LT(left.camber, 0) << "the top outwards is to the left, on the left";
}

TEST(TyreShift, PlySteerTurnsRoundWithTheRollingDirectionAndConicityDoesNot) {
    // A symmetric tyre rolling straight on.
    TyreParams tyre = reference::car205();
    TyreCoefficients& p = tyre.parameters;
    for (double* odd : {&p.pHy1, &p.pHy2, &p.pVy1, &p.pVy2, &p.pEy3}) *odd = 0;
    const auto toLeft = [&](const TyreSurroundingsParams& s, double speed) {
        const TyreMotion m = shifted({.Vx = speed, .Fz = 4000}, shiftOf(s, true));
        return -steadyState(tyre, {.Fz = m.Fz, .gamma = m.gamma, .Vx = m.Vx, .Vsx = 0, .Vsy = m.Vsy}).Fy;
    };
    EXPECT_GT(toLeft({.ply_steer = 0.002}, 20), 50);
    EXPECT_NEAR(toLeft({.ply_steer = 0.002}, -20), -toLeft({.ply_steer = 0.002}, 20), 1e-6);
    EXPECT_GT(toLeft({.conicity = 0.01}, 20), 5);
    EXPECT_NEAR(toLeft({.conicity = 0.01}, -20), toLeft({.conicity = 0.01}, 20), 1e-6);
}

}  // namespace
}  // namespace tread::tyre_surroundings_test
