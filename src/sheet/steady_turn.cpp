#include "sheet/steady_turn.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <numbers>

#include "metrics/channels.h"
#include "vehicle/tyre_load.h"

namespace tread::sheet {
namespace {

constexpr double kSpeed = 20;         // m/s, at which the tyres' formulas are asked; they hardly depend on it
constexpr double kSmallAngle = 1e-4;  // rad
constexpr double kSmallTurn = 0.1;    // m/s2
constexpr int kIterations = 8;

// Forces of the road on a wheel, ISO 8855: to the left, about the vertical, about the longitudinal axis.
struct Forces {
    double fy, mz, mx;
};

// `angle`: of the wheel to the left of its path; `camber`: top to the right.
Forces forcesOf(const TyreParams& tyre, double load, double angle, double camber) {
    const TyreSteadyState f = steadyState(
        tyre, {.Fz = load, .gamma = camber, .Vx = kSpeed * std::cos(angle), .Vsx = 0, .Vsy = kSpeed * std::sin(angle)});
    return {-f.Fy, -f.Mz, f.Mx};
}

// Yielding of the road wheels of an axle over the sum of their moments, rad/(N m).
double steeringCompliance(const VehicleParams& car, std::size_t axle) {
    if (axle != 0) return 0;
    const SteeringParams& s = car.steering;
    const double ratio = s.ratio_curve.empty() ? s.ratio : s.ratio_curve(0);
    return s.rack_compliance + s.column_compliance / (ratio * ratio);
}

double casterTrail(const VehicleParams& car, std::size_t axle) {
    return axle == 0 ? car.steering.caster_trail : 0;
}

// ---- The turn as a system of equations ----

// Unknowns, in this order; forces and moments are those of single wheels.
constexpr Eigen::Index kForce = 0, kMoment = 4, kSlip = 8, kDifference = 10, kRoll = 12, kYield = 13, kUnknowns = 14;
using Unknowns = Eigen::Vector<double, kUnknowns>;

// What is left over of the equilibrium of the wheels, of the suspension, of the body and of the steering.
Unknowns leftOver(const AtRest& rest, double lateral_acceleration, const Unknowns& x) {
    const VehicleParams& car = rest.car();
    const double roll = x(kRoll), h = rest.height;
    Unknowns r = Unknowns::Zero();
    double side = -car.mass * lateral_acceleration, yaw = 0, tilt = 0, steering = 0;
    PerAxle<double> difference;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto wheel = static_cast<Eigen::Index>(i);
        const std::size_t axle = axleOf(i);
        const AxleParams& a = rest.axle(axle);
        const SuspensionParams& s = a.suspension;
        const double force = x(kForce + wheel), moment = x(kMoment + wheel);

        // Loads, and the travel that roll and the tyres' deflections leave to the suspension.
        const auto travelOf = [&](std::size_t j) {
            const double more = sideSign(j) * 0.5 * x(kDifference + static_cast<Eigen::Index>(axle));
            return rest.travel[j] - more / radialStiffness(rest.tyre[j]) - sideSign(j) * 0.5 * a.track * roll;
        };
        const double load = rest.load[i] + sideSign(i) * 0.5 * x(kDifference + static_cast<Eigen::Index>(axle));
        const double travel = travelOf(i);
        const std::size_t other = i ^ 1U;
        const double static_force = rest.vehicle.corners[i].static_force;
        const double spring = forces(s, {travel, 0, travelOf(other), static_force}).force -
                              forces(s, {rest.travel[i], 0, rest.travel[other], static_force}).force;
        const double links = -rest.vehicle.corners[i].lateral_slope * (force + load * roll);
        difference[axle] += sideSign(i) * (spring + links);

        // Attitude of the wheel, and what its tyre makes of it.
        const WheelAngles at = angles(s, travel, isLeft(i)), yields = compliance(s, 0, force, isLeft(i));
        const double lean = at.camber + yields.camber;
        const double turned = at.toe + yields.toe + s.steer_by_aligning_moment * moment + (axle == 0 ? x(kYield) : 0);
        const Forces tyre =
            forcesOf(rest.tyre[i], load, x(kSlip + static_cast<Eigen::Index>(axle)) + turned, roll + lean);
        r(kForce + wheel) = force - tyre.fy;
        r(kMoment + wheel) = moment - tyre.mz;

        // Its share in the equilibrium of the car. A wheel that leans moves its contact sideways; one that spins
        // resists the yawing.
        const double beside = sideSign(i) * 0.5 * a.track - car.lateral_offset + h * roll + rest.radius[i] * lean;
        side += force;
        yaw += (axle == 0 ? car.front_axle_distance : -rest.rearDistance()) * force + moment;
        tilt +=
            load * beside + h * force + tyre.mx + a.wheel_inertia / rest.tyre[i].parameters.Re * lateral_acceleration;
        if (axle == 0) steering += moment - casterTrail(car, 0) * force;
    }
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const Eigen::Index k = kDifference + static_cast<Eigen::Index>(axle);
        r(k) = x(k) - difference[axle];
    }
    r(kSlip) = side;
    r(kSlip + 1) = yaw;
    r(kRoll) = tilt;
    r(kYield) = x(kYield) - steeringCompliance(car, 0) * steering;
    return r;
}

