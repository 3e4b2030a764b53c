// Suspension of one axle: forces along the wheel travel, and the kinematics that steer and lean the wheel.
// All rates are at the wheel. Travel is positive in compression and zero where the car stands at its static load.
#pragma once

#include "tread/api.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

struct DamperParams {
    double bump = kRequired;
    double rebound = kRequired;
    Curve bump_curve{};
    Curve rebound_curve{};
    double friction = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(bump), About{"N s/m", "damping in compression", kNonNegative, 0.1}.usually(0.5, 1e5));
        field(TREAD_FIELD(rebound), About{"N s/m", "damping in extension", kNonNegative, 0.1}.usually(0.5, 1e5));
        field(TREAD_FIELD(bump_curve), About{"N",
                                             "force over the speed of compression, in place of bump; goes on beyond "
                                             "its last point with its last slope",
                                             kNonNegative, 0.1, "m/s"}
                                           .usually(0, 1e5)
                                           .over(0, 10));
        field(TREAD_FIELD(rebound_curve), About{"N",
                                                "force over the speed of extension, in place of rebound; goes on "
                                                "beyond its last point with its last slope",
                                                kNonNegative, 0.1, "m/s"}
                                              .usually(0, 1e5)
                                              .over(0, 10));
        field(TREAD_FIELD(friction), About{"N", "dry friction", kNonNegative, 0.3}.usually(0, 5000));
    }

    static void check(const auto& self, auto&& complain) {
        checkFromZero(self.bump_curve, "bump_curve", complain);
        checkFromZero(self.rebound_curve, "rebound_curve", complain);
    }

private:
    static void checkFromZero(const Curve& curve, const char* name, auto&& complain) {
        if (curve.empty()) return;
        const Curve::Point& first = curve.points.front();
        if (first.x != 0 || first.y != 0 || curve.points.size() < 2)
            complain(name,
                     "expected a curve of two points or more that begins at [0, 0]: a damper at rest gives no force");
    }
};
static_assert(describesEveryMember<DamperParams>());

// A stop that the suspension meets after some travel: force = stiffness x + progression x^2.
template <class T>
struct BasicStopParams {
    T clearance = 1;
    T stiffness = 0;
    T progression = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(clearance),
              About{"m", "travel from the static position to the stop", kNonNegative}.usually(0.0005, 1));
        field(TREAD_FIELD(stiffness),
              About{"N/m", "stiffness at first contact with the stop", kNonNegative, 0.3}.usually(100, 1e7));
        field(TREAD_FIELD(progression),
              About{"N/m2", "increase of the force with deflection squared", kNonNegative, 0.3}.usually(0, 1e10));
    }
};
using StopParams = BasicStopParams<double>;
static_assert(describesEveryMember<StopParams>());

