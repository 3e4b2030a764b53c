// Motion of the body of the other car: in the plane, in pitch, and in roll about a fixed axis.
#pragma once

#include <cmath>

#include "shared/other_car/controls.h"
#include "shared/other_car/forces.h"
#include "shared/other_car/params.h"
#include "shared/other_car/road_and_air.h"

namespace other_car {

inline double rearDistance(const Params& p) {  // m, from the centre of gravity to the rear axle
    return p.wheelbase - p.front_distance;
}

// The part that rolls, without the unsprung masses.
struct Body {
    double mass;     // kg
    double arm;      // m, height of its centre of gravity above the roll axis
    double inertia;  // kg m2, roll
};
inline Body bodyOf(const Params& p) {
    Body b{p.mass, p.mass * p.height, p.roll_inertia};
    for (const Axle* a : {&p.front, &p.rear}) {
        b.mass -= 2 * a->unsprung_mass;
        b.arm -= 2 * a->unsprung_mass * a->tyre.loaded_radius;
    }
    const double height = b.arm / b.mass;
    for (const Axle* a : {&p.front, &p.rear}) {
        const double lower = p.height - a->tyre.loaded_radius;
        b.inertia -= 2 * a->unsprung_mass * (0.25 * a->track * a->track + lower * lower);
    }
    b.inertia -= b.mass * (height - p.height) * (height - p.height);
    b.arm = height - (p.front.roll_axis * rearDistance(p) + p.rear.roll_axis * p.front_distance) / p.wheelbase;
    return b;
}

// Moment of the suspension links that supports the nose against the brakes (anti-dive, anti-lift), N m.
inline double linkMoment(const Params& p, const Vector& s, const Input& input) {
    const Axle &front = p.front, &rear = p.rear;
    return p.front_distance * front.brake_support * brakeTorque(p, true, s, input) / front.tyre.loaded_radius +
           rearDistance(p) * rear.brake_support * brakeTorque(p, false, s, input) / rear.tyre.loaded_radius;
}

// Moment of springs and dampers against pitch, N m; pitch is positive nose down.
inline double pitchMoment(const Params& p, const Vector& s) {
    const double lf = p.front_distance, lr = rearDistance(p);
    const double stiffness = lf * lf * p.front.pitchRate() + lr * lr * p.rear.pitchRate();
    const double damping = lf * lf * p.front.pitchDamping() + lr * lr * p.rear.pitchDamping();
    return stiffness * s[kPitch] + damping * s[kPitchRate];
}

// Roll angle of the body above an axle, rad.
inline double rollAt(const Params& p, bool front, const Vector& s) {
    return s[front || !p.structure.body_twist ? kRoll : kRearRoll];
}

// Moment of springs, anti-roll bar and dampers of an axle against roll, N m.
inline double rollMoment(const Params& p, bool front, const Vector& s) {
    const Axle& a = front ? p.front : p.rear;
    const double roll = rollAt(p, front, s), bar = 2 * a.anti_roll_bar;
    const double more = p.structure.progressive_anti_roll_bar ? std::pow(roll / kBarAngle, 2) : 0;
    return a.rollStiffness() * roll * (1 + more * bar / (a.spring + bar)) +
           a.rollDamping() * s[front || !p.structure.body_twist ? kRollRate : kRearRollRate];
}

// Roll rates of the body about its centre of gravity, positive with the right side down: the lateral force acts at the
// roll axis. A body that twists consists of two parts, each with its share of the mass.
inline void setRollRates(const Params& p, const Body& body, const Push& push, const Vector& s, Forces& f) {
    const auto leaning = [&](double roll) { return body.mass * body.arm * (f.felt_ay + kGravity * roll); };
    const double front = rollMoment(p, true, s), rear = rollMoment(p, false, s);
    f.rate[kRoll] = s[kRollRate];
    f.rate[kRearRoll] = s[kRearRollRate];
    f.rate[kRearRollRate] = 0;
    if (!p.structure.body_twist) {
        f.rate[kRollRate] = (push.roll + leaning(s[kRoll]) - front - rear) / body.inertia;
        return;
    }
    const double share = p.front_distance / p.wheelbase, inertia = share * body.inertia;  // of the rear part
    const double damping = 2 * kTwistDamping * std::sqrt(kTwistStiffness * inertia);      // N m s/rad
    const double twist = kTwistStiffness * (s[kRoll] - s[kRearRoll]) + damping * (s[kRollRate] - s[kRearRollRate]);
    f.rate[kRollRate] = (push.roll + (1 - share) * leaning(s[kRoll]) - front - twist) / (body.inertia - inertia);
    f.rate[kRearRollRate] = (share * leaning(s[kRearRoll]) - rear + twist) / inertia;
}

// Accelerations and rates of the body. `sum`: all forces in the plane.
inline void setBodyRates(const Params& p, const Body& body, const Push& push, const PlaneForce& sum, const Vector& s,
                         const Input& input, Forces& f) {
    f.felt_ax = sum.x / p.mass;
    f.felt_ay = sum.y / p.mass;
    f.ax = f.felt_ax - kGravity * slope(p, s).x;
    f.ay = f.felt_ay - kGravity * slope(p, s).y;
    f.rate[kX] = s[kVx] * std::cos(s[kYaw]) - s[kVy] * std::sin(s[kYaw]);
    f.rate[kY] = s[kVx] * std::sin(s[kYaw]) + s[kVy] * std::cos(s[kYaw]);
    f.rate[kYaw] = s[kYawRate];
    f.rate[kVx] = f.ax + s[kYawRate] * s[kVy];
    f.rate[kVy] = f.ay - s[kYawRate] * s[kVx];
    f.rate[kYawRate] = sum.moment / p.yaw_inertia;
    f.rate[kPitch] = s[kPitchRate];
    f.rate[kPitchRate] =
        (push.pitch - p.mass * f.felt_ax * p.height - pitchMoment(p, s) - linkMoment(p, s, input)) / p.pitch_inertia;
    setRollRates(p, body, push, s, f);
}

}  // namespace other_car