// By Newton's method from the standing car.
Unknowns turnAt(const AtRest& rest, double lateral_acceleration) {
    Unknowns x = Unknowns::Zero();
    Unknowns step = Unknowns::Constant(kSmallAngle);
    step.segment<8>(kForce).setConstant(1e-3 * rest.car().mass);
    step.segment<2>(kDifference).setConstant(1e-3 * rest.car().mass);
    for (int i = 0; i < kIterations; ++i) {
        Eigen::Matrix<double, kUnknowns, kUnknowns> slopes;
        for (Eigen::Index k = 0; k < kUnknowns; ++k) {
            Unknowns more = x, less = x;
            more(k) += step(k);
            less(k) -= step(k);
            slopes.col(k) = (leftOver(rest, lateral_acceleration, more) - leftOver(rest, lateral_acceleration, less)) /
                            (2 * step(k));
        }
        x -= slopes.fullPivLu().solve(leftOver(rest, lateral_acceleration, x));
    }
    return x;
}

}  // namespace

PerAxle<AxleStiffness> axleStiffness(const AtRest& rest) {
    PerAxle<AxleStiffness> result;
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const SuspensionParams& s = rest.axle(axle).suspension;
        double stiffness = 0, moment = 0, by_camber = 0;
        for (std::size_t i = 2 * axle; i < 2 * axle + 2; ++i) {
            const WheelAngles at = angles(s, rest.travel[i], isLeft(i));
            const auto slope = [&](double angle, double camber) {
                const auto there = [&](double sign) {
                    return forcesOf(rest.tyre[i], rest.load[i], at.toe + sign * angle, at.camber + sign * camber);
                };
                const Forces more = there(1), less = there(-1);
                return Forces{(more.fy - less.fy) / (2 * kSmallAngle), (more.mz - less.mz) / (2 * kSmallAngle), 0};
            };
            const Forces steered = slope(kSmallAngle, 0);
            stiffness += steered.fy;
            moment += steered.mz;
            by_camber += slope(0, kSmallAngle).fy;
        }
        // Angle of the axle per force: slip, less what the force and its moment steer the wheels.
        const double leant = 1 - 0.5 * by_camber * s.camber_by_lateral_force;
        const double yield = steeringCompliance(rest.car(), axle);
        const double by_moment = 0.5 * s.steer_by_aligning_moment + yield;
        const double by_force = 0.5 * s.steer_by_lateral_force - yield * casterTrail(rest.car(), axle);
        result[axle] = {stiffness, 1 / (leant / stiffness * (1 - by_moment * moment) - by_force)};
    }
    return result;
}

