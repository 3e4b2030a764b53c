#include "shared/delft97_reference.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "shared/car_205_60R15.h"
#include "shared/near.h"

namespace reference::delft97_reference_test {
namespace {

using tread::TyreCoefficients;
using tread::TyreParams;
using tread::TyreScaling;

Result steady(const TyreParams& tyre, const Inputs& in) {
    return reference::steady(tyre.parameters, tyre.lambda, in);
}

// Pure or combined slip at 20 m/s.
Inputs slip(Real Fz, Real gamma, Real kappa, Real alpha, Real Vx = 20) {
    const Real V = std::abs(Vx);
    return {Fz, gamma, Vx, -kappa * V, -alpha * V};
}

struct Worked {
    std::string name;
    Real Result::*member;
    std::array<Real, 3> values;
};

// Three points of the 205/60R15 set with every intermediate of the appendix, from an independent evaluation of the
// paper in double precision: all lambdas one; all one, running backwards; lambdas drawn at random (below).
const std::array<Inputs, 3> kPoints{
    {{4200, 0.05L, 20, 1, -1.6L}, {2500, -0.08L, -8, -0.4L, -0.5L}, {5600, 0.1L, 27, -0.7L, 0.9L}}};
const std::vector<Worked> kWorked{
    {"kappa", &Result::kappa, {-0.05L, 0.05L, 0.025925925925925925L}},
    {"alpha", &Result::alpha, {0.08L, 0.0625L, -0.03333333333333333L}},
    {"V", &Result::V, {20.063897926375123L, 8.0156097709407L, 27.01499583564654L}},
    {"Vr", &Result::Vr, {19.0L, -7.6L, 27.7L}},
    {"dfz", &Result::dfz, {0.05L, -0.375L, 0.5819209039548022L}},
    {"ca", &Result::ca, {0.9968152785361251L, -0.9980525784828885L, 0.9994449069791543L}},
    {"SHx", &Result::SHx, {-0.0019L, -0.00275L, -0.0005744406779661017L}},
    {"SVx", &Result::SVx, {0.0L, 0.0L, 0.0L}},
    {"kx", &Result::kx, {-0.0519L, 0.04725L, 0.025351485247959823L}},
    {"Cx", &Result::Cx, {1.685L, 1.685L, 1.60412L}},
    {"mux", &Result::mux, {1.20815L, 1.223875L, 1.142118638418079L}},
    {"Dx", &Result::Dx, {5074.2300000000005L, 3059.6875L, 6395.864375141243L}},
    {"Ex", &Result::Ex, {0.34869999999999995L, 0.30556249999999996L, 0.3925098471065147L}},
    {"Kx", &Result::Kx, {91420.84384058816L, 49193.9843486837L, 168174.5575693193L}},
    {"Bx", &Result::Bx, {10.692399373686166L, 9.54190352344946L, 16.391707445942934L}},
    {"Fx0", &Result::Fx0, {-3750.6091012182096L, 1975.7641487315836L, 3716.6324068934737L}},
    {"gy", &Result::gy, {0.05L, -0.08L, 0.1222L}},
    {"Cy", &Result::Cy, {1.193L, 1.193L, 1.354055L}},
    {"muy", &Result::muy, {1.01034070625L, 1.11943632L, 1.3155180320944437L}},
    {"Dy", &Result::Dy, {4243.43096625L, 2798.5908L, 7366.9009797288845L}},
    {"Ky", &Result::Ky, {47497.93941908714L, 32384.238984074153L, 65174.28349942931L}},
    {"By", &Result::By, {9.38246999600162L, 9.699600561569875L, 6.533638892071702L}},
    {"SHy", &Result::SHy, {0.006699999999999999L, -0.002625L, 0.01468734429378531L}},
    {"SVy", &Result::SVy, {-72.64949999999999L, -244.32500000000002L, 277.15166436691527L}},
    {"ay", &Result::ay, {0.0867L, 0.059875L, -0.018645989039548023L}},
    {"Ey", &Result::Ey, {-1.3618221475L, -0.5611695649999998L, -0.3254017030762373L}},
    {"Fy0", &Result::Fy0, {3333.398775277364L, 1459.746647137112L, -928.589776750678L}},
    {"SHr", &Result::SHr, {0.00517047049011971L, -0.01016956512379845L, 0.01893981397178863L}},
    {"gz", &Result::gz, {0.05L, -0.08L, 0.1L}},
    {"Bt", &Result::Bt, {8.805505146749999L, 9.092175907500001L, 8.092745386740162L}},
    {"Ct", &Result::Ct, {1.18L, 1.18L, 1.18L}},
    {"Dt", &Result::Dt, {0.0339317490133125L, 0.02126485026875L, 0.04928073055638419L}},
    {"SHt", &Result::SHt, {0.01426L, -0.0038899999999999994L, 0.020768926553672316L}},
    {"at", &Result::at, {0.09426L, 0.05861L, -0.012564406779661016L}},
    {"ar", &Result::ar, {0.0851704704901197L, 0.05233043487620155L, -0.014393519361544704L}},
    {"Et", &Result::Et, {-1.7306589003066626L, -1.6038187968762145L, -1.806245709851372L}},
    {"Br", &Result::Br, {18.47L, 18.47L, 19.034196141479097L}},
    {"Dr", &Result::Dr, {30.002458500000007L, -12.058324999999998L, 83.46066280011932L}},
    {"t0", &Result::t0, {0.019251752621970243L, -0.01702714146490715L, 0.04889736536306955L}},
    {"Mzr0", &Result::Mzr0, {16.04414852887679L, 8.653445938217219L, 80.44971843682036L}},
    {"Mz0", &Result::Mz0, {-48.1296200831416L, 33.50875860194473L, 125.85531202300945L}},
    {"SHxa", &Result::SHxa, {0.007L, 0.007L, 0.007L}},
    {"Cxa", &Result::Cxa, {1.092L, 1.092L, 1.092L}},
    {"Bxa", &Result::Bxa, {10.873643502360252L, 10.873643502360252L, 11.895004689008843L}},
    {"Dxa", &Result::Dxa, {-3763.5521677565657L, 1982.5823604276054L, 3731.9778870508235L}},
    {"Gxa", &Result::Gxa, {0.6791539280461685L, 0.7631406760511293L, 0.9494653457085451L}},
    {"Fx", &Result::Fx, {-2547.2409036580566L, 1507.7859881806048L, 3528.8136730826936L}},
    {"SHyk", &Result::SHyk, {0.009L, 0.009L, 0.009L}},
    {"Cyk", &Result::Cyk, {1.081L, 1.081L, 1.081L}},
    {"Byk", &Result::Byk, {6.0017396509675525L, 6.144287864183268L, 6.454851196926332L}},
    {"Dyk", &Result::Dyk, {3339.0784110173436L, 1462.3533323107663L, -930.4197286674909L}},
    {"Gyk", &Result::Gyk, {0.9678247744513397L, 0.931820783062979L, 0.973324696983232L}},
    {"DVyk", &Result::DVyk, {106.14271380457691L, 44.92788966676736L, 296.14934938335693L}},
    {"SVyk", &Result::SVyk, {85.34689712584093L, -36.125475221318325L, -145.7615476988902L}},
    {"Fy", &Result::Fy, {3311.4928149650277L, 1324.0967885875436L, -1049.5809107764708L}},
    {"Mx", &Result::Mx, {0.0L, 0.0L, 0.0L}},
    {"My", &Result::My, {12.705932171888954L, -7.173276821879043L, 10.943088903465073L}},
    {"ratio", &Result::ratio, {1.9247328401755996L, 1.5190718044316622L, 2.5803821467525903L}},
    {"ateq", &Result::ateq, {0.1347087185935865L, 0.0959378964098555L, -0.06806844553191126L}},
    {"areq", &Result::areq, {0.12851264649299862L, 0.09223568876460204L, -0.06842968916352858L}},
    {"t", &Result::t, {0.011116789634522293L, -0.01157500094060608L, 0.0386434535521492L}},
    {"Fyp", &Result::Fyp, {3226.145917839187L, 1360.222263808862L, -903.8193630775805L}},
    {"Mzr", &Result::Mzr, {11.611280298097103L, 6.092338020612977L, 50.79712202833953L}},
    {"s", &Result::s, {-0.02445379068722899L, 0.0071836705737069765L, -0.03208646812434735L}},
    {"Mz", &Result::Mz, {38.03659068720816L, 32.66834983837459L, -27.503343833167847L}},
};

TyreScaling scalingOfThirdPoint() {
    TyreScaling l;
    l.Fzo = 0.885;
    l.Cx = 0.952;
    l.mux = 0.961;
    l.Kx = 1.216;
    l.Hx = 0.687;
    l.Vx = 0.709;
    l.gy = 1.222;
    l.Cy = 1.135;
    l.muy = 1.244;
    l.Ey = 0.745;
    l.Ky = 1.282;
    l.Hy = 1.268;
    l.Vy = 1.275;
    l.Mr = 1.004;
    l.yk = 1.002;
    l.Mx = 0.955;
    l.My = 0.639;
    return l;
}

// The points were computed in double: 450 roundings of half a unit each would be 1e-13 if none cancelled.
constexpr Real kWorkedTolerance = 1e-13L;

TEST(Delft97Reference, GivesTheWorkedPointsInEveryIntermediate) {
    TyreParams tyre = car205();
    for (std::size_t i = 0; i < kPoints.size(); ++i) {
        tyre.lambda = i == 2 ? scalingOfThirdPoint() : TyreScaling{};
        const Result result = steady(tyre, kPoints[i]);
        for (const Worked& worked : kWorked) {
            EXPECT_TRUE(near(result.*worked.member, worked.values[i], kWorkedTolerance * std::abs(worked.values[i])))
                << worked.name << " of point " << i;
        }
    }
}

// Largest value of f between lo and hi, by golden section from the best of a thousand samples.
template <class Function>
Real largest(Function f, Real lo, Real hi) {
    const Real step = (hi - lo) / 1000;
    Real best = lo;
    for (int i = 0; i <= 1000; ++i) {
        if (f(lo + i * step) > f(best)) best = lo + i * step;
    }
    Real a = best - step, b = best + step;
    const Real golden = (std::sqrt(5.0L) - 1) / 2;
    while (b - a > 1e-9L) {
        const Real c = b - golden * (b - a), d = a + golden * (b - a);
        (f(c) > f(d) ? b : a) = f(c) > f(d) ? d : c;
    }
    return f((a + b) / 2);
}

TEST(Delft97Reference, PeaksOfPureSlipAreDAboveTheVerticalShift) {
    TyreParams tyre = car205();
    tyre.parameters.pVx1 = 0.02;
    for (const Real Fz : {1500.0L, 4000.0L, 6500.0L}) {
        const auto Fx0 = [&](Real kappa) { return steady(tyre, slip(Fz, 0.03L, kappa, 0)).Fx0; };
        const auto Fy0 = [&](Real alpha) { return steady(tyre, slip(Fz, 0.03L, 0, alpha)).Fy0; };
        const Result r = steady(tyre, slip(Fz, 0.03L, 0, 0));
        ASSERT_GE(std::min(r.Cx, r.Cy), 1);
        EXPECT_TRUE(near(largest(Fx0, 0, 1), r.Dx + r.SVx, 1e-12L * r.Dx));
        EXPECT_TRUE(near(largest([&](Real x) { return -Fx0(-x); }, 0, 1), r.Dx - r.SVx, 1e-12L * r.Dx));
        EXPECT_TRUE(near(largest(Fy0, 0, 1), r.Dy + r.SVy, 1e-12L * r.Dy));
        EXPECT_TRUE(near(largest([&](Real x) { return -Fy0(-x); }, 0, 1), r.Dy - r.SVy, 1e-12L * r.Dy));
    }
}

TEST(Delft97Reference, ForcesTendToDSinHalfPiCAtEndlessSlip) {
    const TyreParams tyre = car205();
    const Result r = steady(tyre, slip(4000, 0, 1e9L, 0));
    EXPECT_TRUE(near(r.Fx0, r.Dx * std::sin(r.Cx * std::numbers::pi_v<Real> / 2) + r.SVx, 1e-6L * r.Dx));
    const Result q = steady(tyre, slip(4000, 0, 0, -1e9L));
    EXPECT_TRUE(near(q.Fy0, -q.Dy * std::sin(q.Cy * std::numbers::pi_v<Real> / 2) + q.SVy, 1e-6L * q.Dy));
}

TEST(Delft97Reference, SlopesAtZeroAreTheStiffnesses) {
    const TyreParams tyre = car205();
    const Real h = 1e-6L;  // truncation (B h)^2, rounding 1e-19 / h
    for (const Real Fz : {800.0L, 4000.0L, 9000.0L}) {
        const Result r = steady(tyre, slip(Fz, -0.04L, 0, 0));
        const auto Fx0 = [&](Real kx) { return steady(tyre, slip(Fz, -0.04L, kx - r.SHx, 0)).Fx0; };
        const auto Fy0 = [&](Real ay) { return steady(tyre, slip(Fz, -0.04L, 0, ay - r.SHy)).Fy0; };
        EXPECT_TRUE(near((Fx0(h) - Fx0(-h)) / (2 * h), r.Kx, 1e-9L * r.Kx));
        EXPECT_TRUE(near((Fy0(h) - Fy0(-h)) / (2 * h), r.Ky, 1e-9L * r.Ky));
    }
}

TEST(Delft97Reference, CorneringStiffnessIsLargestAtItsNamedLoad) {
    const TyreParams tyre = car205();
    const TyreCoefficients& p = tyre.parameters;
    const auto Ky = [&](Real Fz) { return steady(tyre, slip(Fz, 0, 0, 0)).Ky; };
    EXPECT_TRUE(near(Ky(Real(p.pKy2) * p.Fzo), Real(p.pKy1) * p.Fzo, 1e-12L * p.pKy1 * p.Fzo));
    EXPECT_TRUE(near(largest(Ky, 100, 20000), Real(p.pKy1) * p.Fzo, 1e-12L * p.pKy1 * p.Fzo));
}

TEST(Delft97Reference, WithoutLoadForcesVanishAndShapesStayContinuous) {
    const TyreParams tyre = car205();
    const Inputs in = slip(0, 0.05L, -0.1L, 0.08L);
    const Result zero = steady(tyre, in);
    for (const Real Result::*m : {&Result::Fx, &Result::Fy, &Result::Mx, &Result::My, &Result::Mz, &Result::t,
                                  &Result::Mzr, &Result::Fx0, &Result::Fy0, &Result::Mz0}) {
        EXPECT_EQ(zero.*m, 0);
    }
    Inputs small = in;
    small.Fz = 1e-6L;
    const Result small_load = steady(tyre, small);
    for (const Real Result::*m : {&Result::Bx, &Result::By, &Result::Br, &Result::SHr, &Result::ratio, &Result::ateq}) {
        EXPECT_TRUE(near(small_load.*m, zero.*m, 1e-8L * std::abs(zero.*m)));
    }
    Inputs lifted = in;
    lifted.Fz = -300;
    EXPECT_EQ(steady(tyre, lifted).Fy, 0);
    EXPECT_EQ(steady(tyre, lifted).dfz, zero.dfz);
}

TEST(Delft97Reference, FrictionNeverTurnsNegative) {
    const TyreParams tyre = car205();
    const Result r = steady(tyre, slip(60000, 0, 0.1L, 0.1L));  // pDy1 + pDy2 dfz = -1.04
    EXPECT_EQ(r.muy, 0);
    EXPECT_EQ(r.By, 0);
    EXPECT_EQ(r.Fy0, r.SVy);
    EXPECT_TRUE(std::isfinite(r.Mz));
}

TEST(Delft97Reference, AnUnshiftedTyreIsSymmetric) {
    const TyreParams tyre = unshifted(car205());
    for (const Real kappa : {-0.3L, -0.02L, 0.07L}) {
        const Result a = steady(tyre, slip(3500, 0.06L, kappa, 0.09L));
        const Result b = steady(tyre, slip(3500, -0.06L, kappa, -0.09L));
        EXPECT_TRUE(near(a.Fx, b.Fx, 1e-15L * a.Dx));
        EXPECT_TRUE(near(a.Fy, -b.Fy, 1e-15L * a.Dy));
        EXPECT_TRUE(near(a.Mz, -b.Mz, 1e-16L * a.Dy));
        EXPECT_TRUE(
            near(steady(tyre, slip(3500, 0, kappa, 0)).Fx, -steady(tyre, slip(3500, 0, -kappa, 0)).Fx, 1e-15L * a.Dx));
    }
}

TEST(Delft97Reference, TheMirroredTyreIsTheMirrorImage) {
    const TyreParams tyre = car205(), mirror = reference::mirrored(tyre);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const Inputs in =
            slip(4000 + 3900 * unit(random), 0.2 * unit(random), unit(random), unit(random), 30 * unit(random));
        const Result a = steady(tyre, in);
        const Result b = steady(mirror, {in.Fz, -in.gamma, in.Vx, in.Vsx, -in.Vsy});
        EXPECT_TRUE(near(a.Fx, b.Fx, 1e-15L * in.Fz));
        EXPECT_TRUE(near(a.Fy, -b.Fy, 1e-15L * in.Fz));
        EXPECT_TRUE(near(a.Mz, -b.Mz, 1e-15L * in.Fz));
        EXPECT_TRUE(near(a.My, b.My, 1e-15L * in.Fz));
    }
}

TEST(Delft97Reference, TheTrailOfABrakedWheelHasNoJumpAtZeroSlipAngle) {
    const TyreParams tyre = unshifted(car205());
    const auto trail = [&](Real alpha) { return steady(tyre, slip(4000, 0, -0.05L, alpha)).t; };
    EXPECT_TRUE(near(trail(0), 0.0179L, 0.00005L));
    EXPECT_TRUE(near(trail(0), trail(1e-12L), 1e-12L));
    EXPECT_TRUE(near(trail(0), trail(-1e-12L), 1e-12L));
    EXPECT_TRUE(near(steady(tyre, slip(4000, 0, 0, 0)).t, 0.0313L, 0.00005L));
}

TEST(Delft97Reference, RunningBackwardsTurnsTrailAndResidualTorqueOnly) {
    const TyreParams tyre = car205();
    const Result forward = steady(tyre, slip(4000, 0.02L, -0.05L, 0.07L, 15));
    const Result back = steady(tyre, slip(4000, 0.02L, -0.05L, 0.07L, -15));
    EXPECT_EQ(forward.Fx, back.Fx);
    EXPECT_EQ(forward.Fy, back.Fy);
    EXPECT_EQ(forward.t, -back.t);
    EXPECT_EQ(forward.Mzr, -back.Mzr);
}

TEST(Delft97Reference, AtStandstillTheMomentIsThatOfTheArmOfFxAlone) {
    const Result r = steady(car205(), {4000, 0.02L, 0, 0.3L, -0.4L});
    EXPECT_TRUE(near(r.kappa, -30, 1e-15L));
    EXPECT_TRUE(near(r.alpha, 40, 1e-15L));
    EXPECT_EQ(r.t, 0);
    EXPECT_EQ(r.Mzr, 0);
    EXPECT_EQ(r.Mz, r.s * r.Fx);
}

}  // namespace
}  // namespace reference::delft97_reference_test
