#include "sheet/driven_turn.h"

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "road/plane.h"
#include "tread/equilibrium.h"

namespace tread::sheet {
namespace {

constexpr double kStep = 0.001;   // s
constexpr double kTurning = 1;    // s, in which the steering wheel is turned
constexpr double kSettling = 3;   // s, after that
constexpr double kWatched = 0.5;  // s, at the end, in which nothing may change any more
constexpr double kSteady = 0.02;  // largest relative change of the yaw rate in that time
constexpr double kHold = 0.5;     // s/m, throttle over speed that is missing

struct Turn {
    double ay, curvature, roll;
};

struct Drive {
    Vehicle vehicle;
    PlaneRoad road{};
    ChassisMotion motion{};
    VehicleState state{};
    VehicleInput input{};

    VehicleOutput output() const { return observe(motion, state, vehicle, Surroundings{road}.gravity_W); }
    void step(const VehicleInput& next) {
        advance(motion, state, vehicle, input, next, {road}, kStep);
        input = next;
    }
};

Turn turn(const Vehicle& vehicle, const Equilibrium& start, double speed, double steering_wheel) {
    Drive drive{.vehicle = vehicle, .motion = start.motion, .state = start.state, .input = start.input};
    const double straight = start.input.steering_wheel_angle;
    double before = 0;
    for (double t = 0; t < kTurning + kSettling; t += kStep) {
        const double x = std::min(t / kTurning, 1.0);
        VehicleInput next = drive.input;
        next.steering_wheel_angle = straight + steering_wheel * x * x * (3 - 2 * x);
        const VehicleOutput now = drive.output();
        next.throttle = std::clamp(start.throttle + kHold * (speed - now.chassis.vx), 0.0, 1.0);
        if (t < kTurning + kSettling - kWatched) before = now.chassis.yaw_rate;
        drive.step(next);
    }
    const auto& c = drive.output().chassis;
    if (!(std::abs(c.yaw_rate - before) < kSteady * std::abs(c.yaw_rate))) return {kUndefined, kUndefined, kUndefined};
    return {c.ay, c.yaw_rate / c.vx, c.roll};
}

}  // namespace

DrivenTurn drivenTurn(const VehicleParams& params, double speed, double road_wheel_angle) {
    VehicleParams car = params;
    car.steering.play = car.steering.delay = car.steering.lag = 0;
    const double ratio = car.steering.ratio_curve.empty() ? car.steering.ratio : car.steering.ratio_curve(0);
    const Vehicle vehicle = prepare(car);
    const PlaneRoad road;
    const Equilibrium start = equilibrium(vehicle, {road}, {.speed = speed});
    if (start.throttle > 1) return {kUndefined, kUndefined};
    const Turn left = turn(vehicle, start, speed, ratio * road_wheel_angle);
    const Turn right = turn(vehicle, start, speed, -ratio * road_wheel_angle);
    const double ay = left.ay - right.ay;
    return {(2 * road_wheel_angle - car.wheelbase * (left.curvature - right.curvature)) / ay,
            (left.roll - right.roll) / ay};
}

}  // namespace tread::sheet
