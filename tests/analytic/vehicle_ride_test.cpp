// Ride: the car against a linear model of body and four wheels written on its own, and the energy of an undamped car.

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <cstdio>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "shared/linear_ride.h"
#include "vehicle/tyre_load.h"

namespace tread::vehicle_ride_test {
namespace {

using reference::coordinates;
using reference::linearCar;
using reference::linearModel;
using reference::Vector14;
using reference::Vector7;

constexpr double kStep = 0.001;  // s

// ---- The car on a road without friction, where nothing but the ride can move ----

struct Disturbance {
    const char* name;
    double heave, roll, pitch;  // m, rad: of the body, wheels on the ground as they were
    double hop;                 // m: of the front left wheel
};

// Largest difference to the linear solution over two seconds, as a share of the largest movement of that coordinate
// (angles and heave measured together as movement of the body's corners).
double deviation(const VehicleParams& params, const Disturbance& d) {
    const PlaneRoad ice(0, 0, 0);
    const reference::Car rest = reference::settled(params, ice, {});
    reference::Car car = rest;
    car.motion.position_W.z() += d.heave;
    car.motion.orientation = Quaternion(Eigen::AngleAxisd(d.pitch, Vector3::UnitY())) *
                             Quaternion(Eigen::AngleAxisd(d.roll, Vector3::UnitX())) * car.motion.orientation;
    Vector14 x = Vector14::Zero();
    x.head<3>() << d.heave, d.roll, d.pitch;
    x(3) = d.hop;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vector3& hub = car.vehicle.corners[i].hub_B;
        const double body = d.heave + hub.y() * d.roll - hub.x() * d.pitch;
        WheelState& wheel = car.state.wheels[i];
        wheel.travel += (i == 0 ? d.hop : 0) - body;
        if (i == 0) wheel.vertical_force = wheel.load -= params.front.tyre.parameters.pz1 * d.hop;
    }
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = car.state.wheels[i];
        wheel.suspension_force = forces(i < 2 ? params.front.suspension : params.rear.suspension,
                                        {.travel = wheel.travel,
                                         .rate = 0,
                                         .opposite_travel = car.state.wheels[i ^ 1].travel,
                                         .static_force = car.vehicle.corners[i].static_force})
                                     .force;
    }

    const Eigen::MatrixXd over_step = (linearModel(params).system() * kStep).exp();
    // The accelerations of the first instant, that the velocity Verlet step starts from.
    const Vector14 slope = linearModel(params).system() * x;
    car.state.acceleration_W = {0, 0, slope(7)};
    car.state.angular_acceleration_W = {slope(8), slope(9), 0};

    double largest = 0, error = 0;
    for (double t = 0; t < 2; t += kStep) {
        car.step(kStep);
        x = over_step * x;
        const Vector7 q = coordinates(car, rest);
        for (int k = 0; k < 7; ++k) {
            const double arm = k == 0 || k > 2 ? 1 : k == 1 ? 0.5 * params.front.track : 0.5 * params.wheelbase;
            largest = std::max(largest, arm * std::abs(x(k)));
            error = std::max(error, arm * std::abs(x(k) - q(k)));
        }
    }
    return error / largest;
}

// A disturbance of 1 mm leaves the geometry linear to about 1e-3; the step of 1 ms adds (70 rad/s)^2 dt^2 / 12 of the
// hop's phase per radian.
constexpr double kLinearTolerance = 0.01;

TEST(Ride, BodyAndWheelsFollowIndependentLinearModel) {
    for (const VehicleParams& shipped : {reference::compact(), reference::rearDriveSedan()}) {
        const VehicleParams params = linearCar(shipped);
        const auto eigenvalues = linearModel(params).system().eigenvalues();
        std::printf("%s, linear modes:", params.name.c_str());
        for (const std::complex<double>& s : eigenvalues) {
            if (s.imag() > 0)
                std::printf(" %.3f Hz (damping %.2f)", std::abs(s) / 2 / std::numbers::pi, -s.real() / std::abs(s));
        }
        std::printf("\n");
        for (const Disturbance& d : {Disturbance{"heave", 1e-3, 0, 0, 0},
                                     {"roll", 0, 1e-3, 0, 0},
                                     {"pitch", 0, 0, 1e-3, 0},
                                     {"wheel hop", 0, 0, 0, 1e-3}}) {
            const double error = deviation(params, d);
            std::printf("  %-10s largest deviation from the linear model %.3f %%\n", d.name, 100 * error);
            EXPECT_LT(error, kLinearTolerance) << params.name << ", " << d.name;
        }
    }
}

// ---- Energy ----

