// Another car simulator: a double-track model that shares nothing with tread, for cases in which the structure of the
// model that is diagnosed with is itself not that of the car.
//
// After R. Rajamani, Vehicle Dynamics and Control, 2nd ed. (2012), chapters 2, 4, 13 and 15, and M. Mitschke, H.
// Wallentowitz, Dynamik der Kraftfahrzeuge, 4th ed. (2004): a rigid body that moves in the plane, pitches and rolls
// about an axis fixed in it, four spinning wheels with slip that relaxes, loads shifted as the springs take them. The
// tyre is the similarity method (H.B. Pacejka, Tyre and Vehicle Dynamics, 2nd ed. 2006, chapter 4): one magic formula
// for the slip as a vector, camber as a shift of the slip angle, the trail of the brush model. Left out: heave,
// vertical wheel motion, twist of the shafts, moments of the tyres but for the trail. Plane road, steady wind. ISO 8855
// axes. Classical Runge-Kutta of fourth order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace other_car {

inline constexpr double kGravity = 9.80665;  // m/s2

struct Tyre {
    double friction = 0.99;           // at the nominal load
    double friction_by_load = -0.15;  // relative change over relative load
    double stiffness = 59800;         // N/rad, largest cornering stiffness, reached at
    double stiffness_load = 8500;     // N
    double slip_stiffness = 21.5;     // longitudinal, over the load
    double camber_stiffness = 1.39;   // 1/rad, camber thrust over the load
    double trail = 0.0313;            // m, without slip, at the nominal load
    double nominal_load = 4000;       // N
    double shape = 1.19;
    double curvature = -1;
    double carcass = 141800;    // N/m, lateral
    double carcass_x = 474500;  // N/m
    double rolling_resistance = 0.0102;
    double rolling_radius = 0.3055;
    double loaded_radius = 0.294;
    double radial_stiffness = 183600;  // N/m
};

struct Axle {
    Tyre tyre;
    double track = 1.5;
    double spring = 0, anti_roll_bar = 0;  // N/m, at the wheel; of the difference of both wheels' travel
    double damping = 0;                    // N s/m, at the wheel
    double roll_axis = 0.08;               // m, height
    double unsprung_mass = 0;              // kg, of each wheel; does not roll
    double wheel_inertia = 1;              // kg m2, of each
    double compliance_steer = 0;           // rad/N of a wheel's side force
    double toe_by_travel = 0;              // rad/m, toe-in
    double camber_by_travel = 0;           // rad/m, positive when the top leans outwards
    double lift_area = 0;                  // m2

    double rollStiffness() const {  // N m/rad, of suspension and tyres in series
        const double wheel = spring + 2 * anti_roll_bar;
        return 0.5 * track * track * wheel * tyre.radial_stiffness / (wheel + tyre.radial_stiffness);
    }
    // Travel of the right wheel over the roll angle, m.
    double travelByRoll() const {
        return 0.5 * track * tyre.radial_stiffness / (spring + 2 * anti_roll_bar + tyre.radial_stiffness);
    }
    double pitchRate() const {  // N/m at the axle
        return 2 * spring * tyre.radial_stiffness / (spring + tyre.radial_stiffness);
    }
    double pitchDamping() const {  // N s/m at the axle
        const double suspension = tyre.radial_stiffness / (spring + tyre.radial_stiffness);
        return 2 * damping * suspension * suspension;
    }
    double rollDamping() const {  // N m s/rad; the tyres take their part of the roll
        const double suspension = tyre.radial_stiffness / (spring + 2 * anti_roll_bar + tyre.radial_stiffness);
        return 0.5 * track * track * damping * suspension * suspension;
    }
};

using Line = std::vector<std::array<double, 2>>;  // of straight pieces

