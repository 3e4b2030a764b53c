// The linear single-track model of a car, with what its suspension and steering do to the gradient: closed forms for
// the understeer gradient and for roll; and the steady turn that they are compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/vehicles.h"

namespace reference {

using namespace tread;

constexpr double kStep = 0.001;  // s
constexpr double kDegree = std::numbers::pi / 180;

// Turns the steering wheel smoothly to an angle, then holds angle and speed.
inline Car steadyTurn(const VehicleParams& params, const Road& road, double speed, double road_wheel_angle,
                      double duration) {
    Car car = settled(params, road, {.speed = speed});
    const double throttle = car.input.throttle;
    for (double t = 0; t < duration; t += kStep) {
        const double x = std::min(t / 1.0, 1.0);
        VehicleInput next = car.input;
        next.steering_wheel_angle = params.steering.ratio * road_wheel_angle * x * x * (3 - 2 * x);
        next.throttle = std::clamp(throttle + 0.5 * (speed - car.output().chassis.vx), 0.0, 1.0);
        car.step(next, kStep);
    }
    return car;
}

// ---- Roll and load transfer ----

// Left less right load of both axles, and the roll angle, for small lateral accelerations. Springs, bars and tyres in
// series; the links carry the force along the body's lateral axis (the weight has a share in it when the body leans)
// times the height of the roll centre. The spinning wheels roll the car outwards as it yaws.
struct Roll {
    double angle;                // rad
    PerAxle<double> difference;  // N, left less right
};

inline Roll rollAt(const VehicleParams& car, double lateral_acceleration) {
    const double weight = car.mass * kStandardGravity;
    double per_roll = weight * car.centre_of_gravity_height,
           constant = car.mass * lateral_acceleration * car.centre_of_gravity_height;
    PerAxle<double> by_roll, by_force;
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const AxleParams& a = axle == 0 ? car.front : car.rear;
        const double share =
            (axle == 0 ? car.wheelbase - car.front_axle_distance : car.front_axle_distance) / car.wheelbase;
        const double force = share * car.mass * lateral_acceleration;
        constant += 2 * a.wheel_inertia / a.tyre.parameters.Re * lateral_acceleration;
        const double rate = a.suspension.spring + 2 * a.suspension.anti_roll_bar;
        const double series = 1 + rate / a.tyre.parameters.pz1;
        // A wheel that leans against the body moves its contact sideways.
        const double radius = a.tyre.parameters.Ro - 0.5 * share * weight / a.tyre.parameters.pz1;
        per_roll += share * weight * radius * a.suspension.camber_by_travel * 0.5 * a.track / series;
        by_roll[axle] = -(rate * a.track + 2 * a.suspension.roll_centre_height * share * weight / a.track) / series;
        by_force[axle] = -2 * a.suspension.roll_centre_height * force / a.track / series;
        per_roll += 0.5 * a.track * by_roll[axle];
        constant += 0.5 * a.track * by_force[axle];
    }
    const double angle = -constant / per_roll;
    return {angle, {by_roll.front * angle + by_force.front, by_roll.rear * angle + by_force.rear}};
}

// ---- The linear single-track model ----

// Both wheels of an axle together, per unit of slip angle, of camber (top outwards in the turn), and of load that goes
// from right to left: static toe, camber and ply-steer of the two wheels cancel only while their loads are equal.
struct AxleModel {
    double stiffness;      // N/rad
    double trail;          // m, of the force behind the axle
    double camber_force;   // N/rad, outwards
    double camber_moment;  // N m/rad, turning outwards
    double load_force;     // -, to the left, over left less right load
    double load_moment;    // m, turning to the left
};

