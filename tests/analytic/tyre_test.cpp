// The product's tyre against the second formulation in tests/shared, which shares no code with it.

#include "tread/tyre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <vector>

#include "base/fields/numbers.h"
#include "shared/car_205_60R15.h"
#include "shared/transient_cases.h"
#include "shared/transient_reference.h"

namespace tread::tyre_test {
namespace {

// ---- Steady state ----

// Both formulations round differently; sums that cancel (Mz) lose a few digits more.
constexpr double kSteadyTolerance = 1e-10;

std::map<std::string, double> columns(const reference::Result& r) {
    const auto d = [](long double x) { return static_cast<double>(x); };
    return {{"Fx", d(r.Fx)},       {"Fy", d(r.Fy)},      {"Mx", d(r.Mx)},   {"My", d(r.My)},   {"Mz", d(r.Mz)},
            {"Fx0", d(r.Fx0)},     {"Fy0", d(r.Fy0)},    {"t", d(r.t)},     {"Mzr", d(r.Mzr)}, {"s", d(r.s)},
            {"Kx", d(r.Kx)},       {"Ky", d(r.Ky)},      {"mux", d(r.mux)}, {"muy", d(r.muy)}, {"SVyk", d(r.SVyk)},
            {"kappa", d(r.kappa)}, {"alpha", d(r.alpha)}};
}

// Magnitude below which a quantity counts as zero: its natural size for this load.
double sizeOf(const std::string& name, double Fz, const TyreCoefficients& p) {
    if (name == "t" || name == "s") return p.Ro;
    if (name == "mux" || name == "muy") return 1;
    if (name == "kappa" || name == "alpha") return 1e-12;
    if (name[0] == 'M') return Fz * p.Ro;
    return Fz;
}

struct Worst {
    double error = 0;
    std::string where;
};

Worst compareAtRandom(TyreParams tyre, bool with_lambdas, int points, unsigned seed) {
    std::mt19937 generator(seed);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(generator); };
    Worst worst;
    for (int i = 0; i < points; ++i) {
        if (with_lambdas) {
            for (const Number& n : numbers(tyre.lambda)) *n.value = uniform(0.5, 1.5);
        }
        const double direction = uniform(0, 1) < 0.3 ? -1 : 1;
        const double Vx = direction * (i % 7 == 0 ? uniform(0, 0.02) : uniform(0.02, 70));
        const double slip_scale = i % 5 == 0 ? 30 : 1.2;
        const TyreSlip slip{.Fz = uniform(-500, 12000),
                            .gamma = uniform(-0.25, 0.25),
                            .Vx = Vx,
                            .Vsx = std::abs(Vx) * uniform(-slip_scale, slip_scale),
                            .Vsy = std::abs(Vx) * uniform(-slip_scale, slip_scale)};
        TyreSteadyState got = steadyState(tyre, slip);
        const auto expected = columns(
            reference::steady(tyre.parameters, tyre.lambda, {slip.Fz, slip.gamma, slip.Vx, slip.Vsx, slip.Vsy}));
        for (const Number& n : numbers(got)) {
            const double value = expected.at(n.path);
            const double floor = 1e-3 * sizeOf(n.path, std::max(slip.Fz, 1.0), tyre.parameters);
            const double error = std::abs(*n.value - value) / std::max(std::abs(value), floor);
            if (!(error <= worst.error)) worst = {error, n.path};
        }
    }
    return worst;
}

TEST(SteadyTyre, AgreesWithSecondFormulationAtRandomPoints) {
    const Worst worst = compareAtRandom(reference::car205(), false, 20000, 1);
    std::printf("steady state, 20000 random points: largest relative difference %.1e (%s)\n", worst.error,
                worst.where.c_str());
    EXPECT_LE(worst.error, kSteadyTolerance);
}

TEST(SteadyTyre, AgreesWithSecondFormulationForEveryScalingFactor) {
    const Worst worst = compareAtRandom(reference::car205(), true, 20000, 2);
    std::printf("steady state with random lambdas: largest relative difference %.1e (%s)\n", worst.error,
                worst.where.c_str());
    EXPECT_LE(worst.error, kSteadyTolerance);
}

TEST(SteadyTyre, EveryCoefficientIsUsed) {
    // A coefficient that the formulas forgot would leave every output unchanged.
    const TyreParams tyre = reference::car205();
    const std::vector<std::string> transient{"mc",      "kFx",  "kFy",  "cFx", "cFy", "mt", "czgyr", "cygyr",
                                             "cpsigyr", "pTy8", "pTy9", "pz1", "pz2", "Re", "pRe1"};
    TyreParams changed = tyre;
    for (const Number& n : numbers(changed.parameters)) {
        if (std::find(transient.begin(), transient.end(), n.path) != transient.end()) continue;
        const double before = *n.value;
        *n.value += 0.01 * (std::abs(before) + 1);
        double moved = 0;
        for (const double sign : {-1.0, 1.0}) {
            const TyreSlip slip{5200, 0.08, 20, sign * 1.1, -1.7};
            TyreSteadyState a = steadyState(tyre, slip), b = steadyState(changed, slip);
            const auto first = numbers(a), second = numbers(b);
            for (std::size_t i = 0; i < first.size(); ++i) moved += std::abs(*first[i].value - *second[i].value);
        }
        EXPECT_GT(moved, 1e-9) << n.path;
        *n.value = before;
    }
}

TEST(SteadyTyre, IsFiniteForEveryFiniteInput) {
    for (const double friction : {0.0, 1.0}) {
        TyreParams tyre = reference::car205();
        tyre.lambda.muy = tyre.lambda.mux = friction;
        for (const double Fz : {-1e4, 0.0, 1e-9, 4e3, 1e6}) {
            for (const double Vx : {-1e3, -1e-9, 0.0, 1e-9, 1e3}) {
                for (const double Vs : {-1e6, -1.0, 0.0, 1.0, 1e6}) {
                    TyreSteadyState out = steadyState(tyre, {Fz, 1.5, Vx, Vs, -Vs});
                    for (const Number& n : numbers(out))
                        EXPECT_TRUE(std::isfinite(*n.value)) << n.path << " at Fz " << Fz;
                }
            }
        }
    }
}

TEST(SteadyTyre, MirroredTyreGivesTheMirroredForcesExactly) {
    const TyreParams tyre = reference::car205();
    const TyreParams other = mirrored(tyre);
    std::mt19937 generator(3);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(generator); };
    for (int i = 0; i < 1000; ++i) {
        const TyreSlip slip{uniform(0, 9000), uniform(-0.1, 0.1), uniform(-30, 30), uniform(-9, 9), uniform(-9, 9)};
        TyreSlip mirror = slip;
        mirror.gamma = -slip.gamma;
        mirror.Vsy = -slip.Vsy;
        const TyreSteadyState a = steadyState(tyre, slip), b = steadyState(other, mirror);
        EXPECT_EQ(a.Fx, b.Fx);
        EXPECT_EQ(a.Fy, -b.Fy);
        EXPECT_EQ(a.Mx, -b.Mx);
        EXPECT_EQ(a.My, b.My);
        EXPECT_EQ(a.Mz, -b.Mz);
    }
}

