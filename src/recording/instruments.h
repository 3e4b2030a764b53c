// Instruments of a measured car: one per group of channels, and further ones of the same quantities.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tread/describe.h"

namespace tread::recording {

// Model of one channel: delayed by `delay`, then reading = gain * value + bias.
struct Instrument {
    double gain = 1;
    double bias = 0;
    double delay = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(gain), About{"-", "reading divided by the true value"});
        field(TREAD_FIELD(bias), About{"-", "reading at a true value of zero, in the SI unit of the channel"});
        field(TREAD_FIELD(delay), About{"s", "delay of the reading", {-1, 1}});
    }
};
static_assert(describesEveryMember<Instrument>());

// Position and misalignment of the inertial unit.
struct InertialUnit {
    double x = 0, y = 0, z = 0;
    double roll = 0, pitch = 0, yaw = 0;
    double fixed_to_body = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "position forward of the centre of gravity"});
        field(TREAD_FIELD(y), About{"m", "position left of the centre of gravity"});
        field(TREAD_FIELD(z), About{"m", "position above the centre of gravity"});
        field(TREAD_FIELD(roll), About{"rad", "roll misalignment, positive with the right side down"});
        field(TREAD_FIELD(pitch), About{"rad", "pitch misalignment, positive with the nose down"});
        field(TREAD_FIELD(yaw), About{"rad", "yaw misalignment, positive when turned to the left"});
        field(TREAD_FIELD(fixed_to_body),
              About{"-",
                    "share of the gravity through roll and pitch of the body that the accelerometers read: 1 if fixed "
                    "to the body, 0 if level or corrected",
                    kFraction});
    }
};
static_assert(describesEveryMember<InertialUnit>());

// How a recorded command becomes a force at the tyres: delayed by `delay`, then force = gain * command + bias, which
// follows with the time constant `lag`. The same for driving and braking.
struct ForceActuator {
    double gain = 1;
    double bias = 0;
    double delay = 0;
    double lag = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(gain), About{"-", "force divided by the commanded force"});
        field(TREAD_FIELD(bias), About{"N", "force at a command of zero"});
        field(TREAD_FIELD(delay), About{"s", "delay between command and force", {-1, 1}});
        field(TREAD_FIELD(lag), About{"s", "time constant with which the force follows", kNonNegative});
    }
};
static_assert(describesEveryMember<ForceActuator>());

// A further instrument of a quantity. Its channel bears the word for its source behind @: chassis.yaw_rate@can.
struct FurtherInstrument {
    std::string channel;
    Instrument instrument;

    std::string_view pathName() const { return channel; }

    // Its numbers have the paths of those of any instrument.
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(channel), About{"", "channel with its source after @: chassis.yaw_rate@can"});
        Instrument::describe(self.instrument, field);
    }
};

// Position and misalignment of the further instruments of one source; of a measured position: of the tracked point.
struct Mounting {
    std::string source;
    InertialUnit unit;

    std::string_view pathName() const { return source; }

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(source), About{"", "source after @ in its channels, e.g. can"});
        InertialUnit::describe(self.unit, field);
    }
};

// Point of the car to which the recorded motion refers when a load is added to the nominal car. Instruments are fixed
// to the body; a simulator may compute its channels at the centre of gravity, which the load moves.
enum class ReadAt { body, centre_of_gravity };
constexpr auto enumNames(ReadAt) {
    return std::array<std::string_view, 2>{"body", "centre_of_gravity"};
}

struct Instruments {
    double latency = 0;
    ReadAt read_at = ReadAt::body;
    InertialUnit inertial_unit;
    Instrument ax, ay, yaw_rate, roll_rate, roll, speed, sideslip, wheel_speed;
    Instrument steering_wheel_angle;  // used in reverse: the replayed input is computed from the recorded one
    Instrument throttle, brake;
    ForceActuator command;
    std::vector<FurtherInstrument> further;
    std::vector<Mounting> mountings;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(latency), About{"s", "delay common to all readings, in addition to their own", {-1, 1}});
        field(TREAD_FIELD(read_at),
              About{"",
                    "body: at the centre of gravity of the nominal car, whatever load is added (instruments); "
                    "centre_of_gravity: at that of the car with the load (channels of a simulator)"});
        field(TREAD_FIELD(inertial_unit), About{"", "position and misalignment of the accelerometers"});
        field(TREAD_FIELD(ax), About{"", "longitudinal acceleration"});
        field(TREAD_FIELD(ay), About{"", "lateral acceleration"});
        field(TREAD_FIELD(yaw_rate), About{"", "yaw rate"});
        field(TREAD_FIELD(roll_rate), About{"", "roll rate"});
        field(TREAD_FIELD(roll), About{"", "roll angle"});
        field(TREAD_FIELD(speed), About{"", "forward speed over ground"});
        field(TREAD_FIELD(sideslip), About{"", "sideslip angle, or lateral velocity"});
        field(TREAD_FIELD(wheel_speed), About{"", "rotational speeds of the four wheels"});
        field(TREAD_FIELD(steering_wheel_angle), About{"", "recorded steering-wheel angle, an input of the replay"});
        field(TREAD_FIELD(throttle), About{"", "recorded throttle pedal position, an input of the replay"});
        field(TREAD_FIELD(brake), About{"", "recorded brake pedal position, an input of the replay"});
        field(TREAD_FIELD(command), About{"", "from the recorded command to the force, an input of the replay"});
        field(TREAD_FIELD(further), About{"", "further instruments of the same quantities"});
        field(TREAD_FIELD(mountings), About{"", "position and misalignment of the further instruments by source"});
    }
};
static_assert(describesEveryMember<Instruments>());

}  // namespace tread::recording
