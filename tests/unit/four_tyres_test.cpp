// Four tyres together against each alone: the same bits.

#include "tyre/four_tyres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "shared/car_205_60R15.h"

namespace tread::four_tyres_test {
namespace {

bool sameBits(const auto& a, const auto& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Four different tyres.
PerWheel<TyreParams> tyres() {
    PerWheel<TyreParams> all;
    for (std::size_t i = 0; i < kWheels; ++i) {
        all[i] = reference::car205();
        TyreCoefficients& p = all[i].parameters;
        p.pDy1 *= 1 - 0.1 * static_cast<double>(i);
        p.mt = 9;
        p.czgyr = p.cygyr = p.cpsigyr = 0.5;
    }
    all[1] = mirrored(all[1]);
    return all;
}

// Wheels that roll, brake to a stop, lock and stand, on roads of different friction.
TEST(FourTyres, GetTheBitsThatEachGetsAlone) {
    const PerWheel<TyreParams> each = tyres();
    const FourTyres four = together(each);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double dt = 0.001;
    int compared = 0;
    for (int drive = 0; drive < 60; ++drive) {
        PerWheel<TyreState> states, states_alone;
        PerWheel<double> Omega, Omega_alone;
        PerWheel<TyreMotion> begin, rate;
        PerWheel<TyreSpin> spins;
        PerWheel<TyreFactors> factors;
        for (std::size_t i = 0; i < kWheels; ++i) {
            const double speed = drive % 3 == 0 ? 2 * std::abs(unit(random)) : 40 * unit(random);
            begin[i] = {
                0, 3 * unit(random), speed, 0, 0.5 * unit(random), 0.05 * unit(random), 4000 + 4000 * unit(random)};
            rate[i] = {
                0, 20 * unit(random), -8 * unit(random), 0, 2 * unit(random), 0.3 * unit(random), 20000 * unit(random)};
            spins[i] = {1.2, 0.3, 400 * unit(random), drive % 2 == 0 ? 0 : 1500 * std::abs(unit(random))};
            factors[i] = {i == 2 ? 0.4 : 1, i == 1 ? 0.8 : 1};
            Omega[i] = speed / each[i].parameters.Re;
        }
        Omega_alone = Omega;
        for (int k = 0; k < 200; ++k) {
            PerWheel<TyreMotion> end = begin;
            for (std::size_t i = 0; i < kWheels; ++i) {
                end[i].Vsy += dt * rate[i].Vsy;
                end[i].Vx += dt * rate[i].Vx;
                end[i].psidot += dt * rate[i].psidot;
                end[i].gamma += dt * rate[i].gamma;
                end[i].Fz += dt * rate[i].Fz;
            }
            const PerWheel<TyreForces> forces = advance(states, Omega, four, factors, begin, end, spins, dt);
            for (std::size_t i = 0; i < kWheels; ++i) {
                TyreParams tyre = each[i];
                tyre.lambda.mux *= factors[i].friction;
                tyre.lambda.muy *= factors[i].friction;
                tyre.lambda.Kx *= factors[i].stiffness;
                tyre.lambda.Ky *= factors[i].stiffness;
                const TyreForces alone =
                    advance(states_alone[i], Omega_alone[i], tyre, begin[i], end[i], spins[i], dt, Standstill::hold);
                ASSERT_TRUE(std::isfinite(alone.Fx + alone.Fy + alone.Mz));
                ASSERT_TRUE(sameBits(forces[i], alone)) << "drive " << drive << " step " << k << " wheel " << i;
                ASSERT_TRUE(sameBits(states[i], states_alone[i]));
                ASSERT_TRUE(sameBits(Omega[i], Omega_alone[i]));
                ++compared;
            }
            begin = end;
        }
    }
    EXPECT_EQ(compared, 60 * 200 * 4);
}

TEST(FourTyres, OneThatIsNotANumberLeavesTheOthersAlone) {
    const PerWheel<TyreParams> each = tyres();
    PerWheel<TyreState> states;
    PerWheel<double> Omega{60, 60, 60, 60};
    PerWheel<TyreMotion> motion;
    PerWheel<TyreSpin> spins;
    for (std::size_t i = 0; i < kWheels; ++i) {
        motion[i] = {0, 0.5, 20, 0, 0, 0, 4000};
        spins[i] = {1.2, 0.3, 0, 0};
    }
    motion[3].Vsy = std::nan("");
    const PerWheel<TyreForces> forces = advance(states, Omega, together(each), {}, motion, motion, spins, 0.001);
    EXPECT_TRUE(std::isfinite(forces[0].Fy + forces[1].Fy + forces[2].Fy));
    EXPECT_TRUE(std::isnan(forces[3].Fy));
}

}  // namespace
}  // namespace tread::four_tyres_test
