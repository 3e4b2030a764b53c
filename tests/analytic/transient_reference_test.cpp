#include "shared/transient_reference.h"

#include <gtest/gtest.h>

#include <complex>
#include <set>
#include <string>

#include "shared/car_205_60R15.h"
#include "shared/near.h"

namespace reference::transient_reference_test {
namespace {

using tread::TyreParams;

// What a product of ours would report: motion of the patch and the five forces and moments.
constexpr Real Point::*kOutputs[] = {&Point::u,  &Point::v,  &Point::du, &Point::dv, &Point::Fx,
                                     &Point::Fy, &Point::Mx, &Point::My, &Point::Mz};

// Largest difference of an output between two trajectories, as a fraction of its peak.
Real difference(const Trajectory& a, const Trajectory& b) {
    Real worst = 0;
    for (const Real Point::*output : kOutputs) {
        Real peak = 0, apart = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            peak = std::max(peak, std::abs(a[i].*output));
            apart = std::max(apart, std::abs(a[i].*output - b[i].*output));
        }
        if (peak > 0) worst = std::max(worst, apart / peak);
    }
    return worst;
}

Case held(Sample sample, int samples) {
    Case motion{"held", Between::hold, Range::ordinary, {}};
    for (int i = 0; i < samples; ++i) {
        sample.t = i * kSampling;
        motion.samples.push_back(sample);
    }
    return motion;
}

// The 205/60R15 set has no overturning couple and no part of rolling resistance that follows Fx: give it some.
TyreParams car205WithCouples() {
    TyreParams tyre = car205();
    tyre.parameters.qx1 = 2e-5;
    tyre.parameters.qx2 = -0.1;
    tyre.parameters.qy2 = 1e-6;
    return tyre;
}

TEST(TransientCases, AreThirtyTwoConsistentMotionsSampledAtAMillisecond) {
    const std::vector<Case> cases = transientCases();
    std::set<std::string> names;
    EXPECT_EQ(cases.size(), 32u);
    for (const Case& motion : cases) {
        EXPECT_TRUE(names.insert(motion.name).second) << motion.name;
        for (std::size_t i = 0; i < motion.samples.size(); ++i) {
            const Sample& sample = motion.samples[i];
            ASSERT_TRUE(near(sample.t, static_cast<Real>(i) * kSampling, 1e-15L));
            ASSERT_TRUE(near(sample.Vsx, sample.Vx - 0.3055L * sample.Omega, 1e-15L)) << motion.name;
            ASSERT_GE(sample.Fz, 0);
            if (motion.range == Range::ordinary) {
                ASSERT_GE(std::abs(sample.Vx), 2) << motion.name;
                ASSERT_LE(std::abs(sample.Vx), 60) << motion.name;
            }
        }
    }
}

class TransientReference : public ::testing::TestWithParam<std::size_t> {};

TEST_P(TransientReference, DoesNotMoveWithATenthOfTheTolerance) {
    const Case motion = transientCases()[GetParam()];
    const Trajectory usual = integrate(car205WithCouples(), motion);
    const Trajectory finer = integrate(car205WithCouples(), motion, kIntegrationTolerance / 10);
    ASSERT_EQ(usual.size(), motion.samples.size());
    EXPECT_LT(difference(usual, finer), 1e-8L) << motion.name;
}
INSTANTIATE_TEST_SUITE_P(Cases, TransientReference, ::testing::Range(std::size_t{0}, std::size_t{32}));

// The same equations by the classical explicit Runge-Kutta method with far too small steps.
Trajectory explicitly(const TyreParams& tyre, const Case& motion, int steps) {
    Patch patch;
    Trajectory trajectory{wheelForces(tyre, motion.samples.front(), patch)};
    for (std::size_t i = 1; i < motion.samples.size(); ++i) {
        const Interval interval{motion.samples[i - 1], motion.samples[i], motion.between};
        const Real h = interval.length() / steps;
        for (int n = 0; n < steps; ++n) {
            const auto slope = [&](Real time, const Patch& at) {
                return Patch{at.rate, patchForces(tyre, interval.at(time), at).acceleration};
            };
            const auto moved = [&](const Patch& k, Real by) {
                return Patch{patch.deflection + by * k.deflection, patch.rate + by * k.rate};
            };
            const Patch k1 = slope(n * h, patch);
            const Patch k2 = slope(n * h + h / 2, moved(k1, h / 2));
            const Patch k3 = slope(n * h + h / 2, moved(k2, h / 2));
            const Patch k4 = slope(n * h + h, moved(k3, h));
            patch.deflection += h / 6 * (k1.deflection + 2 * k2.deflection + 2 * k3.deflection + k4.deflection);
            patch.rate += h / 6 * (k1.rate + 2 * k2.rate + 2 * k3.rate + k4.rate);
        }
        trajectory.push_back(wheelForces(tyre, interval.at(interval.length()), patch));
    }
    return trajectory;
}

TEST(TransientReferenceByOtherMeans, AgreesWithAnExplicitMethodInSmallSteps) {
    for (const char* name :
         {"alpha 0.08 and kappa -0.08 at 25 m/s", "alpha 0.05 over 2 m", "locked at once at 20 m/s"}) {
        for (Case motion : transientCases()) {
            if (motion.name != name) continue;
            motion.samples.resize(81);
            const TyreParams tyre = car205WithCouples();
            // Steps of 4 us against rates of about 3e4 1/s at the steepest slip: (0.1)^4 / 120 a step, and far less
            // after it.
            EXPECT_LT(difference(integrate(tyre, motion), explicitly(tyre, motion, 250)), 1e-8L) << name;
        }
    }
}

// m x'' + k x' + c x = f from rest.
struct Oscillator {
    Real m, k, c, f;

