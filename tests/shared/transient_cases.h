// Prescribed wheel motions to test the integration of the contact patch on: steps, sines, braking to lock, load with
// lift-off, camber, yaw, standstill, start from rest, backwards and through zero; 32 in all, sampled at 1 ms.
// Paper's axes: x forward, y right, z down.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "shared/delft97_reference.h"

namespace reference {

// Motion of the rim, camber and load at one time; Vsx = Vx - Re Omega.
struct Sample {
    Real t = 0;
    Real Vsx = 0;
    Real Vsy = 0;
    Real Vx = 0;
    Real Omega = 0;
    Real psidot = 0;
    Real gamma = 0;
    Real Fz = 4000;
};

enum class Between { hold, linear };             // a sample holds until the next one, or the way there is straight
enum class Range { ordinary, near_standstill };  // 2 to 60 m/s all the time, or not

struct Case {
    std::string name;
    Between between;
    Range range;
    std::vector<Sample> samples;
};

inline constexpr Real kSampling = 0.001L;  // s

// Forward speed with slips; a slip is defined as in steady rolling, also for small speeds.
inline Sample rolling(Real Vx, Real kappa, Real alpha, Real Fz = 4000) {
    Sample sample;
    sample.Vx = Vx;
    sample.Vsx = -kappa * std::abs(Vx);
    sample.Vsy = -alpha * std::abs(Vx);
    sample.Fz = Fz;
    return sample;
}

inline std::vector<Case> transientCases(Real Re = 0.3055L) {
    std::vector<Case> cases;
    const auto add = [&](std::string name, Between between, Range range, Real duration, auto sampleAt) {
        Case& added = cases.emplace_back(Case{std::move(name), between, range, {}});
        for (int i = 0; i * kSampling <= duration + kSampling / 2; ++i) {
            Sample sample = sampleAt(i * kSampling);
            sample.t = i * kSampling;
            sample.Omega = (sample.Vx - sample.Vsx) / Re;
            sample.Fz = std::max(sample.Fz, 0.0L);
            added.samples.push_back(sample);
        }
    };
    // Held steps: `after` replaces `before` at 20 ms.
    const auto addStep = [&](std::string name, Range range, Real duration, Sample before, Sample after) {
        add(std::move(name), Between::hold, range, duration, [=](Real t) { return t < 0.0195L ? before : after; });
    };
    const auto text = [](Real value) { return std::to_string(static_cast<int>(value)); };
    const auto ordinary = Range::ordinary;
    const auto standstill = Range::near_standstill;
    const auto sine = [](Real frequency, Real t) { return std::sin(2 * std::numbers::pi_v<Real> * frequency * t); };

    // Small steps of slip over speed and load
    for (const Real V : {5.0L, 10.0L, 20.0L, 40.0L}) {
        addStep("alpha 0.02 at " + text(V) + " m/s", ordinary, 1.5L / V + 0.1L, rolling(V, 0, 0), rolling(V, 0, 0.02L));
        addStep("kappa -0.02 at " + text(V) + " m/s", ordinary, 1 / V + 0.1L, rolling(V, 0, 0), rolling(V, -0.02L, 0));
    }
    for (const Real Fz : {2000.0L, 7000.0L}) {
        addStep("alpha 0.02 at " + text(Fz) + " N", ordinary, 0.2L, rolling(20, 0, 0, Fz), rolling(20, 0, 0.02L, Fz));
        addStep("kappa 0.02 at " + text(Fz) + " N", ordinary, 0.2L, rolling(20, 0, 0, Fz), rolling(20, 0.02L, 0, Fz));
    }

    // Large steps, braking to lock, combined slip
    addStep("alpha 0.3 at 20 m/s", ordinary, 0.2L, rolling(20, 0, 0), rolling(20, 0, 0.3L));
    addStep("alpha -0.15 at 40 m/s", ordinary, 0.2L, rolling(40, 0, 0, 5000), rolling(40, 0, -0.15L, 5000));
    addStep("kappa -0.3 at 20 m/s", ordinary, 0.2L, rolling(20, 0, 0), rolling(20, -0.3L, 0));
    addStep("kappa 0.4 at 10 m/s", ordinary, 0.2L, rolling(10, 0, 0), rolling(10, 0.4L, 0));
    addStep("locked at once at 20 m/s", ordinary, 0.2L, rolling(20, 0, 0.03L), rolling(20, -1, 0.03L));
    add("braked to lock in 0.1 s from 30 m/s", Between::linear, ordinary, 0.3L,
        [](Real t) { return rolling(30 - 9 * t, -std::min(t / 0.1L, 1.0L), 0.02L); });
    addStep("alpha 0.08 and kappa -0.08 at 25 m/s", ordinary, 0.2L, rolling(25, 0, 0), rolling(25, -0.08L, 0.08L));
    add("sines of alpha and kappa at 15 m/s", Between::linear, ordinary, 0.5L,
        [=](Real t) { return rolling(15, 0.1L * sine(5, t), 0.1L * sine(3, t)); });

    // Sines of alpha by wavelength at 20 m/s, sines of load
    for (const Real wavelength : {20.0L, 6.0L, 2.0L}) {
        add("alpha 0.05 over " + text(wavelength) + " m", Between::linear, ordinary, wavelength < 10 ? 0.5L : 1.0L,
            [=](Real t) { return rolling(20, 0, 0.05L * sine(20 / wavelength, t)); });
    }
    add("load with lift-off, alpha 0.05", Between::linear, ordinary, 0.6L,
        [=](Real t) { return rolling(20, 0, 0.05L, 3000 + 3500 * sine(5, t)); });

    // Camber, yaw rate
    Sample cambered = rolling(20, 0, 0), yawing = rolling(30, 0, 0);
    cambered.gamma = 0.05L;
    yawing.psidot = 0.5L;
    addStep("camber 0.05 at 20 m/s", ordinary, 0.2L, rolling(20, 0, 0), cambered);
    addStep("yaw rate 0.5 rad/s at 30 m/s", ordinary, 0.2L, rolling(30, 0, 0), yawing);

    // Standstill, start from rest, backwards, through zero
    Sample still, pushed, turned;
    pushed.Vsy = 0.02L;
    turned.Vsx = -0.05L;
    add("parked, pushed sideways for 50 ms", Between::hold, standstill, 0.3L,
        [=](Real t) { return t > 0.0195L && t < 0.0695L ? pushed : still; });
    addStep("wheel spun up at standstill", standstill, 0.2L, still, turned);
    add("start from rest", Between::linear, standstill, 0.6L, [](Real t) {
        Sample sample = rolling(3 * t, 0, 0.02L);
        sample.Vsx = -std::min(t / 0.02L, 1.0L) * 0.05L;
        return sample;
    });
    add("locked stop from 1 m/s", Between::linear, standstill, 0.4L,
        [](Real t) { return rolling(std::max(1 - 5 * t, 0.0L), -1, 0.05L); });
    addStep("backwards at 5 m/s, alpha 0.05", ordinary, 0.4L, rolling(-5, 0, 0), rolling(-5, -0.03L, 0.05L));
    add("through zero while drifting sideways", Between::linear, standstill, 1.0L, [](Real t) {
        Sample sample = rolling(1 - 2 * t, 0, 0);
        sample.Vsx = 0.01L;
        sample.Vsy = -0.02L;
        return sample;
    });
    return cases;
}

}  // namespace reference
