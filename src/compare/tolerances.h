// How far two logs may lie apart and still count as the same: the content of a tolerance file.
//
// A difference is allowed up to `absolute + relative * peak`, peak being the largest magnitude of the reference
// channel. The defaults are for regression: the same car and manoeuvre before and after a change of the program. They
// let through what another compiler or step size changes in a converged run, and nothing that a driver or a sensor
// could notice.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/quantity.h"
#include "log/log.h"
#include "tread/describe.h"

namespace tread {

// Below this difference channels of a unit are the same, however small their peak is (a straight stop has a yaw rate of
// 1e-9 rad/s, and another 1e-9 is no news).
struct UnitTolerance {
    std::string unit;
    Quantity absolute = kRequired;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(unit), About{"", "unit of a channel, as in its header"});
        field(TREAD_FIELD(absolute), About{"unit of the channel", "difference that is always allowed", kNonNegative});
    }

    static void check(const auto& self, auto&& complain) {
        std::string fault;
        if (!self.absolute.in(self.unit, fault)) complain("absolute", fault);
    }
};
static_assert(describesEveryMember<UnitTolerance>());

// About a tenth of what a good sensor of that kind resolves.
inline std::vector<UnitTolerance> defaultUnitTolerances() {
    return {{"-", 1e-4},      {"m", 1e-3},  {"m/s", 1e-3}, {"m/s2", 5e-3}, {"rad", 1e-4}, {"rad/s", 1e-4},
            {"rad/s2", 5e-3}, {"N", 1.0},   {"N m", 0.1},  {"W", 10.0},    {"Pa", 100.0}, {"K", 0.05},
            {"degC", 0.05},   {"kg", 1e-3}, {"J", 1.0},    {"V", 1e-3},    {"A", 1e-2}};
}

struct ChannelTolerance {
    std::string channel;               // "chassis.ay"; `*` stands for any characters: "wheel.*.load"
    std::optional<Quantity> absolute;  // unless given: that of the unit
    std::optional<double> relative;    // unless given: that of the whole file
    bool ignore = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(channel), About{"", "name, or pattern with `*` for any characters; the last match applies"});
        field(TREAD_FIELD(absolute), About{"unit of the channel", "allowed difference", kNonNegative});
        field(TREAD_FIELD(relative),
              About{"-", "allowed difference as a fraction of the reference's peak", kNonNegative});
        field(TREAD_FIELD(ignore), About{"", "true: the channel is not compared"});
    }
};
static_assert(describesEveryMember<ChannelTolerance>());

// Of a metric, when folders of runs are compared.
struct MetricTolerance {
    std::string metric;                // "stopping_distance"; `*` stands for any characters
    std::optional<Quantity> absolute;  // unless given: that of the unit
    std::optional<double> relative;    // unless given: that of the whole file
    bool ignore = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(metric), About{"", "name, or pattern with `*` for any characters; the last match applies"});
        field(TREAD_FIELD(absolute), About{"unit of the metric", "allowed difference", kNonNegative});
        field(TREAD_FIELD(relative),
              About{"-", "allowed difference as a fraction of the reference's magnitude", kNonNegative});
        field(TREAD_FIELD(ignore), About{"", "true: the metric is not compared"});
    }
};
static_assert(describesEveryMember<MetricTolerance>());

struct Tolerances {
    double relative = 0.005;
    std::vector<UnitTolerance> units = defaultUnitTolerances();
    std::vector<ChannelTolerance> channels;
    std::vector<MetricTolerance> metrics = {};
    double time_span = 0.1;
    double time_shift_max = 0;
    std::string time_shift_channel = "chassis.yaw_rate";

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(relative),
              About{"-", "allowed difference as a fraction of the reference's peak", kNonNegative});
        field(TREAD_FIELD(units), About{"", "differences that are always allowed, by unit"});
        field(TREAD_FIELD(channels), About{"", "channels with tolerances of their own"});
        field(TREAD_FIELD(metrics),
              About{"", "metrics with tolerances of their own, when folders of runs are compared"});
        field(TREAD_FIELD(time_span),
              About{"s", "largest difference between the starts, and between the ends, of the two logs", kNonNegative});
        field(TREAD_FIELD(time_shift_max),
              About{"s", "largest constant delay between the logs that is found and removed; 0: none", kNonNegative});
        field(TREAD_FIELD(time_shift_channel), About{"", "channel from which the delay is found"});
    }
};
static_assert(describesEveryMember<Tolerances>());

struct AllowedDifference {
    double absolute;
    double relative;
    bool ignore;
};
AllowedDifference allowedDifference(const Tolerances& tolerances, const Channel& channel);
// Of a metric in a unit.
AllowedDifference allowedDifference(const Tolerances& tolerances, std::string_view metric, std::string_view unit);

// Tolerances with a unit that measures something else than the channel or metric that they fit.
struct ToleranceFault {
    std::string path;  // "channels.1.absolute"
    std::string text;
};
std::vector<ToleranceFault> unitFaults(const Tolerances& tolerances, const Log& reference);
// The last tolerance of a metric, if it has the wrong unit.
std::optional<ToleranceFault> unitFault(const Tolerances& tolerances, std::string_view metric, std::string_view unit);

}  // namespace tread
