// How a foreign log becomes a tread log: the content of a mapping file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/channel_names.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

// One channel: value = sign * scale * (foreign value in SI units) / rolling_radius + offset, read `delay` later. With a
// curve, its value over the foreign value in place of that value.
struct ImportChannel {
    std::string channel;
    std::string from;
    std::vector<std::string> mean_with;
    std::string unit;
    std::string time;
    int sign = 1;
    Curve curve{};
    double scale = 1;
    std::optional<double> rolling_radius;
    double offset = 0;
    double zero_over = 0;
    double delay = 0;
    bool spikes = true;

    static constexpr void describe(auto& self, auto&& field) {
        field(
            TREAD_FIELD(channel),
            About{"", "name in the log: chassis.ay, chassis.ay@can of a further instrument, or another of that form"});
        field(TREAD_FIELD(from), About{"", "name of the foreign column"});
        field(TREAD_FIELD(mean_with), About{"", "further foreign columns: the channel is the mean of all"});
        field(TREAD_FIELD(unit), About{"", "unit of the foreign values; none: what the file says"});
        field(TREAD_FIELD(time), About{"", "foreign column with this channel's own time, when it has one"});
        field(TREAD_FIELD(sign),
              About{"-", "-1 reverses the sign: z down, y right, steering positive to the right", Limits{-1, 1}});
        field(TREAD_FIELD(curve), About{"unit of the channel",
                                        "characteristic of a sensor or an actuator: value versus the foreign value in "
                                        "SI units, plain numbers; constant beyond its ends",
                                        kAny, 0, "SI unit of the foreign values"});
        field(TREAD_FIELD(scale), About{"-", "factor: sensor gain, steering ratio"});
        field(TREAD_FIELD(rolling_radius), About{"m", "the spin is the wheel speed divided by this", kPositive});
        field(TREAD_FIELD(offset), About{"unit of the channel", "added last; a plain number"});
        field(TREAD_FIELD(zero_over),
              About{"s", "the mean over this initial part is subtracted; 0: none", kNonNegative});
        field(TREAD_FIELD(delay), About{"s", "delay of the foreign channel, which is removed", Limits{-10, 10}});
        field(TREAD_FIELD(spikes), About{"", "false: spikes of this channel are kept"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.channel.empty()) complain("channel", "found no name; write the channel that the column becomes");
        if (const std::string fault = misspelling(self.channel); !fault.empty()) complain("channel", fault);
        if (self.from.empty()) complain("from", "found no name; write the foreign column");
        if (self.sign == 0) complain("sign", "found 0, expected 1 or -1");
    }
};
static_assert(describesEveryMember<ImportChannel>());

enum class TimeFormat { seconds, hhmmss };
constexpr auto enumNames(TimeFormat) {
    return std::array<std::string_view, 2>{"seconds", "hhmmss"};
}

struct ImportTime {
    std::string from;
    std::string unit;
    TimeFormat format = TimeFormat::seconds;
    std::optional<double> rate;
    double begin = 0;
    std::optional<double> end;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(from), About{"", "name of the time column; none: the file has a fixed rate"});
        field(TREAD_FIELD(unit), About{"", "unit of its values; none: what the file says, or s"});
        field(TREAD_FIELD(format), About{"", "seconds (or its unit), or hhmmss: 105317.85 is 10:53:17.85"});
        field(TREAD_FIELD(rate), About{"Hz", "sampling rate of a file without time column", kPositive});
        field(TREAD_FIELD(begin),
              About{"s", "everything before this is cut off; counted from the first sample", kNonNegative});
        field(TREAD_FIELD(end),
              About{"s", "everything after this is cut off; counted from the first sample", kPositive});
    }
    static void check(const auto& self, auto&& complain) {
        if (!self.from.empty() && self.rate) complain("rate", "found a rate beside a time column; give one of them");
        if (self.end && *self.end <= self.begin) complain("end", "found an end that is not after the beginning");
    }
};
static_assert(describesEveryMember<ImportTime>());

enum class AtJump { longest, split, refuse };
constexpr auto enumNames(AtJump) {
    return std::array<std::string_view, 3>{"longest", "split", "refuse"};
}

struct ImportRepairs {
    double max_jump = 1;
    AtJump at_jump = AtJump::longest;
    bool fill_gaps = true;
    bool spikes = true;
    double spike_limit = 12;
    std::optional<double> rate;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(max_jump),
              About{"s", "a longer time step, or a step back, begins another recording", kPositive});
        field(TREAD_FIELD(at_jump), About{"", "longest recording kept; split: one log each; refuse: a fault"});
        field(TREAD_FIELD(fill_gaps),
              About{"", "values that are missing for no longer than max_jump are interpolated"});
        field(TREAD_FIELD(spikes),
              About{"",
                    "spikes are interpolated: jumps within one sample that no car can do, and back, of any length; "
                    "shorter than three samples, what is far above the noise"});
        field(TREAD_FIELD(spike_limit),
              About{"-", "height of a spike in robust standard deviations of the change per sample", kPositive});
        field(TREAD_FIELD(rate), About{"Hz", "sampling rate of the log; none: that of the file", kPositive});
    }
};
static_assert(describesEveryMember<ImportRepairs>());

struct ImportConstant {
    std::string channel;
    double value = kRequired;
    std::string unit;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(channel), About{"", "name in the log"});
        field(TREAD_FIELD(value), About{"its unit", "value at every time"});
        field(TREAD_FIELD(unit), About{"", "unit of the value; none: that of the channel"});
    }
    static void check(const auto& self, auto&& complain) {
        if (const std::string fault = misspelling(self.channel); !fault.empty()) complain("channel", fault);
    }
};
static_assert(describesEveryMember<ImportConstant>());

struct ImportMap {
    std::string source;
    ImportTime time;
    std::vector<ImportChannel> map;
    std::vector<ImportConstant> constants;
    ImportRepairs repairs;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(source), About{"", "what kind of file this is for, in words"});
        field(TREAD_FIELD(time), About{"", "time base of the file"});
        field(TREAD_FIELD(map), About{"", "channels of the log, each from a column of the file"});
        field(TREAD_FIELD(constants), About{"", "channels that the file lacks and that are constant"});
        field(TREAD_FIELD(repairs), About{"", "what is repaired; each repair is reported"});
    }
};
static_assert(describesEveryMember<ImportMap>());

}  // namespace tread