// As an observer sees it who drives along at `speed`.
double energy(const reference::Car& car, double speed = 0) {
    const VehicleParams& params = car.vehicle.params;
    const Eigen::Matrix3d body = car.motion.orientation.toRotationMatrix();
    const Vector3 v = body.transpose() * (car.motion.velocity_W - Vector3(speed, 0, 0));
    const Vector3 w = body.transpose() * car.motion.angular_velocity_W;
    double sum = 0.5 * params.mass * v.squaredNorm() + params.mass * kStandardGravity * car.motion.position_W.z() +
                 0.5 * (params.inertia.roll * w.x() * w.x() + params.inertia.pitch * w.y() * w.y() +
                        params.inertia.yaw * w.z() * w.z());
    for (std::size_t i = 0; i < kWheels; ++i) {
        const AxleParams& axle = i < 2 ? params.front : params.rear;
        const WheelState& wheel = car.state.wheels[i];
        const Vehicle::Corner& corner = car.vehicle.corners[i];
        const double hub = (v + w.cross(corner.hub_B)).z();
        sum += 0.5 * corner.unsprung_mass * (std::pow(hub + wheel.rate, 2) - hub * hub);
        sum += corner.unsprung_mass * kStandardGravity * wheel.travel * body(2, 2);
        // Springs push only: below no length does the force go on.
        const double k = axle.suspension.spring;
        const double force = std::max(corner.static_force + k * wheel.travel, 0.0);
        sum += 0.5 * force * force / k;
        sum += 0.5 * axle.tyre.parameters.pz1 * std::pow(std::max(axle.tyre.parameters.Ro - wheel.radius, 0.0), 2);
        if (i % 2 == 0) {
            const double twist = wheel.travel - car.state.wheels[i + 1].travel;
            sum += 0.5 * axle.suspension.anti_roll_bar * twist * twist;
        }
    }
    return sum;
}

struct Span {
    double lowest, highest;
    double deepest = 0;  // deflection of a tyre, over that at which its rim carries, which loses energy
};

// Energy over 20 s as a share of what was put in above rest.
Span energyKept(VehicleParams params, double drop, double roll_rate, double pitch_rate, double speed) {
    params = linearCar(params);
    for (AxleParams* axle : {&params.front, &params.rear}) {
        axle->suspension.damper.bump = axle->suspension.damper.rebound = 0;
        axle->tyre.parameters.pz2 = 0;
        axle->tyre.parameters.qy1 = 0;
    }
    const PlaneRoad ice(0, 0, 0);
    VehicleParams damped = linearCar(reference::compact());
    damped = params;
    for (AxleParams* axle : {&damped.front, &damped.rear})
        axle->suspension.damper.bump = axle->suspension.damper.rebound = 2000;
    reference::Car car = reference::settled(damped, ice, {});
    car.vehicle = prepare(params);
    const double rest = energy(car);
    car.motion.position_W.z() += drop;
    for (WheelState& wheel : {std::ref(car.state.wheels[0]), std::ref(car.state.wheels[1]),
                              std::ref(car.state.wheels[2]), std::ref(car.state.wheels[3])})
        wheel.radius += drop;
    car.motion.velocity_W.x() = speed;
    car.motion.angular_velocity_W = {roll_rate, pitch_rate, 0};
    car.step(1e-9);  // forces at the start
    const double given = energy(car, speed) - rest;
    Span span{1, 1};
    for (double t = 0; t < 20; t += kStep) {
        car.step(kStep);
        const double share = (energy(car, speed) - rest) / given;
        span.lowest = std::min(span.lowest, share);
        span.highest = std::max(span.highest, share);
        for (std::size_t i = 0; i < kWheels; ++i) {
            const double Ro = car.vehicle.corners[i].tyre.parameters.Ro;
            span.deepest = std::max(span.deepest, (Ro - car.state.wheels[i].radius) / (kRimDeflection * Ro));
        }
    }
    return span;
}

TEST(Ride, UndampedBounceKeepsItsEnergyForTwentySeconds) {
    struct Case {
        const char* name;
        double drop, roll_rate, pitch_rate, speed;
    };
    for (const Case& c : {Case{"dropped by 20 mm", 0.02, 0, 0, 0},
                          {"dropped by 100 mm, wheels leave the road", 0.1, 0, 0, 0},
                          {"rolling and pitching", 0.0, 0.3, 0.2, 0},
                          {"pitching at 30 m/s", 0.0, 0, 0.3, 30},
                          {"thrown, all at once", 0.08, 0.3, 0.3, 0}}) {
        const Span kept = energyKept(reference::compact(), c.drop, c.roll_rate, c.pitch_rate, c.speed);
        std::printf("energy over 20 s, %-42s %.3f to %.3f %%\n", c.name, 100 * kept.lowest, 100 * kept.highest);
        EXPECT_LT(kept.deepest, 1) << c.name << ": not on its rims";
        EXPECT_GT(kept.lowest, 0.99) << c.name;
        EXPECT_LT(kept.highest, 1.01) << c.name;
    }
}

}  // namespace
}  // namespace tread::vehicle_ride_test