struct Params {
    double mass = 1350, yaw_inertia = 1950, roll_inertia = 480, pitch_inertia = 1750;
    double pitch_support = 0.1;  // share of the longitudinal load transfer that the links carry past the springs
    double front_distance = 1.03, wheelbase = 2.62, height = 0.54;
    Axle front, rear;
    double steering_ratio = 16.5;
    double steering_lag = 0;  // s
    double brake_torque = 5000, brake_front_share = 0.82;
    double brake_lag = 0;              // s
    double drive_ratio = 0.78 * 3.94;  // one gear
    double engine_inertia = 0.148;     // kg m2
    Line drive_full, drive_drag;       // N m over rad/s, of the engine
    double drive_scale = 1, drag_scale = 1;
    double drive_efficiency = 0.94;
    double drag_area = 0.66, air_density = 1.2041;
    double side_area = 0, yaw_volume = 0;  // m2/rad, m3/rad of the air's sideslip
    double wind_x = 0, wind_y = 0;         // m/s, to where it blows
    double grade = 0, bank = 0;            // rise over run along x and y
    double road_friction = 1;
};

struct Input {
    double hand_wheel = 0, throttle = 0, brake = 0;
};

// x, y, yaw, vx, vy, yaw rate, roll, roll rate; spins; lateral and longitudinal slips as relaxed; steering and brakes
// as they lag; pitch, pitch rate.
enum State {
    kX,
    kY,
    kYaw,
    kVx,
    kVy,
    kYawRate,
    kRoll,
    kRollRate,
    kSpin,
    kAlpha = kSpin + 4,
    kKappa = kAlpha + 4,
    kSteer = kKappa + 4,
    kBrake,
    kPitch,
    kPitchRate,
    kStates
};
using Vector = std::array<double, kStates>;

struct Forces {
    std::array<double, 4> fx, fy, load;
    double ax = 0, ay = 0;
    Vector rate{};
};

struct TyreForce {
    double fx, fy, trail;
};

inline double valueAt(const Line& line, double x) {
    std::size_t i = 1;
    while (i + 1 < line.size() && line[i][0] < x) ++i;
    const auto &a = line[i - 1], &b = line[i];
    const double share = std::clamp((x - a[0]) / (b[0] - a[0]), 0.0, 1.0);
    return a[1] + share * (b[1] - a[1]);
}

inline double corneringStiffness(const Tyre& tyre, double load) {
    return tyre.stiffness * std::sin(2 * std::atan(load / tyre.stiffness_load));
}

