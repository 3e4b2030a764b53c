#include "tread/steering.h"

#include <cmath>

#include "base/math/delay_line.h"
#include "base/math/elementary.h"
#include "base/math/lag.h"
#include "vehicle/aligning_compliance.h"

namespace tread {
namespace {

// Speed over which the friction at the steering wheel builds up, for the torque that the driver feels.
constexpr double kFrictionSpeed = 0.01;  // rad/s

struct Mean {
    double angle;  // rad, mean road-wheel angle
    double slope;  // over the steering-wheel angle
};

Mean meanAngle(const SteeringParams& params, double hand) {
    if (params.ratio_curve.empty()) return {hand / params.ratio, 1 / params.ratio};
    const double size = std::abs(hand);
    const double ratio = params.ratio_curve(size);
    // Slope of the ratio, from the segment in which the angle lies.
    const auto& points = params.ratio_curve.points;
    double growth = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (size > points[i - 1].x && size <= points[i].x)
            growth = (points[i].y - points[i - 1].y) / (points[i].x - points[i - 1].x);
    }
    return {hand / ratio, (ratio - size * growth) / (ratio * ratio)};
}

// The turn centre lies on the rear axle's extension, wheelbase / tan(mean) to the left.
RoadWheels wheelsAt(const SteeringParams& params, double mean, double track, double wheelbase) {
    if (params.ackermann == 0) return {{mean, mean}, {1, 1}};
    const double slope = tangent(mean);
    const double offset = params.ackermann * 0.5 * track / wheelbase * slope;
    const auto perMean = [slope](double x) { return (1 + slope * slope) / (x * x + slope * slope); };
    return {{arctan(slope / (1 - offset)), arctan(slope / (1 + offset))}, {perMean(1 - offset), perMean(1 + offset)}};
}

RoadWheels wheelsAtSteeringWheel(const SteeringParams& params, double hand, double track, double wheelbase) {
    return wheelsAt(params, meanAngle(params, hand).angle, track, wheelbase);
}

double afterPlay(double angle, double play) {
    return angle - std::clamp(angle, -0.5 * play, 0.5 * play);
}

// The driver's angle after delay and lag.
double commanded(SteeringState& state, const SteeringParams& params, const SteeringInput& input, double dt) {
    const double before = params.delay > 0 ? state.delayed : input.begin;
    state.delayed = params.delay > 0 ? advance(state.delay, input.begin, input.end, params.delay, dt) : input.end;
    state.lagged = lagged(state.lagged, before, state.delayed, params.lag, dt);
    return state.lagged;
}

// Hands off: trapezoidal rule under the torque of the road in the middle of the step; dry friction takes what it can of
// the speed that this gives, so that it holds the wheel when it can.
void turnFreely(SteeringState& state, const SteeringParams& params, double torque, double dt) {
    const double damping = 0.5 * dt * params.damping / params.inertia;
    const double inverse = 1 / (1 + damping);
    const double rate = ((1 - damping) * state.rate + dt * torque / params.inertia) * inverse;
    const double friction = dt * params.friction / params.inertia * inverse;
    const double slowed = std::copysign(std::max(std::abs(rate) - friction, 0.0), rate);
    state.angle += 0.5 * dt * (state.rate + slowed);
    state.rate = slowed;
}

}  // namespace

RoadWheelAngles roadWheelAngles(const SteeringParams& params, double steering_wheel_angle, double track,
                                double wheelbase) {
    return wheelsAtSteeringWheel(params, steering_wheel_angle, track, wheelbase).angles;
}

SteeringState steadySteering(const SteeringParams& params, double steering_wheel_angle, double track,
                             double wheelbase) {
    SteeringState state;
    state.angle = state.delayed = state.lagged = steering_wheel_angle;
    state.delay.past.fill(steering_wheel_angle);
    state.wheels = wheelsAtSteeringWheel(params, afterPlay(steering_wheel_angle, params.play), track, wheelbase);
    return state;
}

SteeringMotion advance(SteeringState& state, const SteeringParams& params, const SteeringInput& input, double dt) {
    // Moment of the road about the steering axes, with the mean angle of the wheels.
    const double moment =
        input.left_moment * state.wheels.per_mean.left + input.right_moment * state.wheels.per_mean.right;
    const double moment_change = moment - state.moment;
    state.moment = moment;

    const bool held = !input.hands_off && !state.hands_off;
    const bool follows = params.delay == 0 && params.lag == 0;
    const bool yields = params.column_compliance != 0 || params.rack_compliance != 0;
    if (held && follows && params.play == 0 && !yields) {
        // Nothing lies between hands and wheels; as a rule these stand already where the step begins.
        const RoadWheelAngles begin = input.begin == state.angle
                                          ? state.wheels.angles
                                          : roadWheelAngles(params, input.begin, input.track, input.wheelbase);
        state.wheels = wheelsAtSteeringWheel(params, input.end, input.track, input.wheelbase);
        state.angle = input.end;
        state.rate = (input.end - input.begin) / dt;
        return {begin, state.wheels.angles};
    }

    // The steering wheel: where the driver holds it, or by itself.
    const double command = commanded(state, params, input, dt);
    if (input.hands_off) {
        const double slope = meanAngle(params, afterPlay(state.angle, params.play)).slope;
        turnFreely(state, params, slope * (moment + 0.5 * moment_change), dt);
    } else {
        state.rate = (command - state.angle) / dt;
        state.angle = command;
    }
    state.hands_off = input.hands_off;

    // From the steering wheel to the road wheels.
    Mean mean = meanAngle(params, afterPlay(state.angle, params.play));
    if (yields) {
        const double compliance = params.rack_compliance + params.column_compliance * mean.slope * mean.slope;
        mean.angle +=
            advance(state.yielding, compliance, {moment, input.aligning_stiffness, input.turning_resistance}, dt);
    }
    const RoadWheelAngles begin = state.wheels.angles;
    state.wheels = wheelsAt(params, mean.angle, input.track, input.wheelbase);
    return {begin, state.wheels.angles};
}

double steeringWheelTorque(const SteeringState& state, const SteeringParams& params, double left_moment,
                           double right_moment) {
    if (state.hands_off) return 0;
    const double slope = meanAngle(params, afterPlay(state.angle, params.play)).slope;
    const RoadWheelAngles& share = state.wheels.per_mean;
    double own = params.damping * state.rate;
    if (params.friction != 0) own += params.friction * hyperbolicTangent(state.rate / kFrictionSpeed);
    return own - slope * (left_moment * share.left + right_moment * share.right);
}

}  // namespace tread
