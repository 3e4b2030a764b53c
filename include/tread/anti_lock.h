// Anti-lock braking: holds the slip of every braked wheel where the tyre grips best.
//
// A wheel whose slip passes an upper threshold has its pressure dumped until it comes back, held until its slip has
// fallen below a lower threshold, and built up again slowly: the three phases of a solenoid valve, several times a
// second. The controller knows the wheel's speed over ground; a real one estimates it.
#pragma once

#include <algorithm>

#include "tread/api.h"
#include "tread/describe.h"
#include "tread/wheels.h"

namespace tread {

struct AntiLockParams {
    bool enabled = false;
    double authority_offset = 0;
    double period = 0.005;
    double dump_slip = 0.12;
    double build_slip = 0.10;
    double dump_rate = 6e7;
    double build_rate = 1.5e7;
    double lowest_speed = 2;
    bool select_low = true;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(enabled), About{"", "true: the car has this control"});
        field(TREAD_FIELD(authority_offset),
              About{"-",
                    "offset of the share of its intervention that reaches the brakes: 1 when enabled, else 0",
                    {-1, 1}});
        field(TREAD_FIELD(period), About{"s", "sample period of the controller", kPositive}.usually(1e-4, 0.1));
        field(TREAD_FIELD(dump_slip), About{"-", "slip above which pressure is released", {0, 1, true, true}});
        field(TREAD_FIELD(build_slip), About{"-", "slip below which pressure is built up again", {0, 1, true, true}});
        field(TREAD_FIELD(dump_rate),
              About{"Pa/s", "rate of pressure decrease during release", kPositive}.usually(1e5, 1e9));
        field(TREAD_FIELD(build_rate),
              About{"Pa/s", "rate of pressure increase during build-up", kPositive}.usually(1e5, 1e9));
        field(TREAD_FIELD(lowest_speed),
              About{"m/s", "speed below which the wheels may lock, because the slip is meaningless there", kNonNegative}
                  .usually(0, 5));
        field(TREAD_FIELD(select_low),
              About{"", "both rear wheels get the pressure of the wheel with less grip, for stability (select low)"});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.build_slip > self.dump_slip) complain("build_slip", "must not be larger than dump_slip");
    }
};
static_assert(describesEveryMember<AntiLockParams>());

// Share of its intervention that reaches the brakes; 0: it does not act.
inline double authority(const AntiLockParams& params) {
    return std::clamp((params.enabled ? 1.0 : 0.0) + params.authority_offset, 0.0, 1.0);
}

struct AntiLockState {
    enum class Phase { idle, dump, hold, build };
    struct Wheel {
        Phase phase = Phase::idle;
        double slip = 0;      // at the last sample
        double pressure = 0;  // Pa, to which the valve limits the wheel; not used when idle
    };
    PerWheel<Wheel> wheels;
    double since_sample = 1;  // s: the first step samples
};

// Pressure of each wheel, of what the driver and the stability control ask for. `speed` is that of the wheel over
// ground along its heading, `rolling` the spin times the effective rolling radius.
TREAD_API PerWheel<double> advance(AntiLockState& state, const AntiLockParams& params, const PerWheel<double>& demand,
                                   const PerWheel<double>& speed, const PerWheel<double>& rolling, double dt);

TREAD_API int regulatedWheels(const AntiLockState& state);

}  // namespace tread