struct SuspensionParams {
    double spring = kRequired;
    Curve spring_curve{};
    DamperParams damper;
    double anti_roll_bar = 0;
    StopParams bump_stop;
    StopParams rebound_stop;
    double roll_centre_height = 0;
    double side_view_slope_braking = 0;
    double side_view_slope_driving = 0;
    double camber = 0;
    double camber_by_travel = 0;
    double toe = 0;
    double toe_by_travel = 0;
    double steer_by_lateral_force = 0;
    double steer_by_aligning_moment = 0;
    double steer_by_longitudinal_force = 0;
    double camber_by_lateral_force = 0;
    double longitudinal_compliance = 0;
    double longitudinal_damping = 1000;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(spring), About{"N/m", "spring rate at the wheel", kPositive, 0.05}.usually(100, 2e6));
        field(TREAD_FIELD(spring_curve), About{"N",
                                               "spring force beyond the static one over compression, in place of "
                                               "spring; goes on beyond its ends with their slopes",
                                               kAny, 0.05, "m"}
                                             .usually(-1e6, 1e6)
                                             .over(-1, 1));
        field(TREAD_FIELD(damper), About{"", "damper"});
        field(TREAD_FIELD(anti_roll_bar),
              About{"N/m", "anti-roll bar: force per wheel over the difference of left and right travel", kNonNegative,
                    0.1}
                  .usually(10, 1e6));
        field(TREAD_FIELD(bump_stop), About{"", "stop in compression"});
        field(TREAD_FIELD(rebound_stop), About{"", "stop in extension"});
        field(TREAD_FIELD(roll_centre_height),
              About{"m", "height of the roll centre above the road", kAny, 0.2}.usually(-0.5, 1.2));
        field(TREAD_FIELD(side_view_slope_braking), About{"-",
                                                          "forward movement of the contact point over compression, "
                                                          "brake locked to the hub (anti-dive, anti-lift)",
                                                          kAny, 0.3}
                                                        .usually(-1, 1));
        field(
            TREAD_FIELD(side_view_slope_driving),
            About{"-", "forward movement of the wheel centre over compression (anti-squat)", kAny, 0.3}.usually(-1, 1));
        field(TREAD_FIELD(camber),
              About{"rad", "static camber, positive when the top leans outwards"}.usually(-0.2, 0.2));
        field(TREAD_FIELD(camber_by_travel),
              About{"rad/m", "change of camber over compression", kAny, 0.2}.usually(-10, 10));
        field(TREAD_FIELD(toe), About{"rad", "static toe of each wheel, positive toe-in"}.usually(-0.1, 0.1));
        field(TREAD_FIELD(toe_by_travel), About{"rad/m", "change of toe over compression", kAny, 0.2}.usually(-3, 3));
        field(
            TREAD_FIELD(steer_by_lateral_force),
            About{"rad/N", "compliance steer of a wheel by its lateral force; negative understeers in front", kAny, 0.2}
                .usually(-0.005, 0.005));
        field(TREAD_FIELD(steer_by_aligning_moment),
              About{"rad/(N m)", "compliance steer of a wheel by its aligning moment", kNonNegative}.usually(0, 0.5));
        field(TREAD_FIELD(steer_by_longitudinal_force),
              About{"rad/N", "toe-in of a wheel by its longitudinal force, positive when driving toes in"}.usually(
                  -0.005, 0.005));
        field(TREAD_FIELD(camber_by_lateral_force),
              About{"rad/N", "compliance camber of a wheel by its lateral force, positive when the top leans away"}
                  .usually(-0.005, 0.005));
        field(
            TREAD_FIELD(longitudinal_compliance),
            About{"m/N", "recession of a wheel against the body by its longitudinal force", kNonNegative, 0.3}.usually(
                0, 0.001));
        field(TREAD_FIELD(longitudinal_damping),
              About{"N s/m", "damping of that recession; without effect on a rigid suspension", kNonNegative, 0.5}
                  .usually(0.1, 1e5));
    }

    static void check(const auto& self, auto&& complain) {
        const auto& points = self.spring_curve.points;
        if (points.empty()) return;
        if (points.size() < 2 || points.front().x > 0 || points.back().x < 0)
            complain("spring_curve", "expected two points or more, about the static position at travel 0");
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (points[i].y <= points[i - 1].y) {
                complain("spring_curve", "expected a force that grows with compression from point to point");
                return;
            }
        }
    }
};
static_assert(describesEveryMember<SuspensionParams>());

template <class T>
struct BasicSuspensionInput {
    T travel;           // m
    T rate;             // m/s
    T opposite_travel;  // m, of the other wheel of the axle
    T static_force;     // N, spring force at zero travel
};
using SuspensionInput = BasicSuspensionInput<double>;

// Force that pushes the wheel down and the body up, and its slopes for the implicit wheel equation.
template <class T>
struct BasicSuspensionForce {
    T force;
    T by_travel;  // N/m
    T by_rate;    // N s/m
};
using SuspensionForce = BasicSuspensionForce<double>;

TREAD_API SuspensionForce forces(const SuspensionParams& params, const SuspensionInput& input);

// Attitude of a wheel against the body. The sides of the car mirror each other.
template <class T>
struct BasicWheelAngles {
    T camber;  // rad, rotation about +x: positive leans the top to the right
    T toe;     // rad, rotation about +z: positive steers to the left
};
using WheelAngles = BasicWheelAngles<double>;

TREAD_API WheelAngles angles(const SuspensionParams& params, double travel, bool left);

// What the forces of the road on a wheel, ISO 8855 wheel axes, add to that through the compliance of the suspension;
// not what the aligning moment adds, which is AligningCompliance's.
TREAD_API WheelAngles compliance(const SuspensionParams& params, double fx, double fy, bool left);

// Longitudinal movement of a wheel against the body.
template <class T>
struct BasicRecession {
    T travel = 0;        // m, positive forward
    T rate = 0;          // m/s
    T acceleration = 0;  // m/s2
    T push = 0;          // m/s2: force of the road over the wheel's mass, less the body's acceleration there
};
using Recession = BasicRecession<double>;

// Advances it by dt under the push with which the last step ended. SDIRK2: second order, L-stable, so that a hard bush
// does not ring.
TREAD_API void advance(Recession& recession, const SuspensionParams& params, double mass, double dt);

// The wheel moved under the push of the step's beginning and takes the change to that of its end.
TREAD_API void takePush(Recession& recession, const SuspensionParams& params, double mass, double push, double dt);

}  // namespace tread
