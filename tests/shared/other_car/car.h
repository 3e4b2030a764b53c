// Another car simulator: a double-track model that shares nothing with tread, for cases in which the structure of the
// model that is diagnosed with is itself not that of the car.
//
// After R. Rajamani, Vehicle Dynamics and Control, 2nd ed. (2012), chapters 2, 4, 13 and 15, and M. Mitschke, H.
// Wallentowitz, Dynamik der Kraftfahrzeuge, 4th ed. (2004): a rigid body that moves in the plane, pitches, and rolls
// about an axis fixed in it, four spinning wheels with slip that relaxes, loads shifted as springs and links take them.
// Left out: heave, vertical wheel motion, twist of the shafts, moments of the tyres but for the trail. Plane road,
// steady wind. What it has besides is in structure.h. ISO 8855 axes. Classical Runge-Kutta of fourth order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/other_car/params.h"
#include "shared/other_car/state.h"

namespace other_car {

inline constexpr double kGravity = 9.80665;  // m/s2
inline constexpr double kLeastLag = 0.001;   // s; shorter ones are none: they are faster than the integration's steps

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
        for (int i = 0; i < 4; ++i) s_[kSpin + i] = speed / tyre_[i].rolling_radius;
        s_[kBoost] = holdingThrottle();
        forces_ = last_ = settled(s_, {.throttle = s_[kBoost]});
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

