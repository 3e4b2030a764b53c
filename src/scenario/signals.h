// What a driver's foot or hand does over the time of one phase of a manoeuvre.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "scenario/closed_loop.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

struct Angle {
    static constexpr std::string_view kUnit = "rad";
    static constexpr std::string_view kRate = "rad/s";
    static constexpr Limits kLimits = kAny;
    static constexpr Usual kUsual{-20, 20, true};        // three turns to either side: trucks
    static constexpr Usual kUsualRate{0.001, 50, true};  // a robot's 2000 deg/s, and some more
};
struct Pedal {
    static constexpr std::string_view kUnit = "-";
    static constexpr std::string_view kRate = "1/s";
    static constexpr Limits kLimits = kFraction;
    static constexpr Usual kUsual{-1, 1, true};
    static constexpr Usual kUsualRate{0.001, 1000, true};  // the stroke in 1 ms is as good as at once
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
        field(TREAD_FIELD(value), About{Of::kUnit, "value", Of::kLimits}.usually(Of::kUsual));
    }
};

// From where it is to a value, at a rate: a step as a driver or a steering machine can do it.
template <class Of>
struct Ramp {
    static constexpr std::string_view kName = "ramp";
    double to = kRequired;
    double rate = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(to), About{Of::kUnit, "value at the end", Of::kLimits}.usually(Of::kUsual));
        field(TREAD_FIELD(rate), About{Of::kRate, "rate of change", kPositive}.usually(Of::kUsualRate));
    }
};

// From where it is to a multiple of that: the reversal of a fishhook, the way back to straight ahead.
template <class Of>
struct Rescale {
    static constexpr std::string_view kName = "rescale";
    double factor = kRequired;
    std::optional<double> rate = {};
    std::optional<double> duration = {};
    static constexpr void describe(auto& self, auto&& field) {
        field(
            TREAD_FIELD(factor),
            About{"-", "value at the end over that at the start of the phase, -1: to the other side"}.usually(-20, 20));
        field(TREAD_FIELD(rate), About{Of::kRate, "rate of change", kPositive}.usually(Of::kUsualRate));
        field(TREAD_FIELD(duration),
              About{"s", "in place of the rate: time that it takes", kPositive}.usually(0.001, 1000));
    }
    static void check(const auto& self, auto&& complain) {
        if (self.rate.has_value() == self.duration.has_value())
            complain("rate", "expected either a rate or a duration, to know how quickly the value changes");
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
        field(TREAD_FIELD(amplitude), About{Of::kUnit, "amplitude"}.usually(Of::kUsual));
        field(TREAD_FIELD(frequency), About{"1/s", "frequency", kPositive}.usually(0.01, 20));
        field(TREAD_FIELD(cycles),
              About{"-", "number of periods; then it stays where it began", {0, kInfinity, true}}.usually(0.1, 1000));
    }
};

// One period about where it is, that waits at its second peak: the steering of FMVSS 126 and ISO 19365.
template <class Of>
struct SineWithDwell {
    static constexpr std::string_view kName = "sine_with_dwell";
    double amplitude = kRequired;
    double frequency = kRequired;
    double dwell = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(amplitude), About{Of::kUnit, "amplitude"}.usually(Of::kUsual));
        field(TREAD_FIELD(frequency), About{"1/s", "frequency of the sine", kPositive}.usually(0.01, 20));
        field(TREAD_FIELD(dwell), About{"s", "pause at three quarters of the period", kNonNegative}.usually(0, 10));
    }
};

enum class SweepLaw { linear, logarithmic };
constexpr auto enumNames(SweepLaw) {
    return std::array<std::string_view, 2>{"linear", "logarithmic"};
}

// A sine whose frequency changes with time: by as many hertz, or by the same factor, in every second.
template <class Of>
struct Sweep {
    static constexpr std::string_view kName = "sweep";
    double amplitude = kRequired;
    double from = kRequired;
    double to = kRequired;
    double duration = kRequired;
    SweepLaw law = SweepLaw::linear;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(amplitude), About{Of::kUnit, "amplitude"}.usually(Of::kUsual));
        field(TREAD_FIELD(from), About{"1/s", "frequency at the start", kNonNegative}.usually(0.001, 50));
        field(TREAD_FIELD(to), About{"1/s", "frequency at the end", kPositive}.usually(0.001, 50));
        field(TREAD_FIELD(duration),
              About{"s", "time from the first to the last frequency", kPositive}.usually(0.1, 3600));
        field(TREAD_FIELD(law), About{"", "how the frequency changes over time"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.law == SweepLaw::logarithmic && self.from <= 0)
            complain("from", "found 0, expected more than 0: a logarithmic sweep never leaves a frequency of zero");
    }
};

