// What a driver's foot or hand does over the time of one phase of a manoeuvre.
#pragma once

#include <string_view>
#include <variant>

#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

struct Angle {
    static constexpr std::string_view kUnit = "rad";
    static constexpr std::string_view kRate = "rad/s";
    static constexpr Limits kLimits = kAny;
};
struct Pedal {
    static constexpr std::string_view kUnit = "-";
    static constexpr std::string_view kRate = "1/s";
    static constexpr Limits kLimits = kFraction;
};

// Stays where the phase before left it.
struct Keep {
    static constexpr std::string_view kName = "keep";
    bool operator==(const Keep&) const = default;
    static constexpr void describe(auto&, auto&&) {}
};

template <class Of>
struct Constant {
    static constexpr std::string_view kName = "constant";
    double value = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(value), About{Of::kUnit, "value", Of::kLimits});
    }
};

// From where it is to a value, at a rate: a step as a driver or a steering machine can do it.
template <class Of>
struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    double rate = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(to), About{Of::kUnit, "value at the end", Of::kLimits});
        field(TREAD_FIELD(rate), About{Of::kRate, "rate of change", kPositive});
    }
};

// About where it is.
template <class Of>
struct Sine {
    static constexpr std::string_view kName = "sine";
    double amplitude = kRequired;
    double frequency = kRequired;
    double cycles = kInfinity;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(amplitude), About{Of::kUnit, "amplitude"});
        field(TREAD_FIELD(frequency), About{"1/s", "frequency", kPositive});
        field(TREAD_FIELD(cycles), About{"-", "number of periods; then it stays where it began", {0, kInfinity, true}});
    }
};

// A sine whose frequency rises linearly with time.
template <class Of>
struct Sweep {
    static constexpr std::string_view kName = "sweep";
    double amplitude = kRequired;
    double from = kRequired;
    double to = kRequired;
    double duration = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(amplitude), About{Of::kUnit, "amplitude"});
        field(TREAD_FIELD(from), About{"1/s", "frequency at the start", kNonNegative});
        field(TREAD_FIELD(to), About{"1/s", "frequency at the end", kPositive});
        field(TREAD_FIELD(duration), About{"s", "time from the first to the last frequency", kPositive});
    }
};

template <class Of>
struct Table {
    static constexpr std::string_view kName = "table";
    Curve points;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(points), About{Of::kUnit, "value over the time of the phase", Of::kLimits, 0, "s"});
    }
};

// Throttle by a speed controller (proportional and integral).
struct HoldSpeed {
    static constexpr std::string_view kName = "hold_speed";
    double speed = 0;
    double proportional = 0.15;
    double integral = 0.05;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(speed), About{"m/s", "speed to hold; 0: that at the start of the phase", kNonNegative});
        field(TREAD_FIELD(proportional), About{"s/m", "throttle over the speed that is missing", kNonNegative});
        field(TREAD_FIELD(integral),
              About{"1/m", "throttle over the integral of the speed that is missing", kNonNegative});
    }
};

// Hands off: the hand wheel turns by itself; the next phase begins where it then is.
struct HandsOff {
    static constexpr std::string_view kName = "hands_off";
    static constexpr void describe(auto&, auto&&) {}
};

using SteeringSignal =
    std::variant<Keep, Constant<Angle>, Ramp<Angle>, Sine<Angle>, Sweep<Angle>, Table<Angle>, HandsOff>;
using PedalSignal = std::variant<Keep, Constant<Pedal>, Ramp<Pedal>, Table<Pedal>>;
using ThrottleSignal = std::variant<Keep, Constant<Pedal>, Ramp<Pedal>, Table<Pedal>, HoldSpeed>;

// Value `elapsed` seconds into the phase, for a signal that was at `held` when the phase began. HoldSpeed and HandsOff
// are no functions of time: they answer `held`.
double valueAt(const SteeringSignal& signal, double held, double elapsed);
double valueAt(const PedalSignal& signal, double held, double elapsed);
double valueAt(const ThrottleSignal& signal, double held, double elapsed);

}  // namespace tread
