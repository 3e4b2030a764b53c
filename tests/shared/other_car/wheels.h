// Wheel loads, steer angles and tyre forces of the other car.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/other_car/body.h"
#include "shared/other_car/driveline.h"

namespace other_car {

using WheelTyres = std::array<Tyre, 4>;

inline double rightward(std::size_t i) {  // 1 for a wheel on the right, -1 on the left
    return i % 2 == 0 ? -1 : 1;
}

// Tyres of the axles with the faults of their wheels.
inline WheelTyres tyresOf(const Params& p) {
    WheelTyres tyres{p.front.tyre, p.front.tyre, p.rear.tyre, p.rear.tyre};
    for (std::size_t i = 0; i < 4; ++i) {
        tyres[i].stiffness *= p.wheels[i].stiffness;
        tyres[i].slip_stiffness *= p.wheels[i].slip_stiffness;
        tyres[i].friction *= p.wheels[i].friction;
    }
    return tyres;
}

inline double rollAxisHeight(const Params& p, const Axle& a, double roll) {  // m
    return p.structure.moving_roll_axis ? a.roll_axis * (1 - std::abs(roll) / kRollAxisAngle) : a.roll_axis;
}

// Load transfer by pitch, roll and the links, from the specific forces in `f`.
inline void setLoads(const Params& p, const Vector& s, const Input& input, Forces& f) {
    const double lf = p.front_distance, lr = rearDistance(p);
    const double pitch = -(pitchMoment(p, s) + linkMoment(p, s, input)) / p.wheelbase;
    const double pressure = dynamicPressure(p, s);
    for (std::size_t i = 0; i < 4; i += 2) {
        const bool front = i == 0;
        const Axle& a = front ? p.front : p.rear;
        const double weight =
            p.mass * kGravity * (front ? lr : lf) / p.wheelbase - (front ? pitch : -pitch) - pressure * a.lift_area;
        const double sprung = p.mass * (front ? lr : lf) / p.wheelbase - 2 * a.unsprung_mass;
        const double axis = rollAxisHeight(p, a, rollAt(p, front, s));
        const double geometric = f.felt_ay * (sprung * axis + 2 * a.unsprung_mass * a.tyre.loaded_radius);
        const double shift = (rollMoment(p, front, s) + geometric) / a.track;
        f.load[i] = std::max(0.0, weight / 2 - shift);  // a left turn loads the right wheels
        f.load[i + 1] = std::max(0.0, weight / 2 + shift);
    }
}

// Travel of wheel i by roll and pitch, m.
inline double travelOf(const Params& p, std::size_t i, const Vector& s) {
    const bool front = i < 2;
    const Axle& a = front ? p.front : p.rear;
    const double dive = front ? p.front_distance * s[kPitch] : -rearDistance(p) * s[kPitch];
    return rightward(i) * a.travelByRoll() * rollAt(p, front, s) + a.travelByDive() * dive;
}

// Steer angle of wheel i relative to the body, rad.
inline double steerOf(const Params& p, std::size_t i, const Vector& s, const Input& input, double side_force) {
    const Axle& a = i < 2 ? p.front : p.rear;
    const double travel = travelOf(p, i, s);
    const double hand = p.structure.steering_column ? s[kColumn] : steeringWheelAfterLag(p, s, input);
    const double bend = p.structure.curved_roll_steer ? 1 + std::pow(travel / kToeCurve, 2) : 1;
    const double stiffer = p.structure.stiffening_bushes ? 1 + std::abs(side_force) / kBushForce : 1;
    return (i < 2 ? hand / (p.steering_ratio * (1 + p.ratio_curvature * hand * hand)) : 0) +
           a.compliance_steer * side_force / stiffer + rightward(i) * (a.toe + a.toe_by_travel * travel * bend);
}

// Cornering stiffness that determines the relaxation length, N/rad.
inline double relaxationStiffness(const Params& p, const Tyre& tyre, double load) {
    if (p.structure.relaxation_by_load) return corneringStiffness(tyre, tyre.nominal_load) * load / tyre.nominal_load;
    return corneringStiffness(tyre, load);
}

// Sets forces and rates of wheel i and adds its force to `sum`. `arm`: of Body.
inline void addWheel(const Params& p, const Tyre& tyre, double arm, std::size_t i, const Vector& s, const Input& input,
                     Forces& f, PlaneForce& sum) {
    const bool front = i < 2;
    const Axle& a = front ? p.front : p.rear;
    const double x = front ? p.front_distance : -rearDistance(p), y = (i % 2 == 0 ? 0.5 : -0.5) * a.track;
    const double steer = steerOf(p, i, s, input, f.fy[i]);
    const double camber = rollAt(p, front, s) + rightward(i) * (a.camber + a.camber_by_travel * travelOf(p, i, s));
    // Velocity of the contact point in wheel axes.
    const double vx = s[kVx] - s[kYawRate] * y, vy = s[kVy] + s[kYawRate] * x + s[kRollRate] * arm;
    const double c = std::cos(steer), n = std::sin(steer);
    const double along = std::max(c * vx + n * vy, 0.1), across = -n * vx + c * vy;  // m/s; above 0: a divisor below
    const double kappa = (s[kSpin + i] * rollingRadius(tyre, f.load[i]) - along) / along;
    const double load = std::max(f.load[i], 100.0);  // N; a relaxation length needs some load
    f.rate[kAlpha + i] =
        along * tyre.carcass / relaxationStiffness(p, tyre, load) * (-std::atan2(across, along) - s[kAlpha + i]);
    f.rate[kKappa + i] = along * tyre.carcass_x / slipStiffness(tyre, load) * (kappa - s[kKappa + i]);
    const TyreForce contact =
        force(tyre, p.structure, f.load[i], p.road_friction, s[kKappa + i], s[kAlpha + i], camber);
    f.fx[i] = contact.fx;
    f.fy[i] = contact.fy;
    const double body_x = c * contact.fx - n * contact.fy, body_y = n * contact.fx + c * contact.fy;
    sum.x += body_x;
    sum.y += body_y;
    sum.moment += x * body_y - y * body_x - contact.trail * contact.fy;
    f.rate[kSpin + i] = spinRate(p, tyre, i, s, input, f);
}

}  // namespace other_car
