// Another car simulator: a double-track model that shares nothing with tread, for cases in which the structure of the
// model that is diagnosed with is itself not that of the car.
//
// After R. Rajamani, Vehicle Dynamics and Control, 2nd ed. (2012), chapters 2, 4, 13 and 15, and M. Mitschke, H.
// Wallentowitz, Dynamik der Kraftfahrzeuge, 4th ed. (2004): a rigid body that moves in the plane and rolls about an
// axis fixed in it, four spinning wheels with slip that relaxes, loads shifted quasi-statically. The tyre is Pacejka's
// similarity formula with a friction that falls with the load. Left out: pitch, camber, aligning moments, vertical
// wheel motion. Level road, still air. ISO 8855 axes. Classical Runge-Kutta of fourth order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace other_car {

inline constexpr double kGravity = 9.80665;  // m/s2

struct Tyre {
    double friction = 0.95;          // at the nominal load
    double friction_by_load = -0.1;  // relative change over relative load
    double stiffness = 0;            // N/rad, cornering stiffness at the nominal load
    double stiffness_by_load = 0.6;  // its relative change over relative load
    double slip_stiffness = 1.0;     // longitudinal over cornering stiffness
    double nominal_load = 3300;      // N
    double shape = 1.4;
    double relaxation = 0.45;  // m, lateral
    double relaxation_x = 0.1;
    double rolling_resistance = 0.011;
};

struct Axle {
    Tyre tyre;
    double track = 1.5;
    double roll_stiffness = 0;    // N m/rad
    double roll_damping = 0;      // N m s/rad
    double roll_axis = 0.08;      // m, height
    double wheel_inertia = 1;     // kg m2, of each, with what turns with it
    double compliance_steer = 0;  // rad/N of the axle's side force
};

struct Params {
    double mass = 1350, yaw_inertia = 1950, roll_inertia = 480;
    double front_distance = 1.03, wheelbase = 2.62, height = 0.54;
    double wheel_radius = 0.303;
    Axle front, rear;
    double steering_ratio = 16.5;
    double steering_delay = 0;  // s, first-order lag
    double brake_torque = 5000, brake_front_share = 0.82;
    double drive_ratio = 0.78 * 3.94;          // one gear
    double drive_full = 146, drive_drag = 22;  // N m at the engine
    double drive_efficiency = 0.94;
    double drag_area = 0.66, air_density = 1.2041;
};

struct Input {
    double hand_wheel = 0, throttle = 0, brake = 0;
};

// x, y, yaw, vx, vy, yaw rate, roll, roll rate; spins; lateral and longitudinal slips as relaxed; steering.
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
    kStates
};
using Vector = std::array<double, kStates>;

struct Forces {
    std::array<double, 4> fx, fy, load;
    double ax = 0, ay = 0;
    Vector rate{};
};

struct TyreForce {
    double fx, fy;
};

// Lateral slip positive for a force to the left.
inline TyreForce force(const Tyre& tyre, double load, double kappa, double alpha) {
    if (load <= 0) return {0, 0};
    const double relative = (load - tyre.nominal_load) / tyre.nominal_load;
    const double peak = load * tyre.friction * (1 + tyre.friction_by_load * relative);
    const double stiffness = std::max(tyre.stiffness * (1 + tyre.stiffness_by_load * relative), 0.1 * tyre.stiffness);
    const double along = tyre.slip_stiffness * kappa, across = std::tan(alpha);
    const double slip = std::hypot(along, across);
    if (slip < 1e-9) return {stiffness * along, stiffness * across};
    const double magnitude = peak * std::sin(tyre.shape * std::atan(stiffness * slip / (tyre.shape * peak)));
    return {magnitude * along / slip, magnitude * across / slip};
}

class Car {
public:
    Car(const Params& params, double speed) : p_(params) {
        s_[kVx] = speed;
        for (int i = 0; i < 4; ++i) s_[kSpin + i] = speed / p_.wheel_radius;
    }