// Lateral slip positive for a force to the left, camber for a top that leans to the right.
inline TyreForce force(const Tyre& tyre, double load, double road_friction, double kappa, double alpha, double camber) {
    if (load <= 0) return {0, 0, 0};
    const double relative = (load - tyre.nominal_load) / tyre.nominal_load;
    const double peak = load * road_friction * tyre.friction * (1 + tyre.friction_by_load * relative);
    const double stiffness = corneringStiffness(tyre, load);
    const double along = tyre.slip_stiffness * load / stiffness * kappa;
    const double across = std::tan(alpha) - tyre.camber_stiffness * load / stiffness * camber;
    const double slip = std::hypot(along, across), trail = tyre.trail * load / tyre.nominal_load;
    if (slip < 1e-9) return {stiffness * along, stiffness * across, trail};
    const double x = stiffness * slip / (tyre.shape * peak);
    const double used = std::sin(tyre.shape * std::atan(x - tyre.curvature * (x - std::atan(x))));
    // Brush model: the part of the contact that does not slide.
    const double stuck = std::cbrt(std::max(0.0, 1 - std::abs(used))), slid = 1 - stuck;
    const double shorter = stuck * stuck * stuck / (1 - slid + slid * slid / 3);
    return {peak * used * along / slip, peak * used * across / slip, trail * shorter};
}

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
            load(s, f);
            move(s, input, f);
        }
        return f;
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

    // Of springs and dampers, for a nose that is down.
    double pitchMoment(const Vector& s) const {
        const double lf = p_.front_distance, lr = rearDistance();
        const double stiffness = lf * lf * p_.front.pitchRate() + lr * lr * p_.rear.pitchRate();
        const double damping = lf * lf * p_.front.pitchDamping() + lr * lr * p_.rear.pitchDamping();
        return stiffness * s[kPitch] + damping * s[kPitchRate];
    }

    void load(const Vector& s, Forces& f) const {
        const double lf = p_.front_distance, lr = rearDistance();
        const double pitch = (p_.pitch_support * p_.mass * f.ax * p_.height - pitchMoment(s)) / p_.wheelbase;
        const auto [wind_x, wind_y] = air(s);
        const double pressure = 0.5 * p_.air_density * (wind_x * wind_x + wind_y * wind_y);
        for (int i = 0; i < 4; i += 2) {
            const Axle& a = axle(i);
            const double weight = p_.mass * kGravity * (i == 0 ? lr : lf) / p_.wheelbase - (i == 0 ? pitch : -pitch) -
                                  pressure * a.lift_area;
            const double sprung = p_.mass * (i == 0 ? lr : lf) / p_.wheelbase - 2 * a.unsprung_mass;
            const double geometric = f.ay * (sprung * a.roll_axis + 2 * a.unsprung_mass * a.tyre.loaded_radius);
            const double shift = (a.rollStiffness() * s[kRoll] + a.rollDamping() * s[kRollRate] + geometric) / a.track;
            f.load[i] = std::max(0.0, weight / 2 - shift);  // a turn to the left rolls to the right
            f.load[i + 1] = std::max(0.0, weight / 2 + shift);
        }
    }

    void move(const Vector& s, const Input& input, Forces& f) const {
        const auto [wind_x, wind_y] = air(s);
        const double pressure = 0.5 * p_.air_density * std::hypot(wind_x, wind_y);
        const double sideslip = std::atan2(wind_y, -wind_x), square = pressure * std::hypot(wind_x, wind_y);
        const double c = std::cos(s[kYaw]), n = std::sin(s[kYaw]), weight = p_.mass * kGravity;
        Sum sum{push_[0] + pressure * p_.drag_area * wind_x - weight * (c * p_.grade + n * p_.bank),
                push_[1] + square * p_.side_area * sideslip - weight * (-n * p_.grade + c * p_.bank),
                push_[2] + square * p_.yaw_volume * sideslip};
        f.rate[kSteer] = p_.steering_lag > 0 ? (input.hand_wheel - s[kSteer]) / p_.steering_lag : 0;
        f.rate[kBrake] = p_.brake_lag > 0 ? (input.brake - s[kBrake]) / p_.brake_lag : 0;
        for (int i = 0; i < 4; ++i) wheel(i, s, input, f, sum);
        bodyRates(s, sum, f);
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
        f.rate[kKappa + i] = along * a.tyre.carcass_x / (a.tyre.slip_stiffness * load) * (kappa - s[kKappa + i]);
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
        const double share = i < 2 ? p_.brake_front_share : 1 - p_.brake_front_share;
        const double pedal = p_.brake_lag > 0 ? s[kBrake] : input.brake;
        const double brake = 0.5 * share * pedal * p_.brake_torque * std::tanh(s[kSpin + i]);
        const double rolling = a.tyre.rolling_resistance * f.load[i] * a.tyre.rolling_radius;
        const double inertia =
            a.wheel_inertia + (i < 2 ? 0.5 * p_.engine_inertia * p_.drive_ratio * p_.drive_ratio : 0);
        return (drive - brake - rolling - f.fx[i] * a.tyre.loaded_radius) / inertia;
    }

    void bodyRates(const Vector& s, const Sum& sum, Forces& f) const {
        f.ax = sum.x / p_.mass;
        f.ay = sum.y / p_.mass;
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
        f.rate[kPitchRate] = (-(1 - p_.pitch_support) * p_.mass * f.ax * p_.height - pitchMoment(s)) / p_.pitch_inertia;
        f.rate[kRoll] = s[kRollRate];
        f.rate[kRollRate] = (push_[3] + body_.mass * body_.arm * (f.ay + kGravity * s[kRoll]) - stiffness * s[kRoll] -
                             damping * s[kRollRate]) /
                            body_.inertia;
    }

    Params p_;
    Body body_ = body();
    Vector s_{};
    std::array<double, 4> push_{};
};

}  // namespace other_car