inline AxleModel axleModel(const VehicleParams& car, std::size_t axle) {
    const AxleParams& a = axle == 0 ? car.front : car.rear;
    const double share =
        (axle == 0 ? car.wheelbase - car.front_axle_distance : car.front_axle_distance) / car.wheelbase;
    const double load = 0.5 * share * car.mass * kStandardGravity;
    constexpr double kSmall = 1e-4;  // rad
    AxleModel model{};
    double moment = 0;
    for (const bool left : {true, false}) {
        const TyreParams tyre = left ? a.tyre : tread::mirrored(a.tyre);
        const WheelAngles rest = angles(a.suspension, 0, left);
        // Slip of a wheel that goes straight on while it points by its toe to the left: Vsy (to the right) of the
        // ground point along the wheel's own axis is V sin(toe).
        const auto at = [&](double slip, double camber, double extra = 0) {
            const double angle = rest.toe + slip;
            return steadyState(tyre, {.Fz = load + extra,
                                      .gamma = rest.camber + camber,
                                      .Vx = 20 * std::cos(angle),
                                      .Vsx = 0,
                                      .Vsy = 20 * std::sin(angle)});
        };
        const TyreSteadyState more = at(kSmall, 0), less = at(-kSmall, 0);
        model.stiffness += -(more.Fy - less.Fy) / (2 * kSmall);  // to the left, positive
        moment += -(more.Mz - less.Mz) / (2 * kSmall);           // about the vertical up, positive to the left
        const TyreSteadyState leant = at(0, kSmall), upright = at(0, -kSmall);
        model.camber_force += (leant.Fy - upright.Fy) / (2 * kSmall);  // to the right: outwards in a left turn
        model.camber_moment += (leant.Mz - upright.Mz) / (2 * kSmall);
        const TyreSteadyState heavy = at(0, 0, 1), light = at(0, 0, -1);
        model.load_force += (left ? 0.5 : -0.5) * -(heavy.Fy - light.Fy) / 2;
        model.load_moment += (left ? 0.5 : -0.5) * -(heavy.Mz - light.Mz) / 2;
    }
    model.trail = -moment / model.stiffness;
    return model;
}

struct SingleTrack {
    double understeer;  // rad s2/m: steer angle beyond L / R over lateral acceleration
    AxleModel front, rear;
};

inline SingleTrack singleTrack(const VehicleParams& car) {
    const AxleModel f = axleModel(car, 0), r = axleModel(car, 1);
    const Roll roll = rollAt(car, 1);
    const double a = car.front_axle_distance, b = car.wheelbase - a;
    // Camber against the road: roll, and travel that leans (and steers) the wheels of both sides the same way.
    const auto attitude = [&](const AxleParams& axle, double difference) {
        const double travel =
            0.5 * (axle.track * roll.angle + difference / axle.tyre.parameters.pz1);  // of the outer wheel
        return std::pair{roll.angle + axle.suspension.camber_by_travel * travel,
                         axle.suspension.toe_by_travel * travel};
    };
    const auto [lean_f, toe_f] = attitude(car.front, roll.difference.front);
    const auto [lean_r, toe_r] = attitude(car.rear, roll.difference.rear);
    const SuspensionParams &front = car.front.suspension, &rear = car.rear.suspension;

    // Forces of the axles per m/s2: their sum is m, their moments about the centre of gravity cancel with those of the
    // trails, of camber and of the loads. Each wheel of an axle has half its force, which leans it (compliance camber):
    // a weak dependence, found by iteration.
    double camber_f = lean_f, camber_r = lean_r, force_f = 0, force_r = 0, moment_f = 0, moment_r = 0;
    for (int i = 0; i < 10; ++i) {
        // The trail moves only the force that comes from slip; what camber and load give has its moment besides.
        const double constant_f = f.camber_force * camber_f - f.load_force * roll.difference.front;
        const double constant_r = r.camber_force * camber_r - r.load_force * roll.difference.rear;
        const double besides_f = f.load_moment * roll.difference.front - f.camber_moment * camber_f;
        const double besides_r = r.load_moment * roll.difference.rear - r.camber_moment * camber_r;
        const double twist = besides_f + besides_r - f.trail * constant_f - r.trail * constant_r;
        force_f = (car.mass * (b + r.trail) - twist) / (a - f.trail + b + r.trail);
        force_r = car.mass - force_f;
        moment_f = besides_f - f.trail * (force_f + constant_f);
        moment_r = besides_r - r.trail * (force_r + constant_r);
        camber_f = lean_f + 0.5 * front.camber_by_lateral_force * force_f;
        camber_r = lean_r + 0.5 * rear.camber_by_lateral_force * force_r;
    }
    const auto slip = [](const AxleModel& axle, double force, double camber, double difference) {
        return (force + axle.camber_force * camber - axle.load_force * difference) / axle.stiffness;
    };
    const double slip_f = slip(f, force_f, camber_f, roll.difference.front);
    const double slip_r = slip(r, force_r, camber_r, roll.difference.rear);

    // Steering that the forces cause: of each wheel by its own, of both front wheels by column and rack.
    const auto complied = [](const SuspensionParams& s, double force, double moment) {
        return 0.5 * (s.steer_by_lateral_force * force + s.steer_by_aligning_moment * moment);
    };
    const SteeringParams& steering = car.steering;
    const double yields = steering.rack_compliance + steering.column_compliance / (steering.ratio * steering.ratio);
    const double steer_f =
        toe_f + complied(front, force_f, moment_f) + yields * (moment_f - steering.caster_trail * force_f);
    const double steer_r = toe_r + complied(rear, force_r, moment_r);
    return {slip_f - slip_r - steer_f + steer_r, f, r};
}

}  // namespace reference
