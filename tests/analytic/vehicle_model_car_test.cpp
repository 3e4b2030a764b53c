// A car of scale 1:10 (vehicles/dart.yaml), of 1.6 kg on a wheelbase of 0.17 m: nothing in tread takes the size of a
// road car for granted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "metrics/metrics.h"
#include "report/car_shape.h"
#include "shared/vehicle_run.h"

namespace tread::vehicle_model_car_test {
namespace {

using namespace shared;

const VehicleParams& dart() {
    static const VehicleParams car = loadVehicle(sourceFile("vehicles/dart.yaml"));
    return car;
}

double metricOf(const std::vector<Metric>& metrics, std::string_view name) {
    const auto found =
        std::find_if(metrics.begin(), metrics.end(), [&](const Metric& metric) { return metric.name == name; });
    return found == metrics.end() ? std::nan("") : found->value;
}

// The makers' fit to motion capture: side force of an axle over its load.
struct PublishedAxle {
    const TyreParams& tyre;
    double load;  // N, of the axle
    double d, c, b;

    double sideForce(double slip_angle) const { return load * d * std::sin(c * std::atan(b * slip_angle)); }
    double modelled(double slip_angle) const {
        return 2 * steadyState(tyre, {.Fz = 0.5 * load, .Vx = 2, .Vsy = -2 * std::tan(slip_angle)}).Fy;
    }
};

TEST(ModelCar, AxleSideForcesAreThoseThatItsMakersFitted) {
    const PublishedAxle front{dart().front.tyre, 0.847 * 9.81, 0.8407, 0.8407, 8.598};
    const PublishedAxle rear{dart().rear.tyre, 0.733 * 9.81, 0.8547, 0.9591, 11.549};
    for (const PublishedAxle& axle : {front, rear}) {
        for (double slip_angle = 0.01; slip_angle < 0.4; slip_angle += 0.01)
            EXPECT_NEAR(axle.modelled(slip_angle), axle.sideForce(slip_angle), 0.015 * axle.load) << slip_angle;
    }
}

TEST(ModelCar, ForceAtItsWheelsIsThatWhichItsMakersFitted) {
    const MotorParams& motor = *dart().driveline.motor;
    const double radius = dart().front.tyre.parameters.Re, ratio = dart().driveline.gearbox.final_drive;
    const double rolling = dart().front.tyre.parameters.qy1 / dart().front.tyre.parameters.Ro * 1.58 * 9.81;  // N
    for (const double v : {0.5, 1.0, 2.0, 3.0}) {
        const double resistance = 1.266 * std::tanh(7.666 * v) + 0.7393 * v - 0.1123 * v * v;
        for (const double throttle : {0.3, 0.5, 1.0}) {
            const double force = motorTorque(motor, throttle, 0, v / radius * ratio).total * ratio / radius - rolling;
            EXPECT_NEAR(force, (25.358 - 4.815 * v) * (throttle - 0.1638) - resistance, 0.3) << v << ", " << throttle;
        }
    }
}

TEST(ModelCar, StandsAsItsAxleLoadsSay) {
    Scenario stand = scenario("parked_on_slope");
    stand.road.grade = 0;
    stand.phases.front().until.duration = 2;
    const Log log = simulate(dart(), stand);
    const double front = channel(log, "wheel.front_left.load").back() + channel(log, "wheel.front_right.load").back();
    EXPECT_NEAR(front / kStandardGravity, 0.847, 0.002);
    EXPECT_LT(peak(log, "chassis.vz"), 1e-6) << "no impact at the start";
}

TEST(ModelCar, HoldsOnASlopeOfTwentyPercent) {
    const Log log = simulate(dart(), scenario("parked_on_slope"));
    const double moved = std::hypot(channel(log, "chassis.x").back() - valueAt(log, "chassis.x", 1),
                                    channel(log, "chassis.y").back() - valueAt(log, "chassis.y", 1));
    EXPECT_LT(moved, 1e-6);
}

TEST(ModelCar, StepSteerSettlesAtTheSteadyTurnOfTheMakersCurves) {
    const Log log = simulate(dart(), scenario("model_car/step_steer"));
    const std::vector<Metric> found = metrics(log, "step_steer");
    const double ay = metricOf(found, "steady_ay"), speed = channel(log, "chassis.vx").back();
    // Steady turn of a single-track car: delta = L / R + alpha_f - alpha_r, each axle at its slip angle.
    const auto slip = [&](double d, double c, double b) { return std::tan(std::asin(ay / 9.81 / d) / c) / b; };
    const double steer =
        dart().wheelbase * ay / (speed * speed) + slip(0.8407, 0.8407, 8.598) - slip(0.8547, 0.9591, 11.549);
    EXPECT_NEAR(steer, channel(log, "driver.steering_wheel_angle").back(), 0.07 * steer);
    EXPECT_EQ(metricOf(found, "steady"), 1);
}

TEST(ModelCar, BrakesWithinItsGrip) {
    const Log log = simulate(dart(), scenario("model_car/straight_braking"));
    const double mfdd = metricOf(metrics(log, "straight_braking"), "mfdd");
    EXPECT_GT(mfdd, 6);
    EXPECT_LT(mfdd, 0.86 * kStandardGravity);
    EXPECT_LT(std::abs(channel(log, "chassis.vx").back()), 1e-3) << "and stands, rocking on its springs";
}

TEST(ModelCar, CircleWithTheSteeringHeldHasItsUndersteer) {
    const Log log = simulate(dart(), scenario("model_car/constant_steer"));
    const std::vector<Metric> found =
        metrics(log, "steady_circle", {.wheelbase = dart().wheelbase, .steering_ratio = 1});
    // From the makers' slopes at the origin, (1 / (d c b)_f - 1 / (d c b)_r) per g; curved upwards beyond.
    const double linear = (1 / (0.8407 * 0.8407 * 8.598) - 1 / (0.8547 * 0.9591 * 11.549)) * 180 / M_PI;
    EXPECT_GT(metricOf(found, "understeer_gradient"), linear);
    EXPECT_LT(metricOf(found, "understeer_gradient"), 2.5 * linear);
}

TEST(ModelCar, TheSameBitsWithEveryRun) {
    const Log one = simulate(dart(), scenario("model_car/step_steer"));
    const Log other = simulate(dart(), scenario("model_car/step_steer"));
    EXPECT_EQ(channel(one, "chassis.yaw_rate"), channel(other, "chassis.yaw_rate"));
}

TEST(ModelCar, YawRateHardlyDependsOnTheStep) {
    Scenario coarse = scenario("model_car/step_steer"), fine = coarse;
    coarse.step = 0.004, fine.step = 0.00025;
    for (Scenario* one : {&coarse, &fine}) one->log.rate = 50;
    const Log slow = simulate(dart(), coarse), quick = simulate(dart(), fine);
    for (double t = 0; t < 3.9; t += 0.1)
        EXPECT_NEAR(valueAt(slow, "chassis.yaw_rate", t), valueAt(quick, "chassis.yaw_rate", t),
                    0.01 * peak(quick, "chassis.yaw_rate"))
            << t;
}

TEST(ModelCar, ItsDrawingIsAsLargeAsTheCar) {
    const CarShape shape = carShape(dart());
    EXPECT_NEAR(shape.length(), 0.28, 0.05);
    EXPECT_NEAR(shape.width, 0.094, 0.02);
    const CarShape medium = typicalCarShape();
    EXPECT_NEAR(medium.length(), 4.3, 0.1);
    EXPECT_NEAR(medium.width, 1.78, 0.02);
}

}  // namespace
}  // namespace tread::vehicle_model_car_test
