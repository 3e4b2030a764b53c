// The car's answer to small steering over frequency, against the linear single-track model whose tyres answer through
// the carcass of (17)-(22): mc v'' + kFy v' + cFy v = C alpha*, alpha* = alpha - v' / V, Fy = cFy v + kFy v', so
//   Fy / (C alpha) = (cFy + kFy s) / (mc s^2 + (kFy + C / V) s + cFy),
// which for low frequencies is the relaxation length (28), C / cFy.

#include <gtest/gtest.h>

#include <complex>
#include <cstdio>
#include <numbers>

#include "metrics/frequency_response.h"
#include "scenario/signals.h"
#include "shared/vehicles.h"

namespace tread::vehicle_frequency_test {
namespace {

using Complex = std::complex<double>;

constexpr double kStep = 0.001;  // s
constexpr double kAgreement = 0.01;
constexpr double kAgreementAngle = 0.6 * std::numbers::pi / 180;  // a hundredth of a radian

// Linear range, no roll, no rolling resistance: what the model leaves out.
VehicleParams linear(VehicleParams car) {
    car = reference::simplified(car);
    car.inertia.roll = 1e9;
    car.front.tyre.lambda.My = car.rear.tyre.lambda.My = 0;
    return car;
}

struct Axle {
    double stiffness;  // N/rad, both wheels
    double trail;      // m, of the force behind the axle
    TyreCoefficients tyre;

    // Lateral force over the slip angle of the rim.
    Complex force(Complex s, double speed) const {
        const Complex lag =
            (tyre.cFy + tyre.kFy * s) / (tyre.mc * s * s + (tyre.kFy + 0.5 * stiffness / speed) * s + tyre.cFy);
        return stiffness * lag;
    }
};

Axle axleOf(const AxleParams& axle, double load) {
    constexpr double kSmall = 1e-4, kSpeed = 20;
    const auto at = [&](double slip) {
        return steadyState(
            axle.tyre,
            {.Fz = load, .gamma = 0, .Vx = kSpeed * std::cos(slip), .Vsx = 0, .Vsy = kSpeed * std::sin(slip)});
    };
    const TyreSteadyState more = at(kSmall), less = at(-kSmall);
    const double stiffness = -(more.Fy - less.Fy) / kSmall;  // of two wheels
    const double moment = -(more.Mz - less.Mz) / kSmall;
    return {stiffness, -moment / stiffness, axle.tyre.parameters};
}

// As the car yaws, the outer wheels have to turn faster: what their forces take for that adds to the yaw inertia.
double yawInertia(const VehicleParams& car) {
    double sum = car.inertia.yaw;
    for (const AxleParams* axle : {&car.front, &car.rear}) {
        const double lever = 0.5 * axle->track / axle->tyre.parameters.Re;
        sum += 2 * axle->wheel_inertia * lever * lever;
    }
    return sum;
}

struct Answer {
    Complex yaw_rate, ay;  // over the steering-wheel angle
};

Answer closedForm(const VehicleParams& car, double speed, double frequency) {
    const double a = car.front_axle_distance, b = car.wheelbase - a;
    const double weight = car.mass * kStandardGravity;
    const Axle front = axleOf(car.front, 0.5 * weight * b / car.wheelbase);
    const Axle rear = axleOf(car.rear, 0.5 * weight * a / car.wheelbase);
    const Complex s(0, 2 * std::numbers::pi * frequency);
    const Complex f = front.force(s, speed), r = rear.force(s, speed);
    // Unknowns vy and yaw rate, for a road-wheel angle of 1.
    Eigen::Matrix2cd system;
    const double lf = a - front.trail, lr = b + rear.trail;
    system << car.mass * s + (f + r) / speed, car.mass * speed + (a * f - b * r) / speed, (lf * f - lr * r) / speed,
        yawInertia(car) * s + (lf * a * f + lr * b * r) / speed;
    const Eigen::Vector2cd x = system.inverse() * Eigen::Vector2cd(f, lf * f);
    return {x[1] / car.steering.ratio, (s * x[0] + speed * x[1]) / car.steering.ratio};
}

Log sweepOf(const VehicleParams& params, double speed) {
    const PlaneRoad road;
    const SteeringSignal sweep = Sweep<Angle>{3 * std::numbers::pi / 180, 0.1, 4, 40, SweepLaw::logarithmic};
    reference::Car car = reference::settled(params, road, {.speed = speed});
    Log log{{{"time", "s", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"chassis.vx", "m/s", {}},
             {"chassis.yaw_rate", "rad/s", {}},
             {"chassis.ay", "m/s2", {}}}};
    constexpr long kEvery = 5;  // 200 Hz
    for (long k = 0; k <= 46000; ++k) {
        const double t = static_cast<double>(k) * kStep;
        if (k % kEvery == 0) {
            const ChassisOutput out = car.output().chassis;
            const double row[] = {t, car.input.steering_wheel_angle, out.vx, out.yaw_rate, out.ay};
            for (std::size_t i = 0; i < log.channels.size(); ++i) log.channels[i].values.push_back(row[i]);
        }
        VehicleInput next = car.input;
        next.steering_wheel_angle = t + kStep < 1 ? 0 : valueAt(sweep, 0, t + kStep - 1);
        car.step(next, kStep);
    }
    return log;
}

TEST(FrequencyOfTheCar, AnswersAsTheSingleTrackModelWithTyresThatLag) {
    for (const VehicleParams& shipped : {reference::compact(), reference::rearDriveSedan()}) {
        const VehicleParams car = linear(shipped);
        for (const double speed : {15.0, 28.0}) {
            const SteeringResponse found = steeringResponse(sweepOf(car, speed));
            for (const double f : {0.2, 0.5, 1.0, 1.5, 2.0, 3.0}) {
                const Answer expected = closedForm(car, found.speed, f);
                const auto compare = [&](const std::vector<FrequencyPoint>& points, Complex transfer,
                                         const char* what) {
                    std::printf("%s, %.0f m/s, %.1f Hz: %s gain %.4f (closed form %.4f), lag %.2f deg (%.2f)\n",
                                car.name.c_str(), speed, f, what, gainAt(points, f), std::abs(transfer),
                                phaseLagAt(points, f) * 180 / std::numbers::pi,
                                -std::arg(transfer) * 180 / std::numbers::pi);
                    EXPECT_NEAR(gainAt(points, f), std::abs(transfer), kAgreement * std::abs(transfer));
                    EXPECT_NEAR(phaseLagAt(points, f), -std::arg(transfer), kAgreementAngle);
                };
                compare(found.yaw_rate, expected.yaw_rate, "yaw rate");
                compare(found.ay, expected.ay, "ay");
            }
        }
    }
}

}  // namespace
}  // namespace tread::vehicle_frequency_test