TEST(SteadyTyre, FrictionNeverDrivesTheSlip) {
    // F . Vs <= 0 where the model promises it: no shifts, shape factors of the weightings at most 1.
    TyreParams tyre = reference::unshifted(reference::car205());
    tyre.parameters.rCx1 = std::min(tyre.parameters.rCx1, 1.0);
    tyre.parameters.rCy1 = std::min(tyre.parameters.rCy1, 1.0);
    TyreCoefficients& p = tyre.parameters;
    for (double* shift : {&p.pHx1, &p.pHx2, &p.pVx1, &p.pVx2, &p.pHy3, &p.pVy3, &p.pVy4, &p.rVy3, &p.rHy1}) *shift = 0;
    std::mt19937 generator(4);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(generator); };
    double largest = -kInfinity;
    for (int i = 0; i < 100000; ++i) {
        const double Vx = uniform(-60, 60);
        const TyreSlip slip{uniform(0, 9000), uniform(-0.1, 0.1), Vx, Vx * uniform(-5, 5), Vx * uniform(-5, 5)};
        const TyreSteadyState f = steadyState(tyre, slip);
        largest = std::max(largest, (f.Fx * slip.Vsx + f.Fy * slip.Vsy));
    }
    std::printf("tyre power F . Vs over 100000 random points: largest %.3g W\n", largest);
    EXPECT_LE(largest, 0);
}

