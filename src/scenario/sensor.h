// How a channel is observed: a sensor with its mounting and its faults, by default a perfect one.
#pragma once

#include <string>

#include "tread/describe.h"

namespace tread {

struct SensorPosition {
    double x = 0, y = 0, z = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "forward of the centre of gravity"}.usually(-10, 10));
        field(TREAD_FIELD(y), About{"m", "left of the centre of gravity"}.usually(-3, 3));
        field(TREAD_FIELD(z), About{"m", "above the centre of gravity"}.usually(-4, 4));
    }
};
static_assert(describesEveryMember<SensorPosition>());

// Yaw, then pitch, then roll, each about the axis as the one before has turned it.
struct SensorMisalignment {
    double roll = 0, pitch = 0, yaw = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(roll), About{"rad", "positive with the right side down"}.usually(-0.8, 0.8));
        field(TREAD_FIELD(pitch), About{"rad", "positive with the nose down"}.usually(-0.8, 0.8));
        field(TREAD_FIELD(yaw), About{"rad", "positive to the left"}.usually(-3.2, 3.2));
    }
};
static_assert(describesEveryMember<SensorMisalignment>());

// The channel's own axes are level: x horizontal along the heading. A sensor that is fixed to the body, or misaligned,
// has others. An accelerometer feels gravity as an upward acceleration: when its axes are not level, that leaks into
// the horizontal ones; the 1 g that it reads upward when level is taken off. In this order: place and axes, low pass,
// delay, gain, bias, noise, quantisation.
struct SensorParams {
    std::string channel;
    std::string name;
    SensorPosition position;
    bool fixed_to_body = false;
    SensorMisalignment misalignment;
    double low_pass = kInfinity;
    double delay = 0;
    double gain = 1;
    double bias = 0;
    double noise = 0;
    double resolution = 0;
    int seed = 1;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(channel), About{"", "name of the channel that it observes"});
        field(TREAD_FIELD(name), About{"", "it is logged as sensor.<name>; none: the channel's"});
        field(TREAD_FIELD(position),
              About{"", "where it sits, for position, velocities and accelerations of the chassis"});
        field(TREAD_FIELD(fixed_to_body),
              About{"",
                    "rolls and pitches with the body instead of staying level (velocities, accelerations and "
                    "angular velocities of the chassis)"});
        field(TREAD_FIELD(misalignment), About{"", "of its axes, for the same channels"});
        field(TREAD_FIELD(low_pass),
              About{"1/s", "corner frequency of its second-order Butterworth filter (cycles per second)", kPositive}
                  .usually(0.05, 1e5));
        field(TREAD_FIELD(delay), About{"s", "delay of its reading", {0, 10}});
        field(TREAD_FIELD(gain), About{"-", "reading over value"}.usually(-5, 5));
        field(TREAD_FIELD(bias), About{"-", "reading at zero, in the SI unit of the channel"}.unjudged());
        field(TREAD_FIELD(noise),
              About{"-", "standard deviation of each logged reading, in the SI unit of the channel", kNonNegative}
                  .unjudged());
        field(TREAD_FIELD(resolution),
              About{"-", "smallest step of its reading, in the SI unit of the channel; 0: none", kNonNegative}
                  .unjudged());
        field(TREAD_FIELD(seed), About{"", "of the noise", {0, 2147483647}});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.channel.empty()) complain("channel", "found no channel, expected the name of one, e.g. chassis.ay");
    }

    const std::string& loggedName() const { return name.empty() ? channel : name; }
};
static_assert(describesEveryMember<SensorParams>());

}  // namespace tread
