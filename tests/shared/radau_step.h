// One step of the three-stage Radau IIA method (order 5, L-stable) for the contact patch, with full Newton. The method:
// E. Hairer, G. Wanner, "Solving Ordinary Differential Equations II", section IV.8.
#pragma once

#include <Eigen/Dense>
#include <cmath>

#include "shared/patch_reference.h"

namespace reference {

// Two samples and the way between them.
struct Interval {
    Sample from, to;
    Between between;

    Real length() const { return to.t - from.t; }
    Sample at(Real time) const {
        Sample sample = from;
        sample.t = from.t + time;
        if (between == Between::hold) return sample;
        const Real x = time / length();
        for (const auto member :
             {&Sample::Vsx, &Sample::Vsy, &Sample::Vx, &Sample::Omega, &Sample::psidot, &Sample::gamma, &Sample::Fz}) {
            sample.*member = from.*member + x * (to.*member - from.*member);
        }
        return sample;
    }
};

// Sizes of deflection and rate in a case: tolerances are fractions of them.
struct Scales {
    Real deflection;
    Real rate;
};

using Vector6 = Eigen::Matrix<Real, 6, 1>;  // rates at the three stages
using Matrix6 = Eigen::Matrix<Real, 6, 6>;

inline constexpr int kStages = 3;
inline const Real kRoot6 = std::sqrt(6.0L);
inline const Real kTimes[kStages] = {(4 - kRoot6) / 10, (4 + kRoot6) / 10, 1};
inline const Real kWeights[kStages][kStages] = {
    {(88 - 7 * kRoot6) / 360, (296 - 169 * kRoot6) / 1800, (-2 + 3 * kRoot6) / 225},
    {(296 + 169 * kRoot6) / 1800, (88 + 7 * kRoot6) / 360, (-2 - 3 * kRoot6) / 225},
    {(16 - kRoot6) / 36, (16 + kRoot6) / 36, 1 / 9.0L}};

// The equations of one step: the unknowns are the rates at the stages, deflections follow from them.
struct StageEquations {
    const tread::TyreParams& tyre;
    const Sample inputs[kStages];
    const Patch& start;
    const Real h;
    const Scales& scales;

    Patch stage(const Vector6& rates, int i) const {
        Patch patch{start.deflection, rates.segment<2>(2 * i)};
        for (int j = 0; j < kStages; ++j) patch.deflection += h * kWeights[i][j] * rates.segment<2>(2 * j);
        return patch;
    }

    // rates - start rate - h A acceleration
    Vector6 residual(const Vector6& rates) const {
        Vector6 out = rates - start.rate.replicate<kStages, 1>();
        for (int j = 0; j < kStages; ++j) {
            const Vector2 acceleration = patchForces(tyre, inputs[j], stage(rates, j)).acceleration;
            for (int i = 0; i < kStages; ++i) out.segment<2>(2 * i) -= h * kWeights[i][j] * acceleration;
        }
        return out;
    }

    // Derivative of the acceleration with respect to the rate, by differences (1e-9 accurate in long double).
    Matrix2 slope(const Vector6& rates, int i) const {
        const Real step = 1e-10L * scales.rate;
        const Patch at = stage(rates, i);
        const Vector2 acceleration = patchForces(tyre, inputs[i], at).acceleration;
        Matrix2 out;
        for (int k = 0; k < 2; ++k) {
            Patch beside = at;
            beside.rate[k] += step;
            out.col(k) = (patchForces(tyre, inputs[i], beside).acceleration - acceleration) / step;
        }
        return out;
    }

    Matrix6 jacobian(const Vector6& rates) const {
        const Vector2 stiffness(-Real(tyre.parameters.cFx) / tyre.parameters.mc,
                                -Real(tyre.parameters.cFy) / tyre.parameters.mc);
        Matrix6 out = Matrix6::Identity();
        for (int j = 0; j < kStages; ++j) {
            const Matrix2 D = slope(rates, j);
            for (int i = 0; i < kStages; ++i) {
                out.block<2, 2>(2 * i, 2 * j) -= h * kWeights[i][j] * D;
                for (int k = 0; k < kStages; ++k) {
                    out.block<2, 2>(2 * i, 2 * k).diagonal() -= h * h * kWeights[i][j] * kWeights[j][k] * stiffness;
                }
            }
        }
        return out;
    }
};

// Steps `patch` by h from `time` in the interval; false when Newton's method does not converge.
inline bool radauStep(const tread::TyreParams& tyre, const Interval& interval, Real time, Real h, const Scales& scales,
                      Patch& patch) {
    const StageEquations equations{
        tyre,
        {interval.at(time + kTimes[0] * h), interval.at(time + kTimes[1] * h), interval.at(time + kTimes[2] * h)},
        patch,
        h,
        scales};
    Vector6 rates = patch.rate.replicate<kStages, 1>();
    Vector6 residual = equations.residual(rates);
    for (int iteration = 0; iteration < 15; ++iteration) {
        const Vector6 full = equations.jacobian(rates).partialPivLu().solve(residual);
        Vector6 next = rates - full;
        Vector6 next_residual = equations.residual(next);
        for (Real part = 0.5L; next_residual.norm() > residual.norm() && part > 0.01L; part /= 2) {
            next = rates - part * full;
            next_residual = equations.residual(next);
        }
        rates = next;
        residual = next_residual;
        if (full.cwiseAbs().maxCoeff() < 1e-14L * scales.rate) {
            patch = equations.stage(rates, kStages - 1);
            return true;
        }
    }
    return false;
}

}  // namespace reference