// ---- Transients ----

TyreMotion motionOf(const reference::Sample& s) {
    const auto d = [](long double x) { return static_cast<double>(x); };
    return {d(s.Vsx), d(s.Vsy), d(s.Vx), d(s.Omega), d(s.psidot), d(s.gamma), d(s.Fz)};
}

struct Row {
    double u, v, Fx, Fy, Mz;
};
constexpr std::array kRowNames{"u", "v", "Fx", "Fy", "Mz"};
std::array<double, 5> values(const Row& r) {
    return {r.u, r.v, r.Fx, r.Fy, r.Mz};
}

std::vector<Row> integrate(const TyreParams& tyre, const reference::Case& c, int substeps) {
    TyreState state;
    std::vector<Row> rows{{0, 0, 0, 0, 0}};
    for (std::size_t i = 1; i < c.samples.size(); ++i) {
        const TyreMotion a = motionOf(c.samples[i - 1]), b = motionOf(c.samples[i]);
        TyreForces f;
        const double h = static_cast<double>(reference::kSampling) / substeps;
        for (int k = 0; k < substeps; ++k) {
            const auto mix = [&](double share) {
                TyreMotion m = a;
                if (c.between == reference::Between::hold) return m;
                TyreMotion to = b;
                const auto from = numbers(m), target = numbers(to);
                for (std::size_t j = 0; j < from.size(); ++j)
                    *from[j].value += share * (*target[j].value - *from[j].value);
                return m;
            };
            f = advance(state, tyre, mix(double(k) / substeps), mix(double(k + 1) / substeps), h, Standstill::paper);
        }
        rows.push_back({state.u, state.v, f.Fx, f.Fy, f.Mz});
    }
    return rows;
}

struct Deviation {
    double q90 = 0, q99 = 0;  // quantiles of |difference| / peak
};

std::array<Deviation, 5> deviation(const std::vector<Row>& rows, const reference::Trajectory& truth) {
    std::array<Deviation, 5> result;
    for (std::size_t k = 0; k < 5; ++k) {
        std::vector<double> difference;
        double peak = 0;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const reference::Point& t = truth[i];
            const std::array<double, 5> expected{double(t.u), double(t.v), double(t.Fx), double(t.Fy), double(t.Mz)};
            peak = std::max(peak, std::abs(expected[k]));
            difference.push_back(std::abs(values(rows[i])[k] - expected[k]));
        }
        std::sort(difference.begin(), difference.end());
        if (peak == 0) continue;
        result[k] = {difference[difference.size() * 90 / 100] / peak, difference[difference.size() * 99 / 100] / peak};
    }
    return result;
}

TEST(TransientTyre, FollowsTightReferenceAtOneMillisecond) {
    const TyreParams tyre = reference::car205();
    for (const reference::Case& c : reference::transientCases()) {
        const auto worst = deviation(integrate(tyre, c, 1), reference::integrate(tyre, c));
        const bool ordinary = c.range == reference::Range::ordinary;
        for (std::size_t k = 0; k < 5; ++k) {
            // 90 % of the samples within 0.5 % of the peak and 99 % within 2 %; near standstill within 10 %.
            EXPECT_LE(worst[k].q90, ordinary ? 0.005 : 0.10) << c.name << " " << kRowNames[k];
            EXPECT_LE(worst[k].q99, ordinary ? 0.02 : 0.10) << c.name << " " << kRowNames[k];
        }
        std::printf("%-44s 99 %%: u %.2f v %.2f Fx %.2f Fy %.2f Mz %.2f %%\n", c.name.c_str(), 100 * worst[0].q99,
                    100 * worst[1].q99, 100 * worst[2].q99, 100 * worst[3].q99, 100 * worst[4].q99);
    }
}

}  // namespace
}  // namespace tread::tyre_test
