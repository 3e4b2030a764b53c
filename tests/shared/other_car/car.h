// Another car simulator: a double-track model that shares nothing with tread, for cases in which the structure of the
// model that is diagnosed with is itself not that of the car.
//
// After R. Rajamani, Vehicle Dynamics and Control, 2nd ed. (2012), chapters 2, 4, 13 and 15, and M. Mitschke, H.
// Wallentowitz, Dynamik der Kraftfahrzeuge, 4th ed. (2004): a rigid body that moves in the plane, pitches, and rolls
// about an axis fixed in it, four spinning wheels with slip that relaxes, loads shifted as springs and links take them.
// Left out: heave, vertical wheel motion, twist of the shafts, moments of the tyres but for the trail. Plane road,
// steady wind. ISO 8855 axes. Classical Runge-Kutta of fourth order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/other_car/params.h"
#include "shared/other_car/state.h"

namespace other_car {

inline constexpr double kGravity = 9.80665;  // m/s2

struct Forces {
    std::array<double, 4> fx, fy, load;
    double ax = 0, ay = 0;            // m/s2, of the motion
    double felt_ax = 0, felt_ay = 0;  // less what gravity does along a road that is not level: what leans the body
    Vector rate{};
};

class Car {
public:
    Car(const Params& params, double speed) : p_(params) {
        s_[kVx] = speed;
        for (int i = 0; i < 4; ++i) s_[kSpin + i] = speed / axle(i).tyre.rolling_radius;
    }

    // Throttle that holds the speed in a straight line on a level road in still air.
    double holdingThrottle() const {
        const double v = s_[kVx], engine = p_.drive_ratio * s_[kSpin];
        const double rolling = p_.mass * kGravity * p_.front.tyre.rolling_resistance;
        const double need = (rolling + 0.5 * p_.air_density * p_.drag_area * v * v) * p_.front.tyre.loaded_radius;
        const double drag = p_.drag_scale * valueAt(p_.drive_drag, engine);
        const double full = p_.drive_scale * valueAt(p_.drive_full, engine);
        return (need / (p_.drive_ratio * p_.drive_efficiency) + drag) / (full + drag);
    }

