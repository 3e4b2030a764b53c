// A second formulation of the transient part of Delft Tyre 97, (17)-(28), to test the product's integration against:
// the contact-patch mass under a prescribed motion of the rim, integrated in long double by Radau IIA with steps
// controlled by comparison with two half steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "shared/radau_step.h"

namespace reference {

using Trajectory = std::vector<Point>;  // one per sample of the case

// Carries `patch` through the interval; `h` is the step to begin with and the one to go on with.
inline void advance(const tread::TyreParams& tyre, const Interval& interval, const Scales& scales, Real tolerance,
                    Patch& patch, Real& h) {
    for (Real time = 0; time < interval.length();) {
        const Real left = interval.length() - time;
        const bool last = h >= left * (1 - 1e-12L);
        const Real step = last ? left : h;
        if (step < 1e-15L) throw std::runtime_error("the reference integration does not get on");
        Patch once = patch, twice = patch;
        const bool converged = radauStep(tyre, interval, time, step, scales, once) &&
                               radauStep(tyre, interval, time, step / 2, scales, twice) &&
                               radauStep(tyre, interval, time + step / 2, step / 2, scales, twice);
        const Real error =
            !converged ? std::numeric_limits<Real>::infinity()
                       : std::max((once.deflection - twice.deflection).cwiseAbs().maxCoeff() / scales.deflection,
                                  (once.rate - twice.rate).cwiseAbs().maxCoeff() / scales.rate) /
                             31;
        const Real factor = std::clamp(0.9L * std::pow(tolerance / std::max(error, 1e-30L), 1 / 6.0L), 0.1L, 4.0L);
        if (error <= tolerance) {
            patch = twice;
            time = last ? interval.length() : time + step;
            h = last ? std::max(h, step * factor) : step * factor;
        } else {
            h = step * std::min(factor, 0.5L);
        }
    }
}

// Local error allowed in one step; with a tenth of it, no output of the 32 cases moves by more than 5e-9 of its peak.
inline constexpr Real kIntegrationTolerance = 2e-12L;

// The case from a patch at rest and undeflected; `tolerance` is the local error allowed in one step, as a fraction of
// the largest steady-state force of the case (over stiffness for deflections, over impedance for rates).
inline Trajectory integrate(const tread::TyreParams& tyre, const Case& motion, Real tolerance = kIntegrationTolerance) {
    const tread::TyreCoefficients& p = tyre.parameters;
    Real force = 1e-9L * p.Fzo;
    for (const Sample& s : motion.samples) {
        const Result steady_state = steady(p, tyre.lambda, {s.Fz, s.gamma, s.Vx, s.Vsx, s.Vsy});
        force = std::max(force, std::hypot(steady_state.Fx, steady_state.Fy));
    }
    const Real stiffness = std::max(p.cFx, p.cFy);
    const Scales scales{force / stiffness, force / std::sqrt(stiffness * p.mc)};

    Patch patch;
    Trajectory trajectory{wheelForces(tyre, motion.samples.front(), patch)};
    Real h = 1e-5L;
    for (std::size_t i = 1; i < motion.samples.size(); ++i) {
        const Interval interval{motion.samples[i - 1], motion.samples[i], motion.between};
        advance(tyre, interval, scales, tolerance, patch, h);
        trajectory.push_back(wheelForces(tyre, interval.at(interval.length()), patch));
    }
    return trajectory;
}

}  // namespace reference