    // Loads follow from accelerations, and these from forces at those loads: each stage goes on from what the last one
    // and the change over the last step let expect.
    void step(const Input& begin, const Input& end, double dt) {
        const Input middle{0.5 * (begin.steering_wheel + end.steering_wheel), 0.5 * (begin.throttle + end.throttle),
                           0.5 * (begin.brake + end.brake)};
        const Vector a = at(s_, begin);
        const Forces now = forces_;
        foresee(now);
        const Vector b = at(moved(a, dt / 2), middle);
        const Vector c = at(moved(b, dt / 2), middle);
        foresee(now);
        const Vector d = at(moved(c, dt), end);
        for (int i = 0; i < kStates; ++i) s_[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        last_ = now;
    }

    // Outside forces and moments at the centre of gravity, held over the next steps.
    struct Push {
        double fx = 0, fy = 0, roll = 0, pitch = 0, yaw = 0;  // N, N m
    };
    void push(const Push& push) { push_ = push; }

    const Vector& state() const { return s_; }
    // Of the body against the horizon.
    double roll() const { return s_[kRoll] + slope(s_).y; }
    Forces forces(const Input& input) const { return settled(s_, input); }
    // As they were at the end of the last step, a stage of the integration behind.
    const Forces& lastForces() const { return forces_; }
    double engineSpeed() const { return engineSpeed(s_); }
    double engineTorque(const Input& input) const { return engineTorque(s_, input); }

private:
    Vector moved(const Vector& rate, double dt) const {
        Vector next = s_;
        for (int i = 0; i < kStates; ++i) next[i] += dt * rate[i];
        return next;
    }

    const Vector& at(const Vector& s, const Input& input) {
        settle(s, input, 1, forces_);
        return forces_.rate;
    }

    // Half a step later.
    void foresee(const Forces& now) {
        forces_.felt_ay += 0.5 * (now.felt_ay - last_.felt_ay);
        for (std::size_t i = 0; i < 4; ++i) forces_.fy[i] += 0.5 * (now.fy[i] - last_.fy[i]);
    }

    void settle(const Vector& s, const Input& input, int rounds, Forces& f) const {
        for (int round = 0; round < rounds; ++round) {
            load(s, input, f);
            move(s, input, f);
        }
    }

    // From nothing: three rounds are enough to 1e-4.
    Forces settled(const Vector& s, const Input& input) const {
        Forces f{};
        settle(s, input, 3, f);
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

    double pedal(const Vector& s, const Input& input) const {
        return p_.brake_lag > kLeastLag ? s[kBrake] : input.brake;
    }
    double brakeTorque(bool front, const Vector& s, const Input& input) const {  // N m, of an axle
        const double pedal = p_.structure.slow_rear_brakes && !front ? s[kRearBrake] : this->pedal(s, input);
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

    // Roll of the body over an axle.
    double rollAt(bool front, const Vector& s) const {
        return s[front || !p_.structure.body_twist ? kRoll : kRearRoll];
    }
    // What springs, bars and dampers of an axle hold against it, N m.
    double rollMoment(bool front, const Vector& s) const {
        const Axle& a = front ? p_.front : p_.rear;
        const double roll = rollAt(front, s), bar = 2 * a.anti_roll_bar;
        const double more = p_.structure.progressive_anti_roll_bar ? std::pow(roll / kBarAngle, 2) : 0;
        return a.rollStiffness() * roll * (1 + more * bar / (a.spring + bar)) +
               a.rollDamping() * s[front || !p_.structure.body_twist ? kRollRate : kRearRollRate];
    }
    double rollAxis(const Axle& a, double roll) const {
        return p_.structure.moving_roll_axis ? a.roll_axis * (1 - std::abs(roll) / kRollAxisAngle) : a.roll_axis;
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
            const double axis = rollAxis(a, rollAt(i == 0, s));
            const double geometric = f.felt_ay * (sprung * axis + 2 * a.unsprung_mass * a.tyre.loaded_radius);
            const double shift = (rollMoment(i == 0, s) + geometric) / a.track;
            f.load[i] = std::max(0.0, weight / 2 - shift);  // a turn to the left rolls to the right
            f.load[i + 1] = std::max(0.0, weight / 2 + shift);
        }
    }

    void move(const Vector& s, const Input& input, Forces& f) const {
        const auto [wind_x, wind_y] = air(s);
        const double pressure = 0.5 * p_.air_density * std::hypot(wind_x, wind_y);
        const double sideslip = std::atan2(wind_y, -wind_x), square = pressure * std::hypot(wind_x, wind_y);
        Sum sum{push_.fx + pressure * p_.drag_area * wind_x, push_.fy + square * p_.side_area * sideslip,
                push_.yaw + square * p_.yaw_volume * sideslip};
        lag(s, input, f.rate);
        for (int i = 0; i < 4; ++i) wheel(i, s, input, f, sum);
        bodyRates(s, input, sum, f);
    }

    double lagged(const Vector& s, const Input& input) const {
        return p_.steering_lag > kLeastLag ? s[kSteer] : input.steering_wheel;
    }

    // What follows hand and foot late.
    void lag(const Vector& s, const Input& input, Vector& rate) const {
        rate[kSteer] = p_.steering_lag > kLeastLag ? (input.steering_wheel - s[kSteer]) / p_.steering_lag : 0;
        rate[kBrake] = p_.brake_lag > kLeastLag ? (input.brake - s[kBrake]) / p_.brake_lag : 0;
        rate[kRearBrake] = (pedal(s, input) - s[kRearBrake]) / kRearBrakeLag;
        rate[kBoost] = (input.throttle - s[kBoost]) / kTurboTime;
        rate[kColumn] = s[kColumnRate];
        rate[kColumnRate] = kColumnFrequency *
                            (kColumnFrequency * (lagged(s, input) - s[kColumn]) - 2 * kColumnDamping * s[kColumnRate]);
    }

    // Of a wheel against the body.
    double steerOf(int i, const Vector& s, const Input& input, double side_force, double travel) const {
        const Axle& a = axle(i);
        const double hand = p_.structure.steering_column ? s[kColumn] : lagged(s, input);
        const double bend = p_.structure.curved_roll_steer ? 1 + std::pow(travel / kToeCurve, 2) : 1;
        const double stiffer = p_.structure.stiffening_bushes ? 1 + std::abs(side_force) / kBushForce : 1;
        return (i < 2 ? hand / (p_.steering_ratio * (1 + p_.ratio_curvature * hand * hand)) : 0) +
               a.compliance_steer * side_force / stiffer + a.toe_by_travel * travel * bend;
    }

    double relaxationStiffness(const Tyre& tyre, double load) const {  // N/rad
        if (p_.structure.relaxation_by_load)
            return corneringStiffness(tyre, tyre.nominal_load) * load / tyre.nominal_load;
        return corneringStiffness(tyre, load);
    }

    struct Sum {
        double x, y, moment;
    };

    void wheel(int i, const Vector& s, const Input& input, Forces& f, Sum& sum) const {
        const bool front = i < 2;
        const Axle& a = axle(i);
        const Tyre& own = tyre_[i];
        const double x = front ? p_.front_distance : -rearDistance(), y = (i % 2 == 0 ? 0.5 : -0.5) * a.track;
        const double roll = rollAt(front, s), travel = a.travelByRoll() * roll;
        const double steer = steerOf(i, s, input, f.fy[i], travel);
        // Contact point in wheel axes.
        const double vx = s[kVx] - s[kYawRate] * y, vy = s[kVy] + s[kYawRate] * x + s[kRollRate] * body_.arm;
        const double c = std::cos(steer), n = std::sin(steer);
        const double along = std::max(c * vx + n * vy, 0.1), across = -n * vx + c * vy;
        const double kappa = (s[kSpin + i] * own.rolling_radius - along) / along;
        const double load = std::max(f.load[i], 100.0);
        f.rate[kAlpha + i] =
            along * own.carcass / relaxationStiffness(own, load) * (-std::atan2(across, along) - s[kAlpha + i]);
        f.rate[kKappa + i] = along * own.carcass_x / slipStiffness(own, load) * (kappa - s[kKappa + i]);
        const TyreForce tyre = force(own, p_.structure, f.load[i], p_.road_friction, s[kKappa + i], s[kAlpha + i],
                                     roll + a.camber_by_travel * travel);
        f.fx[i] = tyre.fx;
        f.fy[i] = tyre.fy;
        const double body_x = c * tyre.fx - n * tyre.fy, body_y = n * tyre.fx + c * tyre.fy;
        sum.x += body_x;
        sum.y += body_y;
        sum.moment += x * body_y - y * body_x - tyre.trail * tyre.fy;
        f.rate[kSpin + i] = spinRate(i, s, input, f);
    }

    double engineSpeed(const Vector& s) const { return 0.5 * p_.drive_ratio * (s[kSpin] + s[kSpin + 1]); }
    double engineTorque(const Vector& s, const Input& input) const {
        const double waiting = p_.structure.turbo_lag ? std::max(0.0, input.throttle - s[kBoost]) : 0;
        return (input.throttle - kTurboShare * waiting) * p_.drive_scale * valueAt(p_.drive_full, engineSpeed(s)) -
               (1 - input.throttle) * p_.drag_scale * valueAt(p_.drive_drag, engineSpeed(s));
    }

    double spinRate(int i, const Vector& s, const Input& input, const Forces& f) const {
        const Axle& a = axle(i);
        const Tyre& own = tyre_[i];
        double drive = 0, inertia = a.wheel_inertia;
        if (i < 2) {
            const double other = s[kSpin + 1 - i] - s[kSpin + i];
            drive = 0.5 * engineTorque(s, input) * p_.drive_ratio * p_.drive_efficiency +
                    (p_.structure.viscous_differential ? kViscousTorque * other : 0);
            inertia += 0.5 * p_.engine_inertia * p_.drive_ratio * p_.drive_ratio;
        }
        const double brake = (0.5 * brakeTorque(i < 2, s, input) + p_.wheels[i].drag_torque) * std::tanh(s[kSpin + i]);
        const double faster = p_.structure.rolling_resistance_by_speed ? std::pow(s[kVx] / kRollingSpeed, 2) / 2 : 0;
        const double rolling = own.rolling_resistance * (1 + faster) * f.load[i] * own.rolling_radius;
        return (drive - brake - rolling - f.fx[i] * own.loaded_radius) / inertia;
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
        f.rate[kPitch] = s[kPitchRate];
        f.rate[kPitchRate] =
            (push_.pitch - p_.mass * f.felt_ax * p_.height - pitchMoment(s) - linkMoment(s, input)) / p_.pitch_inertia;
        rollRates(s, f);
    }

    // Roll of the body about its centre of gravity, positive with the right side down: the side force acts at the roll
    // axis. A body that twists is two, each with its share of the mass.
    void rollRates(const Vector& s, Forces& f) const {
        const auto leaning = [&](double roll) { return body_.mass * body_.arm * (f.felt_ay + kGravity * roll); };
        const double front = rollMoment(true, s), rear = rollMoment(false, s);
        f.rate[kRoll] = s[kRollRate];
        f.rate[kRearRoll] = s[kRearRollRate];
        f.rate[kRearRollRate] = 0;
        if (!p_.structure.body_twist) {
            f.rate[kRollRate] = (push_.roll + leaning(s[kRoll]) - front - rear) / body_.inertia;
            return;
        }
        const double share = p_.front_distance / p_.wheelbase, inertia = share * body_.inertia;  // of the rear
        const double twist = kTwistStiffness * (s[kRoll] - s[kRearRoll]) + 2 * kTwistDamping *
                                                                               std::sqrt(kTwistStiffness * inertia) *
                                                                               (s[kRollRate] - s[kRearRollRate]);
        f.rate[kRollRate] = (push_.roll + (1 - share) * leaning(s[kRoll]) - front - twist) / (body_.inertia - inertia);
        f.rate[kRearRollRate] = (share * leaning(s[kRearRoll]) - rear + twist) / inertia;
    }

    std::array<Tyre, 4> tyresOfWheels() const {
        std::array<Tyre, 4> tyres{p_.front.tyre, p_.front.tyre, p_.rear.tyre, p_.rear.tyre};
        for (std::size_t i = 0; i < 4; ++i) {
            tyres[i].stiffness *= p_.wheels[i].stiffness;
            tyres[i].friction *= p_.wheels[i].friction;
            tyres[i].rolling_radius -= p_.wheels[i].smaller;
            tyres[i].loaded_radius -= p_.wheels[i].smaller;
        }
        return tyres;
    }

    Params p_;
    Body body_ = body();
    std::array<Tyre, 4> tyre_ = tyresOfWheels();
    Forces forces_{}, last_{};  // of the last stage; of the beginning of the last step
    Vector s_{};
    Push push_;
};

}  // namespace other_car