    void step(const Input& begin, const Input& end, double dt) {
        const Input middle{0.5 * (begin.hand_wheel + end.hand_wheel), 0.5 * (begin.throttle + end.throttle),
                           0.5 * (begin.brake + end.brake)};
        const Vector a = at(s_, begin).rate;
        const Vector b = at(moved(a, dt / 2), middle).rate;
        const Vector c = at(moved(b, dt / 2), middle).rate;
        const Vector d = at(moved(c, dt), end).rate;
        for (int i = 0; i < kStates; ++i) s_[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }

    // Outside forces at the centre of gravity, held over the next steps.
    void push(double fx, double fy, double yaw_moment, double roll_moment = 0) {
        push_ = {fx, fy, yaw_moment, roll_moment};
    }

    const Vector& state() const { return s_; }
    // Of the body against the horizon.
    double roll() const { return s_[kRoll] + slope(s_).y; }
    Forces forces(const Input& input) const { return at(s_, input); }

private:
    Vector moved(const Vector& rate, double dt) const {
        Vector next = s_;
        for (int i = 0; i < kStates; ++i) next[i] += dt * rate[i];
        return next;
    }

    // Loads follow from accelerations, and these from forces at those loads: three rounds are enough to 1e-4.
    Forces at(const Vector& s, const Input& input) const {
        Forces f{};
        for (int round = 0; round < 3; ++round) {
            load(s, input, f);
            move(s, input, f);
        }
        return f;
    }

    // Rise of the road over run, along the car and across it.
    struct Slope {
        double x, y;
    };
    Slope slope(const Vector& s) const {
        const double c = std::cos(s[kYaw]), n = std::sin(s[kYaw]);
        return {c * p_.grade + n * p_.bank, -n * p_.grade + c * p_.bank};
    }

    double rearDistance() const { return p_.wheelbase - p_.front_distance; }
    // What rolls, and the height of its centre of gravity over the roll axis.
    struct Body {
        double mass, arm, inertia;
    };
    Body body() const {
        Body b{p_.mass, p_.mass * p_.height, p_.roll_inertia};
        for (const Axle* a : {&p_.front, &p_.rear}) {
            b.mass -= 2 * a->unsprung_mass;
            b.arm -= 2 * a->unsprung_mass * a->tyre.loaded_radius;
        }
        const double height = b.arm / b.mass;
        for (const Axle* a : {&p_.front, &p_.rear}) {
            const double lower = p_.height - a->tyre.loaded_radius;
            b.inertia -= 2 * a->unsprung_mass * (0.25 * a->track * a->track + lower * lower);
        }
        b.inertia -= b.mass * (height - p_.height) * (height - p_.height);
        b.arm = height - (p_.front.roll_axis * rearDistance() + p_.rear.roll_axis * p_.front_distance) / p_.wheelbase;
        return b;
    }
    const Axle& axle(int wheel) const { return wheel < 2 ? p_.front : p_.rear; }

    // The air's velocity against the car, in its axes.
    std::array<double, 2> air(const Vector& s) const {
        const double c = std::cos(s[kYaw]), n = std::sin(s[kYaw]);
        return {c * p_.wind_x + n * p_.wind_y - s[kVx], -n * p_.wind_x + c * p_.wind_y - s[kVy]};
    }

    double brakeTorque(bool front, const Vector& s, const Input& input) const {  // N m, of an axle
        const double pedal = p_.brake_lag > 0 ? s[kBrake] : input.brake;
        return (front ? p_.brake_front_share : 1 - p_.brake_front_share) * pedal * p_.brake_torque;
    }

    // Of the links, that hold the nose up when the brakes pull.
    double linkMoment(const Vector& s, const Input& input) const {
        const Axle &front = p_.front, &rear = p_.rear;
        return p_.front_distance * front.brake_support * brakeTorque(true, s, input) / front.tyre.loaded_radius +
               rearDistance() * rear.brake_support * brakeTorque(false, s, input) / rear.tyre.loaded_radius;
    }

    // Of springs and dampers, for a nose that is down.
    double pitchMoment(const Vector& s) const {
        const double lf = p_.front_distance, lr = rearDistance();
        const double stiffness = lf * lf * p_.front.pitchRate() + lr * lr * p_.rear.pitchRate();
        const double damping = lf * lf * p_.front.pitchDamping() + lr * lr * p_.rear.pitchDamping();
        return stiffness * s[kPitch] + damping * s[kPitchRate];
    }

    void load(const Vector& s, const Input& input, Forces& f) const {
        const double lf = p_.front_distance, lr = rearDistance();
        const double pitch = -(pitchMoment(s) + linkMoment(s, input)) / p_.wheelbase;
        const auto [wind_x, wind_y] = air(s);
        const double pressure = 0.5 * p_.air_density * (wind_x * wind_x + wind_y * wind_y);
        for (int i = 0; i < 4; i += 2) {
            const Axle& a = axle(i);
            const double weight = p_.mass * kGravity * (i == 0 ? lr : lf) / p_.wheelbase - (i == 0 ? pitch : -pitch) -
                                  pressure * a.lift_area;
            const double sprung = p_.mass * (i == 0 ? lr : lf) / p_.wheelbase - 2 * a.unsprung_mass;
            const double geometric = f.felt_ay * (sprung * a.roll_axis + 2 * a.unsprung_mass * a.tyre.loaded_radius);
            const double shift = (a.rollStiffness() * s[kRoll] + a.rollDamping() * s[kRollRate] + geometric) / a.track;
            f.load[i] = std::max(0.0, weight / 2 - shift);  // a turn to the left rolls to the right
            f.load[i + 1] = std::max(0.0, weight / 2 + shift);
        }
    }

    void move(const Vector& s, const Input& input, Forces& f) const {
        const auto [wind_x, wind_y] = air(s);
        const double pressure = 0.5 * p_.air_density * std::hypot(wind_x, wind_y);
        const double sideslip = std::atan2(wind_y, -wind_x), square = pressure * std::hypot(wind_x, wind_y);
        Sum sum{push_[0] + pressure * p_.drag_area * wind_x, push_[1] + square * p_.side_area * sideslip,
                push_[2] + square * p_.yaw_volume * sideslip};
        f.rate[kSteer] = p_.steering_lag > 0 ? (input.hand_wheel - s[kSteer]) / p_.steering_lag : 0;
        f.rate[kBrake] = p_.brake_lag > 0 ? (input.brake - s[kBrake]) / p_.brake_lag : 0;
        for (int i = 0; i < 4; ++i) wheel(i, s, input, f, sum);
        bodyRates(s, input, sum, f);
    }

    struct Sum {
        double x, y, moment;
    };

    void wheel(int i, const Vector& s, const Input& input, Forces& f, Sum& sum) const {
        const bool front = i < 2;
        const Axle& a = axle(i);
        const double hand = p_.steering_lag > 0 ? s[kSteer] : input.hand_wheel;
        const double x = front ? p_.front_distance : -rearDistance(), y = (i % 2 == 0 ? 0.5 : -0.5) * a.track;
        const double travel = a.travelByRoll() * s[kRoll];
        const double steer =
            (front ? hand / p_.steering_ratio : 0) + a.compliance_steer * f.fy[i] + a.toe_by_travel * travel;
        // Contact point in wheel axes.
        const double vx = s[kVx] - s[kYawRate] * y, vy = s[kVy] + s[kYawRate] * x + s[kRollRate] * body_.arm;
        const double c = std::cos(steer), n = std::sin(steer);
        const double along = std::max(c * vx + n * vy, 0.1), across = -n * vx + c * vy;
        const double kappa = (s[kSpin + i] * a.tyre.rolling_radius - along) / along;
        const double load = std::max(f.load[i], 100.0);
        f.rate[kAlpha + i] =
            along * a.tyre.carcass / corneringStiffness(a.tyre, load) * (-std::atan2(across, along) - s[kAlpha + i]);
        f.rate[kKappa + i] = along * a.tyre.carcass_x / slipStiffness(a.tyre, load) * (kappa - s[kKappa + i]);
        const double camber = s[kRoll] + a.camber_by_travel * travel;
        const TyreForce tyre = force(a.tyre, f.load[i], p_.road_friction, s[kKappa + i], s[kAlpha + i], camber);
        f.fx[i] = tyre.fx;
        f.fy[i] = tyre.fy;
        const double body_x = c * tyre.fx - n * tyre.fy, body_y = n * tyre.fx + c * tyre.fy;
        sum.x += body_x;
        sum.y += body_y;
        sum.moment += x * body_y - y * body_x - tyre.trail * tyre.fy;
        f.rate[kSpin + i] = spinRate(i, s, input, f);
    }

    double spinRate(int i, const Vector& s, const Input& input, const Forces& f) const {
        const Axle& a = axle(i);
        const double engine_speed = 0.5 * p_.drive_ratio * (s[kSpin] + s[kSpin + 1]);
        const double engine = input.throttle * p_.drive_scale * valueAt(p_.drive_full, engine_speed) -
                              (1 - input.throttle) * p_.drag_scale * valueAt(p_.drive_drag, engine_speed);
        const double drive = i < 2 ? 0.5 * engine * p_.drive_ratio * p_.drive_efficiency : 0;
        const double brake = 0.5 * brakeTorque(i < 2, s, input) * std::tanh(s[kSpin + i]);
        const double rolling = a.tyre.rolling_resistance * f.load[i] * a.tyre.rolling_radius;
        const double inertia =
            a.wheel_inertia + (i < 2 ? 0.5 * p_.engine_inertia * p_.drive_ratio * p_.drive_ratio : 0);
        return (drive - brake - rolling - f.fx[i] * a.tyre.loaded_radius) / inertia;
    }

    void bodyRates(const Vector& s, const Input& input, const Sum& sum, Forces& f) const {
        f.felt_ax = sum.x / p_.mass;
        f.felt_ay = sum.y / p_.mass;
        f.ax = f.felt_ax - kGravity * slope(s).x;
        f.ay = f.felt_ay - kGravity * slope(s).y;
        f.rate[kX] = s[kVx] * std::cos(s[kYaw]) - s[kVy] * std::sin(s[kYaw]);
        f.rate[kY] = s[kVx] * std::sin(s[kYaw]) + s[kVy] * std::cos(s[kYaw]);
        f.rate[kYaw] = s[kYawRate];
        f.rate[kVx] = f.ax + s[kYawRate] * s[kVy];
        f.rate[kVy] = f.ay - s[kYawRate] * s[kVx];
        f.rate[kYawRate] = sum.moment / p_.yaw_inertia;
        // Roll of the body about its centre of gravity, positive with the right side down: the side force acts at the
        // roll axis.
        const double stiffness = p_.front.rollStiffness() + p_.rear.rollStiffness();
        const double damping = p_.front.rollDamping() + p_.rear.rollDamping();
        f.rate[kPitch] = s[kPitchRate];
        f.rate[kPitchRate] =
            (-p_.mass * f.felt_ax * p_.height - pitchMoment(s) - linkMoment(s, input)) / p_.pitch_inertia;
        f.rate[kRoll] = s[kRollRate];
        f.rate[kRollRate] = (push_[3] + body_.mass * body_.arm * (f.felt_ay + kGravity * s[kRoll]) -
                             stiffness * s[kRoll] - damping * s[kRollRate]) /
                            body_.inertia;
    }

    Params p_;
    Body body_ = body();
    Vector s_{};
    std::array<double, 4> push_{};
};

}  // namespace other_car