// A triangle: up to the amplitude and back, in equal times.
template <class Of>
struct Pulse {
    static constexpr std::string_view kName = "pulse";
    double amplitude = kRequired;
    double duration = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(amplitude), About{Of::kUnit, "height"}.usually(Of::kUsual));
        field(TREAD_FIELD(duration), About{"s", "width at the foot", kPositive}.usually(0.001, 60));
    }
};

// Band-limited noise about where it is: sines of equal amplitude and random phase, one at a random place in each of
// as many equal parts of the band. It does not repeat, and comes out the same from the same seed on every machine.
template <class Of>
struct Noise {
    static constexpr std::string_view kName = "random";
    double rms = kRequired;
    double from = kRequired;
    double to = kRequired;
    int lines = 120;
    int seed = 1;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(rms), About{Of::kUnit, "root mean square", kNonNegative}.usually(Of::kUsual));
        field(TREAD_FIELD(from), About{"1/s", "lowest frequency", kNonNegative}.usually(0.001, 50));
        field(TREAD_FIELD(to), About{"1/s", "highest frequency", kPositive}.usually(0.001, 50));
        field(TREAD_FIELD(lines), About{"-", "number of sines", {1, 10000}});
        field(TREAD_FIELD(seed),
              About{"-", "another seed gives another signal of the same kind", kNonNegative}.unjudged());
    }
    static void check(const auto& self, auto&& complain) {
        if (self.from >= self.to) complain("from", "the lowest frequency must be below the highest (from < to)");
    }
};

template <class Of>
struct Table {
    static constexpr std::string_view kName = "table";
    Curve points;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(points), About{Of::kUnit, "value over the time of the phase", Of::kLimits, 0, "s"}
                                       .usually(Of::kUsual)
                                       .over(0, 36000));
    }
};

// What was logged: in a simulation or, imported, in a car.
template <class Of>
struct Replay {
    static constexpr std::string_view kName = "replay";
    std::string file;
    std::string channel;
    double from = 0;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(file),
              About{"", "log (CSV), relative to the scenario's file; none: the drive that the scenario repeats"});
        field(TREAD_FIELD(channel), About{"", "channel of the log; its unit must be that of the signal"});
        field(TREAD_FIELD(from), About{"s", "time in the log at which the phase begins"}.unjudged());
    }
    static void check(const auto& self, auto&& complain) {
        if (self.channel.empty()) complain("channel", "found no channel, expected the name of one in the log");
    }
};

// Hands off: the steering wheel turns by itself; the next phase begins where it then is.
struct HandsOff {
    static constexpr std::string_view kName = "hands_off";
    static constexpr void describe(auto&, auto&&) {}
};

using SteeringSignal = std::variant<Keep, Constant<Angle>, Ramp<Angle>, Sine<Angle>, SineWithDwell<Angle>, Sweep<Angle>,
                                    Pulse<Angle>, Noise<Angle>, Table<Angle>, Replay<Angle>, HoldLateralAcceleration,
                                    HoldRadius, FollowPath, HandsOff, Rescale<Angle>>;
using PedalSignal = std::variant<Keep, Constant<Pedal>, Ramp<Pedal>, Table<Pedal>, Replay<Pedal>>;
using ThrottleSignal = std::variant<Keep, Constant<Pedal>, Ramp<Pedal>, Table<Pedal>, Replay<Pedal>, HoldSpeed,
                                    FollowSpeed, CommandedForce, FollowCourse>;

// True where a force replaces throttle and brake pedal.
inline bool commandsForce(const ThrottleSignal& signal) {
    return std::holds_alternative<FollowSpeed>(signal) || std::holds_alternative<CommandedForce>(signal);
}

// Value `elapsed` seconds into the phase, for a signal that was at `held` when the phase began. What watches the car,
// and HandsOff, is no function of time, and a Replay must have been read (replay.h): they answer `held`.
double valueAt(const SteeringSignal& signal, double held, double elapsed);
double valueAt(const PedalSignal& signal, double held, double elapsed);
double valueAt(const ThrottleSignal& signal, double held, double elapsed);

// Time that the signal takes to come to its end, s: infinite for what goes on for ever or watches the car.
double lengthOf(const SteeringSignal& signal, double held);

}  // namespace tread