TurnSlopes turnSlopes(const AtRest& rest) {
    const Unknowns slope = (turnAt(rest, kSmallTurn) - turnAt(rest, -kSmallTurn)) / (2 * kSmallTurn);
    return {.slip = {slope(kSlip), slope(kSlip + 1)},
            .roll = slope(kRoll),
            .difference = {-slope(kDifference), -slope(kDifference + 1)}};
}

SingleTrack singleTrack(const AtRest& rest, const TurnSlopes& turn) {
    const auto effective = [&](std::size_t axle) {
        const double mass = rest.axleLoad(axle) / kStandardGravity;
        return mass / turn.slip[axle];
    };
    return {.mass = rest.car().mass,
            .inertia = rest.car().inertia.yaw,
            .front_distance = rest.car().front_axle_distance,
            .wheelbase = rest.car().wheelbase,
            .stiffness = {effective(0), effective(1)}};
}

// States: speed to the left, yaw rate, side forces of both axles. An axle that yields to its force by a share of the
// tyres' slip follows by the same share faster.
YawMode yawModeWithLag(const AtRest& rest, const SingleTrack& track, double speed) {
    const PerAxle<double> arm{track.front_distance, track.front_distance - track.wheelbase};
    Eigen::Matrix4d system = Eigen::Matrix4d::Zero();
    system(0, 1) = -speed;
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const auto force = static_cast<Eigen::Index>(2 + axle);
        const double carcass = rest.tyre[2 * axle].parameters.cFy + rest.tyre[2 * axle + 1].parameters.cFy;  // N/m
        const double length = track.stiffness[axle] / carcass;  // m: that of the tyres, C / carcass, by that share
        system(0, force) = 1 / track.mass;
        system(1, force) = arm[axle] / track.inertia;
        system(force, 0) = -track.stiffness[axle] / length;
        system(force, 1) = -track.stiffness[axle] / length * arm[axle];
        system(force, force) = -speed / length;
    }
    YawMode slowest{kUndefined, kUndefined};
    const Eigen::Vector4cd modes = Eigen::EigenSolver<Eigen::Matrix4d>(system, false).eigenvalues();
    for (const std::complex<double>& value : modes) {
        const double size = std::abs(value), frequency = size / (2 * std::numbers::pi);
        if (value.imag() > 0 && !(frequency >= slowest.frequency)) slowest = {frequency, -value.real() / size};
    }
    return slowest;
}

double SingleTrack::understeer() const {
    const double rear = wheelbase - front_distance;
    return mass / wheelbase * (rear / stiffness.front - front_distance / stiffness.rear);
}

double SingleTrack::staticMargin() const {
    const double rear = wheelbase - front_distance;
    return (rear * stiffness.rear - front_distance * stiffness.front) /
           (wheelbase * (stiffness.front + stiffness.rear));
}

double SingleTrack::characteristicSpeed() const {
    return std::sqrt(wheelbase / understeer());
}

double SingleTrack::criticalSpeed() const {
    return std::sqrt(-wheelbase / understeer());
}

double SingleTrack::yawFrequency(double speed) const {
    const double squared = stiffness.front * stiffness.rear * wheelbase * wheelbase / (mass * inertia * speed * speed) *
                           (1 + understeer() / wheelbase * speed * speed);
    return std::sqrt(squared) / (2 * std::numbers::pi);
}

double SingleTrack::yawDamping(double speed) const {
    const double a = front_distance, b = wheelbase - a;
    const double loss = (stiffness.front + stiffness.rear) / (mass * speed) +
                        (a * a * stiffness.front + b * b * stiffness.rear) / (inertia * speed);
    return 0.5 * loss / (2 * std::numbers::pi * yawFrequency(speed));
}

}  // namespace tread::sheet