    // Throttle that holds the speed in a straight line.
    double holdingThrottle() const {
        const double v = s_[kVx];
        const double rolling = p_.mass * kGravity * p_.front.tyre.rolling_resistance;
        const double need = (rolling + 0.5 * p_.air_density * p_.drag_area * v * v) * p_.wheel_radius;
        return (need / (p_.drive_ratio * p_.drive_efficiency) + p_.drive_drag) / (p_.drive_full + p_.drive_drag);
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
    void push(double fx, double fy, double yaw_moment) { push_ = {fx, fy, yaw_moment}; }

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

    void load(const Vector& s, Forces& f) const {
        const double lf = p_.front_distance, lr = rearDistance();
        const double pitch = p_.mass * f.ax * p_.height / p_.wheelbase;
        for (int axle = 0; axle < 2; ++axle) {
            const Axle& a = axle == 0 ? p_.front : p_.rear;
            const double weight =
                p_.mass * kGravity * (axle == 0 ? lr : lf) / p_.wheelbase - (axle == 0 ? pitch : -pitch);
            const double geometric = p_.mass * f.ay * (axle == 0 ? lr : lf) / p_.wheelbase * a.roll_axis;
            const double shift = (a.roll_stiffness * s[kRoll] + a.roll_damping * s[kRollRate] + geometric) / a.track;
            f.load[2 * axle] = std::max(0.0, weight / 2 - shift);  // a turn to the left rolls to the right
            f.load[2 * axle + 1] = std::max(0.0, weight / 2 + shift);
        }
    }

    void move(const Vector& s, const Input& input, Forces& f) const {
        double sum_x = push_[0] - 0.5 * p_.air_density * p_.drag_area * s[kVx] * std::abs(s[kVx]);
        double sum_y = push_[1], moment = push_[2];
        const double hand = p_.steering_delay > 0 ? s[kSteer] : input.hand_wheel;
        f.rate[kSteer] = p_.steering_delay > 0 ? (input.hand_wheel - s[kSteer]) / p_.steering_delay : 0;
        for (int i = 0; i < 4; ++i) {
            const bool front = i < 2;
            const Axle& axle = front ? p_.front : p_.rear;
            const double x = front ? p_.front_distance : -rearDistance();
            const double y = (i % 2 == 0 ? 0.5 : -0.5) * axle.track;
            const double steer = (front ? hand / p_.steering_ratio : 0) + axle.compliance_steer * 2 * f.fy[i];
            // Contact point in wheel axes.
            const double vx = s[kVx] - s[kYawRate] * y, vy = s[kVy] + s[kYawRate] * x;
            const double c = std::cos(steer), n = std::sin(steer);
            const double along = std::max(c * vx + n * vy, 0.1), across = -n * vx + c * vy;
            const double kappa = (s[kSpin + i] * p_.wheel_radius - along) / along;
            f.rate[kAlpha + i] = along / axle.tyre.relaxation * (-std::atan2(across, along) - s[kAlpha + i]);
            f.rate[kKappa + i] = along / axle.tyre.relaxation_x * (kappa - s[kKappa + i]);
            const TyreForce tyre = force(axle.tyre, f.load[i], s[kKappa + i], s[kAlpha + i]);
            f.fx[i] = tyre.fx;
            f.fy[i] = tyre.fy;
            const double body_x = c * tyre.fx - n * tyre.fy, body_y = n * tyre.fx + c * tyre.fy;
            sum_x += body_x;
            sum_y += body_y;
            moment += x * body_y - y * body_x;
            f.rate[kSpin + i] = spinRate(i, s, input, axle, f);
        }
        bodyRates(s, sum_x, sum_y, moment, f);
    }

    double spinRate(int i, const Vector& s, const Input& input, const Axle& axle, const Forces& f) const {
        const double engine = input.throttle * p_.drive_full - (1 - input.throttle) * p_.drive_drag;
        const double drive = i < 2 ? 0.5 * engine * p_.drive_ratio * p_.drive_efficiency : 0;
        const double share = i < 2 ? p_.brake_front_share : 1 - p_.brake_front_share;
        const double brake = 0.5 * share * input.brake * p_.brake_torque * std::tanh(s[kSpin + i]);
        const double rolling = axle.tyre.rolling_resistance * f.load[i] * p_.wheel_radius;
        return (drive - brake - rolling - f.fx[i] * p_.wheel_radius) / axle.wheel_inertia;
    }

    void bodyRates(const Vector& s, double sum_x, double sum_y, double moment, Forces& f) const {
        f.ax = sum_x / p_.mass;
        f.ay = sum_y / p_.mass;
        f.rate[kX] = s[kVx] * std::cos(s[kYaw]) - s[kVy] * std::sin(s[kYaw]);
        f.rate[kY] = s[kVx] * std::sin(s[kYaw]) + s[kVy] * std::cos(s[kYaw]);
        f.rate[kYaw] = s[kYawRate];
        f.rate[kVx] = f.ax + s[kYawRate] * s[kVy];
        f.rate[kVy] = f.ay - s[kYawRate] * s[kVx];
        f.rate[kYawRate] = moment / p_.yaw_inertia;
        // Roll about the roll axis; positive with the right side down.
        const double axis =
            (p_.front.roll_axis * rearDistance() + p_.rear.roll_axis * p_.front_distance) / p_.wheelbase;
        const double arm = p_.height - axis;
        const double stiffness = p_.front.roll_stiffness + p_.rear.roll_stiffness;
        const double damping = p_.front.roll_damping + p_.rear.roll_damping;
        f.rate[kRoll] = s[kRollRate];
        f.rate[kRollRate] =
            (p_.mass * arm * (f.ay + kGravity * s[kRoll]) - stiffness * s[kRoll] - damping * s[kRollRate]) /
            (p_.roll_inertia + p_.mass * arm * arm);
    }

    Params p_;
    Vector s_{};
    std::array<double, 3> push_{};
};

}  // namespace other_car
