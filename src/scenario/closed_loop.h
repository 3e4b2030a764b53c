// Drivers that watch the car: what they hold, and how briskly.
#pragma once

#include <string_view>

#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

// Throttle, and brake when it has a gain, by a speed controller (proportional and integral).
struct HoldSpeed {
    static constexpr std::string_view kName = "hold_speed";
    double speed = 0;
    double proportional = 0.15;
    double integral = 0.05;
    double brake = 0;
    Curve profile = {};
    bool as_driven = false;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(speed),
              About{"m/s", "speed to hold; 0: that at the start of the phase", kNonNegative}.usually(0, 70));
        field(TREAD_FIELD(proportional), About{"s/m", "throttle over the speed error", kNonNegative}.usually(0, 10));
        field(TREAD_FIELD(integral),
              About{"1/m", "throttle over the integral of the speed error", kNonNegative}.usually(0, 10));
        field(TREAD_FIELD(brake),
              About{"-", "brake pedal over the negative throttle that the controller demands; 0: never brakes",
                    kNonNegative}
                  .usually(0, 20));
        field(TREAD_FIELD(profile),
              About{"m/s", "speed to hold over the time of the phase, in place of `speed`", kNonNegative, 0, "s"}
                  .usually(0, 70)
                  .over(0, 36000));
        field(TREAD_FIELD(as_driven), About{"", "holds the speed of the drive that the scenario repeats (drive)"});
    }
};

// Throttle and brake pedal of a driver who knows the speed of the course ahead: a controller of the speed that is
// missing a little ahead, and the pedals for the acceleration that the course asks there.
struct FollowCourse {
    static constexpr std::string_view kName = "follow_course";
    double preview_time = 0.3;
    double proportional = 0.3;
    double integral = 0.05;
    double acceleration = 0.1;
    double brake = 1;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(preview_time),
              About{"s", "how far ahead the driver reads the speed", kNonNegative}.usually(0.01, 10));
        field(TREAD_FIELD(proportional), About{"s/m", "pedal over the speed error", kNonNegative}.usually(0.001, 20));
        field(TREAD_FIELD(integral),
              About{"1/m", "throttle over the integral of the speed error", kNonNegative}.usually(0.0001, 20));
        field(TREAD_FIELD(acceleration),
              About{"s2/m", "pedal over the acceleration of the course", kNonNegative}.usually(0.001, 5));
        field(TREAD_FIELD(brake),
              About{"-", "brake pedal over the throttle below zero", kNonNegative}.usually(0.01, 20));
    }
};

// Follows a speed as exactly as the grip allows, by a commanded force in place of throttle and brake pedal: what
// engine, gearbox and brakes can do does not limit it.
struct FollowSpeed {
    static constexpr std::string_view kName = "follow_speed";
    Curve profile;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(profile),
              About{"m/s", "speed over the time of the phase", kNonNegative, 0, "s"}.usually(0, 70).over(0, 36000));
    }
    static void check(const auto& self, auto&& complain) {
        if (self.profile.empty()) complain("profile", "found no speed, expected the speed over time");
    }
};

// A longitudinal force of all tyres together in place of throttle and brake pedal, as an automated car commands it.
// Above zero it acts at the driven wheels, below zero at the brakes.
struct CommandedForce {
    static constexpr std::string_view kName = "force";
    Curve points;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(points),
              About{"N", "force over the time of the phase, positive forward", kAny, 0, "s"}.usually(-2e5, 2e5).over(
                  0, 36000));
    }
    static void check(const auto& self, auto&& complain) {
        if (self.points.empty()) complain("points", "found no force, expected the force over time");
    }
};

// Steering wheel by an integral controller of the path's curvature. The wheel turns at
//     bandwidth * steering ratio * wheelbase * (curvature wanted - curvature driven),
// so that a neutral car closes in on the target with the time constant 1 / bandwidth.
struct HoldLateralAcceleration {
    static constexpr std::string_view kName = "hold_lateral_acceleration";
    double target = kRequired;
    double bandwidth = 1;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(target), About{"m/s2", "lateral acceleration, positive to the left"}.usually(-30, 30));
        field(TREAD_FIELD(bandwidth), About{"1/s", "how quickly the driver corrects", kPositive}.usually(0.01, 20));
    }
};

struct HoldRadius {
    static constexpr std::string_view kName = "hold_radius";
    double radius = kRequired;
    double bandwidth = 1;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(radius),
              About{"m", "radius of the path of the centre of gravity, positive to the left"}.usually(-1e4, 1e4));
        field(TREAD_FIELD(bandwidth), About{"1/s", "how quickly the driver corrects", kPositive}.usually(0.01, 20));
    }
    static void check(const auto& self, auto&& complain) {
        if (self.radius == 0) complain("radius", "found 0, expected a radius, positive to the left");
    }
};

// Steering wheel by a driver who looks ahead on the path of the course and steers for the arc that leads there from the
// present direction of travel (pure pursuit; Coulter, Carnegie Mellon CMU-RI-TR-92-01, 1992). The angle for an arc is
// that of a car of the given understeer gradient; hand and eye lag behind.
struct FollowPath {
    static constexpr std::string_view kName = "follow_path";
    double preview_time = 0.6;
    double preview_distance = 4;
    double gain = 1;
    double lead = 0;
    double understeer = 0.0025;
    double delay = 0.05;
    double lag = 0.05;
    double largest_rate = 17;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(preview_time), About{"s", "how far ahead the driver looks", kPositive}.usually(0.05, 5));
        field(TREAD_FIELD(preview_distance),
              About{"m", "the same at low speed: never nearer than this", kPositive}.usually(0.1, 100));
        field(TREAD_FIELD(gain),
              About{"-", "steering-wheel angle over the one that the arc needs", kPositive}.usually(0.1, 5));
        field(TREAD_FIELD(lead),
              About{"-", "share of the remaining curvature error that the driver adds to the steering", kNonNegative}
                  .usually(0, 5));
        field(
            TREAD_FIELD(understeer),
            About{"rad s2/m", "understeer gradient, at the road wheels, that the driver assumes"}.usually(-0.02, 0.02));
        field(TREAD_FIELD(delay), About{"s", "dead time between eye and hand", {0, 2}});
        field(TREAD_FIELD(lag), About{"s", "time constant of arms and steering wheel", kNonNegative}.usually(0, 2));
        field(TREAD_FIELD(largest_rate),
              About{"rad/s", "fastest turn of the steering wheel", kPositive}.usually(0.5, 40));
    }
};

}  // namespace tread
