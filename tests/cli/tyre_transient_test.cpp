// `tread tyre --transient` through the real program, and the forces of a known state that it asks the library for.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "cli/program.h"
#include "cli/tyre_table.h"
#include "shared/near.h"
#include "shared/transient_reference.h"
#include "tread/tyre.h"

namespace tread::tyre_transient_test {
namespace {

using reference::near;

const std::vector<std::string> kMotionColumns{"t", "Vsx", "Vsy", "Vx", "Omega", "psidot", "gamma", "Fz"};
const std::vector<std::string> kPatchColumns{"u", "v", "du", "dv", "Fx", "Fy", "Mx", "My", "Mz"};

TyreTable motionTable(const reference::Case& c) {
    TyreTable table{kMotionColumns, {}};
    for (const reference::Sample& s : c.samples) {
        table.rows.push_back({double(s.t), double(s.Vsx), double(s.Vsy), double(s.Vx), double(s.Omega),
                              double(s.psidot), double(s.gamma), double(s.Fz)});
    }
    return table;
}

TyreTable transientTable(const TyreTable& motion, const std::vector<std::string>& more) {
    return programTable("--transient", motion, more);
}

reference::Case caseNamed(const std::string& name) {
    for (const reference::Case& c : reference::transientCases()) {
        if (c.name == name) return c;
    }
    throw std::runtime_error("no case " + name);
}

// Every row is consistent in itself: the reference's state at that time under the motion of that row.
std::vector<std::array<long double, 9>> expectedRows(const TyreParams& tyre, const reference::Case& c) {
    std::vector<std::array<long double, 9>> rows;
    const reference::Trajectory trajectory = reference::integrate(tyre, c);
    for (std::size_t i = 0; i < c.samples.size(); ++i) {
        reference::Patch patch;
        patch.deflection << trajectory[i].u, trajectory[i].v;
        patch.rate << trajectory[i].du, trajectory[i].dv;
        const reference::Point p = reference::wheelForces(tyre, c.samples[i], patch);
        rows.push_back({p.u, p.v, p.du, p.dv, p.Fx, p.Fy, p.Mx, p.My, p.Mz});
    }
    return rows;
}

constexpr double kTransientTolerance = 0.005;  // of the peak of each column

void expectTransient(const std::string& name, int substeps) {
    const reference::Case c = caseNamed(name);
    const bool linear = c.between == reference::Between::linear;
    const TyreTable out = transientTable(
        motionTable(c),
        {"--axes", "paper", "--interpolate", linear ? "linear" : "hold", "--substeps", std::to_string(substeps)});
    const auto expected = expectedRows(tyreWithCouples(), c);
    ASSERT_EQ(out.rows.size(), expected.size());
    std::printf("%s:", name.c_str());
    for (std::size_t k = 0; k < kPatchColumns.size(); ++k) {
        long double peak = 0, worst = 0;
        for (const auto& row : expected) peak = std::max(peak, std::abs(row[k]));
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const long double value = out.at(i, kPatchColumns[k]);
            worst = std::max(worst, std::abs(value - expected[i][k]));
            EXPECT_TRUE(near(value, expected[i][k], kTransientTolerance * peak)) << kPatchColumns[k] << " of row " << i;
        }
        std::printf(" %s %.3f %%", kPatchColumns[k].c_str(), double(peak > 0 ? 100 * worst / peak : 0));
    }
    std::printf("\n");
}

TEST(TyreTransient, FollowsTheReferenceAfterAStepOfSlipAngle) {
    expectTransient("alpha 0.02 at 10 m/s", 1);
}
TEST(TyreTransient, FollowsTheReferenceAfterAStepOfBothSlips) {
    expectTransient("alpha 0.08 and kappa -0.08 at 25 m/s", 1);
}
TEST(TyreTransient, FollowsTheReferenceWhileBrakedToLock) {
    expectTransient("braked to lock in 0.1 s from 30 m/s", 1);
}
TEST(TyreTransient, FollowsTheReferenceWhenTheWheelLiftsOff) {
    expectTransient("load with lift-off, alpha 0.05", 1);
}

// The patch swings at 60 to 110 Hz after these jumps: its velocity alone asks for more than a step per millisecond.
TEST(TyreTransient, FollowsTheReferenceAfterAStepOfCamber) {
    expectTransient("camber 0.05 at 20 m/s", 4);
}
TEST(TyreTransient, FollowsTheReferenceAfterAStepOfYawRate) {
    expectTransient("yaw rate 0.5 rad/s at 30 m/s", 4);
}

TEST(TyreTransient, IsoAndPaperAreTheSamePhysics) {
    TyreTable motion = motionTable(caseNamed("yaw rate 0.5 rad/s at 30 m/s"));
    for (std::size_t row = 0; row < motion.rows.size(); ++row)
        motion.at(row, "Vsy") = 0.4 * std::sin(0.1 * double(row));
    const TyreTable paper = transientTable(motion, {"--axes", "paper"});
    for (std::size_t row = 0; row < motion.rows.size(); ++row) {
        motion.at(row, "Vsy") *= -1;
        motion.at(row, "psidot") *= -1;
    }
    const TyreTable iso = transientTable(motion, {"--axes", "iso"});
    const std::vector<std::string> turned{"v", "dv", "Fy", "My", "Mz"};
    for (std::size_t row = 0; row < motion.rows.size(); ++row) {
        for (const std::string& column : kPatchColumns) {
            const double sign = std::find(turned.begin(), turned.end(), column) != turned.end() ? -1 : 1;
            EXPECT_EQ(iso.at(row, column), sign * paper.at(row, column)) << column << " of row " << row;
        }
    }
}

TEST(TyreTransient, StartsUndeflectedAndAtRest) {
    const TyreTable out = transientTable(motionTable(caseNamed("alpha 0.3 at 20 m/s")), {});
    for (const char* column : {"u", "v", "du", "dv", "Fx", "Fy"}) EXPECT_EQ(out.at(0, column), 0) << column;
    EXPECT_NE(out.at(1, "v"), 0);
}

TEST(TyreTransient, ForcesOfARowFollowFromItsOwnMotion) {
    // Camber steps at 20 ms: its non-lagging part (24) is in the force of the very row, the patch follows later.
    TyreTable motion = motionTable(caseNamed("camber 0.05 at 20 m/s"));
    const TyreTable out = transientTable(motion, {"--axes", "paper"});
    for (std::size_t row = 0; row < motion.rows.size(); ++row) motion.at(row, "gamma") = 0;
    const TyreTable upright = transientTable(motion, {"--axes", "paper"});
    const TyreCoefficients p = tyreWithCouples().parameters;
    ASSERT_EQ(out.at(19, "gamma"), 0);
    ASSERT_EQ(out.at(20, "gamma"), 0.05);
    EXPECT_TRUE(near(out.at(20, "Fy") - upright.at(20, "Fy"), 4000 * p.pTy8 * 0.05, 1e-9));
    for (const char* state : {"u", "v", "du", "dv"}) {
        EXPECT_EQ(out.at(20, state), upright.at(20, state));
        EXPECT_NE(out.at(21, state), upright.at(21, state));
    }
}

TEST(TyreTransient, ForcesOfAKnownStateAreThoseThatTheAdvanceReturned) {
    const TyreParams tyre = tyreWithCouples();
    for (const auto standstill : {Standstill::paper, Standstill::hold}) {
        for (const double speed : {0.3, 1.4, 20.0}) {
            TyreState state;
            for (int i = 1; i <= 200; ++i) {
                const TyreMotion motion{.Vsx = 0.03 * speed,
                                        .Vsy = -0.05 * speed,
                                        .Vx = speed,
                                        .Omega = 0.97 * speed / tyre.parameters.Re,
                                        .psidot = 0.4,
                                        .gamma = 0.03,
                                        .Fz = 4200};
                const auto advanced = advance(state, tyre, motion, motion, 1e-3, standstill);
                const auto again = rimForces(state, tyre, motion, standstill);
                // `advance` follows the slopes over its last Newton step: about 1e-6 of the peak force.
                const double tolerance = 1e-5 * motion.Fz;
                EXPECT_EQ(advanced.Fx, again.Fx);
                EXPECT_EQ(advanced.Fy, again.Fy);
                EXPECT_EQ(advanced.Mx, again.Mx);
                EXPECT_EQ(advanced.My, again.My);
                EXPECT_NEAR(advanced.Mz, again.Mz, tolerance * tyre.parameters.Ro);
            }
        }
    }
}

TEST(TyreTransient, TheStandstillExtensionHoldsAParkedWheelThatThePaperLetsCreep) {
    TyreTable motion{kMotionColumns, {}};
    for (int i = 0; i <= 1000; ++i) motion.rows.push_back({0.02 * i, 0, i < 5 ? 0.01 : 0, 0, 0, 0, 0, 4000});
    const TyreTable paper = transientTable(motion, {}), held = transientTable(motion, {"--standstill"});
    ASSERT_LT(held.at(10, "Fy"), -50);
    EXPECT_TRUE(near(held.at(1000, "Fy"), held.at(50, "Fy"), 1e-3 * std::abs(held.at(50, "Fy"))));
    EXPECT_LT(std::abs(paper.at(1000, "Fy")), 0.9 * std::abs(paper.at(50, "Fy")));
}

TEST(TyreTransient, HeldAndLinearMotionAreHalfASampleApart) {
    TyreTable motion{kMotionColumns, {}};
    for (int i = 0; i <= 100; ++i) motion.rows.push_back({0.01 * i, 0, -0.02 * i, 20, 20 / 0.3055, 0, 0, 4000});
    const TyreTable held = transientTable(motion, {"--substeps", "20"});
    const TyreTable linear = transientTable(motion, {"--substeps", "20", "--interpolate", "linear"});
    const double slope = (linear.at(60, "v") - linear.at(50, "v")) / 0.1;
    const double late = (linear.at(55, "v") - held.at(55, "v")) / slope;
    EXPECT_NEAR(late, 0.005, 0.0008);  // s; the patch follows in 16 ms, so a staircase of 10 ms still ripples
}

}  // namespace
}  // namespace tread::tyre_transient_test