    struct Motion {
        Real position, speed, acceleration;
    };
    Motion at(Real t) const {
        using Complex = std::complex<Real>;
        const Complex root = std::sqrt(Complex(k * k - 4 * m * c));
        const Complex a = (-k + root) / (2 * m), b = (-k - root) / (2 * m);
        const Complex ea = std::exp(a * t), eb = std::exp(b * t);
        const Real end = f / c;
        return {end * (1 - ((b * ea - a * eb) / (b - a)).real()), -end * (a * b * (ea - eb) / (b - a)).real(),
                -end * (a * b * (a * ea - b * eb) / (b - a)).real()};
    }
};

// Slip so small that the tyre is linear: (B alpha)^2 = 1e-12. At 200 m/s the patch oscillates, below it creeps.
constexpr Real kTinySlip = 1e-7L;
constexpr Real kLinearTolerance = 1e-10L;

TEST(TransientReferenceByOtherMeans, LongitudinalResponseToTinySlipIsThatOfTheLinearOscillator) {
    const TyreParams tyre = unshifted(car205());
    const tread::TyreCoefficients& p = tyre.parameters;
    for (const Real V : {5.0L, 30.0L, 200.0L}) {
        const Trajectory trajectory = integrate(tyre, held(rolling(V, -kTinySlip, 0), 101));
        const Real Kx = steady(p, tyre.lambda, {4000, 0, V, 0, 0}).Kx;
        const Oscillator exact{p.mc, p.kFx + Kx / V, p.cFx, -Kx * kTinySlip};
        for (const Point& point : trajectory) {
            const auto [u, du, ddu] = exact.at(point.t);
            ASSERT_TRUE(near(point.u, u, kLinearTolerance * Kx * kTinySlip / p.cFx))
                << V << " m/s, " << point.t << " s";
            ASSERT_TRUE(near(point.du, du, kLinearTolerance * Kx * kTinySlip / std::sqrt(p.cFx * p.mc)));
            ASSERT_TRUE(near(point.Fx, p.kFx * du + p.cFx * u, kLinearTolerance * Kx * kTinySlip));
        }
    }
}

// With the gyroscopic terms the oscillator stays linear: belt yaw (27) multiplies the slip damping, the yaw rate (26)
// and the non-lagging camber force (24) add to the force.
TEST(TransientReferenceByOtherMeans, LateralResponseToTinySlipIsThatOfTheLinearOscillator) {
    for (const bool gyroscopic : {false, true}) {
        TyreParams tyre = unshifted(car205());
        tread::TyreCoefficients& p = tyre.parameters;
        if (!gyroscopic) p.czgyr = p.cygyr = p.cpsigyr = 0;
        for (const Real V : {5.0L, 30.0L, 200.0L}) {
            Sample sample = rolling(V, 0, kTinySlip);
            sample.Omega = V / p.Re;
            sample.psidot = 1e-6L;
            const Trajectory trajectory = integrate(tyre, held(sample, 101));
            const Result slope = steady(p, tyre.lambda, {4000, 0, V, 0, 0});
            const Real belt = 1 + V * sample.Omega * p.cpsigyr * p.czgyr * p.mt / (Real(p.Ro) * p.cFy);
            const Real force = slope.Ky * kTinySlip + p.cygyr * Real(p.Ro) * p.mt * sample.Omega * sample.psidot;
            const Oscillator exact{p.mc, p.kFy + slope.Ky / V * belt, p.cFy, force};
            for (const Point& point : trajectory) {
                const auto [v, dv, ddv] = exact.at(point.t);
                ASSERT_TRUE(near(point.v, v, kLinearTolerance * force / p.cFy)) << V << " m/s, " << point.t << " s";
                ASSERT_TRUE(near(point.dv, dv, kLinearTolerance * force / std::sqrt(p.cFy * p.mc)));
                const Real Fy_patch = slope.Ky * (kTinySlip - belt * dv / V);
                ASSERT_TRUE(near(point.Fy, Fy_patch - p.mc * ddv, 10 * kLinearTolerance * force));
                const Real couple = p.czgyr * Real(p.Ro) * p.mt * sample.Omega * dv;
                ASSERT_TRUE(near(point.Mz, -slope.Dt * Fy_patch - couple, 10 * kLinearTolerance * force));
            }
        }
    }
}

TEST(TransientReferenceByOtherMeans, SettlesOnTheSteadyStateOfTheRim) {
    const TyreParams tyre = car205WithCouples();
    const tread::TyreCoefficients& p = tyre.parameters;
    Sample sample = rolling(25, -0.04L, 0.05L, 4500);
    sample.gamma = -0.03L;
    sample.Omega = (sample.Vx - sample.Vsx) / p.Re;
    const Point end = integrate(tyre, held(sample, 1001)).back();
    const Result r = steady(p, tyre.lambda, {sample.Fz, sample.gamma, sample.Vx, sample.Vsx, sample.Vsy});
    const Real FyNL = sample.Fz * (p.pTy8 + p.pTy9 * r.dfz) * sample.gamma;
    EXPECT_TRUE(near(end.u, r.Fx / p.cFx, 1e-12L));
    EXPECT_TRUE(near(end.v, (r.Fy - FyNL) / p.cFy, 1e-12L));
    for (const auto& [transient, rim] :
         {std::pair{end.Fx, r.Fx}, {end.Fy, r.Fy}, {end.Mx, r.Mx}, {end.My, r.My}, {end.Mz, r.Mz}}) {
        EXPECT_TRUE(near(transient, rim, 1e-9L * std::abs(rim)));
    }
}

}  // namespace
}  // namespace reference::transient_reference_test
