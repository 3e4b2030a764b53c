// Steering: from the driver's hands to the two front wheels, and the torque that comes back.
//
// The driver's angle reaches the steering wheel late (delay and lag); from there play, ratio and the compliance of
// column and rack lie in the way to the wheels. Hands off, the steering wheel turns by itself under the moments of the
// tyres.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "tread/api.h"
#include "tread/curve.h"
#include "tread/describe.h"
#include "tread/state_parts.h"

namespace tread {

struct SteeringParams {
    double ratio = kRequired;
    Curve ratio_curve{};
    double ackermann = 0;
    double delay = 0;
    double lag = 0;
    double play = 0;
    double column_compliance = 0;
    double rack_compliance = 0;
    double caster_trail = 0;
    double scrub_radius = 0;
    double inertia = 0.05;
    double damping = 0;
    double friction = 0;

    static constexpr double kLongestDelay = 0.2;  // s

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(ratio),
              About{"-", "steering-wheel angle over mean road-wheel angle", kPositive, 0.02}.usually(0.5, 40));
        field(TREAD_FIELD(ratio_curve),
              About{"-", "steering ratio versus steering-wheel angle, the same to both sides, in place of ratio",
                    kPositive, 0.02, "rad"}
                  .usually(0.5, 40)
                  .over(0, 20));
        field(TREAD_FIELD(ackermann),
              About{"-", "0: wheels parallel, 1: both wheels tangent to circles about the rear axle's extension", kAny,
                    0.2}
                  .usually(-2, 3));
        field(TREAD_FIELD(delay),
              About{"s", "delay of the steering wheel behind the driver's angle", {0, kLongestDelay}});
        field(
            TREAD_FIELD(lag),
            About{"s", "time constant with which the steering wheel follows the driver's angle", kNonNegative}.usually(
                0, 0.5));
        field(TREAD_FIELD(play),
              About{"rad", "angle at the steering wheel, about the centre, over which the wheels do not follow",
                    kNonNegative}
                  .usually(0, 0.7));
        field(
            TREAD_FIELD(column_compliance),
            About{"rad/(N m)", "twist of the column over the torque at the steering wheel", kNonNegative, 0.3}.usually(
                0, 0.5));
        field(TREAD_FIELD(rack_compliance),
              About{"rad/(N m)", "rotation of both road wheels over the sum of their moments, beyond the column",
                    kNonNegative, 0.3}
                  .usually(0, 0.1));
        field(TREAD_FIELD(caster_trail),
              About{"m", "distance of the contact centre behind the steering axis, for the moments", kAny, 0.2}.usually(
                  -0.1, 0.2));
        field(
            TREAD_FIELD(scrub_radius),
            About{"m", "distance of the contact centre outside the steering axis, for the moments"}.usually(-0.3, 0.3));
        field(TREAD_FIELD(inertia),
              About{"kg m2", "inertia of the whole steering at the steering wheel, for hands off", kPositive, 0.3}
                  .usually(1e-6, 5));
        field(TREAD_FIELD(damping),
              About{"N m s/rad", "damping at the steering wheel", kNonNegative, 0.3}.usually(0, 20));
        field(TREAD_FIELD(friction),
              About{"N m", "dry friction at the steering wheel", kNonNegative, 0.3}.usually(0, 20));
    }

    static void check(const auto& self, auto&& complain) {
        const auto& points = self.ratio_curve.points;
        if (!points.empty() && points.front().x < 0)
            complain("ratio_curve",
                     "found a negative steering-wheel angle, expected 0 and above: it counts to either side");
        // The road-wheel angle h / r(h) must grow with h: r > h dr/dh.
        for (std::size_t i = 1; i < points.size(); ++i) {
            const auto &a = points[i - 1], &b = points[i];
            const double slope = (b.y - a.y) / (b.x - a.x);
            if (b.y - b.x * slope <= 0) {
                complain("ratio_curve",
                         "the ratio grows so fast with the angle that the road wheels would turn back; expected that "
                         "angle over ratio grows from point to point");
                return;
            }
        }
    }
};
static_assert(describesEveryMember<SteeringParams>());

// ---- Geometry ----

struct RoadWheelAngles {
    double left = 0;   // rad, positive to the left
    double right = 0;  // rad
};

// The road wheels, and how far each turns over their mean angle.
struct RoadWheels {
    RoadWheelAngles angles;
    RoadWheelAngles per_mean{1, 1};  // -
};

// Road-wheel angles at a steering-wheel angle, without toe. Track and wheelbase in m.
TREAD_API RoadWheelAngles roadWheelAngles(const SteeringParams& params, double steering_wheel_angle, double track,
                                          double wheelbase);

// ---- Motion ----

struct SteeringState {
    double angle = 0;        // rad, of the steering wheel
    double rate = 0;         // rad/s
    double delayed = 0;      // rad, the driver's angle after its delay
    double lagged = 0;       // rad, and after its lag
    bool hands_off = false;  // in the last step
    RoadWheels wheels;       // at the end of the last step
    AligningCompliance yielding;
    double moment = 0;  // N m, of both wheels, with which the last step began
    DelayLine delay;
};

// At rest with the steering wheel held at an angle.
TREAD_API SteeringState steadySteering(const SteeringParams& params, double steering_wheel_angle, double track,
                                       double wheelbase);

struct SteeringInput {
    double begin;  // rad, the driver's angle at both ends of the step
    double end;
    bool hands_off;
    double track;        // m
    double wheelbase;    // m
    double left_moment;  // N m, about the steering axes at the beginning of the step, positive to the left
    double right_moment;
    double aligning_stiffness;  // N m/rad, by which about the sum of these moments falls with the road-wheel angle
    double turning_resistance;  // N m s/rad, by which at most about it falls at once with the rate of that angle
};

// Angles of the road wheels at both ends of the step.
struct SteeringMotion {
    RoadWheelAngles begin;
    RoadWheelAngles end;
};
TREAD_API SteeringMotion advance(SteeringState& state, const SteeringParams& params, const SteeringInput& input,
                                 double dt);

// ---- Moments ----

// Moment of the road about the steering axis of a wheel, N m, from the forces in ISO 8855 wheel axes.
inline double steeringMoment(const SteeringParams& params, double fx, double fy, double mz, bool left) {
    return mz - params.caster_trail * fy - (left ? params.scrub_radius : -params.scrub_radius) * fx;
}

// Torque by which the driver turns the steering wheel, N m, positive to the left; without what accelerates it. The
// moments are those of steeringMoment.
TREAD_API double steeringWheelTorque(const SteeringState& state, const SteeringParams& params, double left_moment,
                                     double right_moment);

}  // namespace tread
