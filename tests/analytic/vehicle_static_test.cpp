// The car at rest and in steady straight running: loads, slopes, the start of a drive.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "base/fields/numbers.h"
#include "shared/vehicles.h"

namespace tread::vehicle_static_test {
namespace {

constexpr double kStep = 0.001;  // s
constexpr double kDegree = std::numbers::pi / 180;

// The settling ends when the body accelerates by less than 1e-7 m/s2; 0.05 N leaves room for what the wheels still do.
constexpr double kForce = 0.05;  // N

std::vector<VehicleParams> cars() {
    return {reference::compact(), reference::rearDriveSedan()};
}

double loadOf(const reference::Car& car) {
    double sum = 0;
    for (std::size_t i = 0; i < kWheels; ++i) sum += car.state.wheels[i].load;
    return sum;
}

// ---- Level ----

TEST(AtRest, LoadsOnTheLevelFollowFromTheCentreOfGravity) {
    const PlaneRoad road;
    for (const VehicleParams& params : cars()) {
        const reference::Car car = reference::settled(params, road, {.input = {.brake = 0.3}});
        const double weight = params.mass * kStandardGravity;
        const double rear_distance = params.wheelbase - params.front_axle_distance;
        const double front = 0.5 * weight * rear_distance / params.wheelbase;
        const double rear = 0.5 * weight * params.front_axle_distance / params.wheelbase;
        std::printf("%s: loads front %.2f N (closed form %.2f), rear %.2f N (%.2f)\n", params.name.c_str(),
                    car.state.wheels[0].load, front, car.state.wheels[2].load, rear);
        for (std::size_t i = 0; i < kWheels; ++i)
            EXPECT_NEAR(car.state.wheels[i].load, i < 2 ? front : rear, kForce) << "wheel " << i;
        EXPECT_NEAR(loadOf(car), weight, kForce);
        EXPECT_NEAR(car.motion.position_W.z(), params.centre_of_gravity_height, 1e-4) << "stands at its design height";
    }
}

TEST(AtRest, LoadBesideTheMiddleLiesOnTheWheelsOfItsSide) {
    VehicleParams params = reference::compact();
    params.lateral_offset = 0.05;
    const PlaneRoad road;
    const reference::Car car = reference::settled(params, road, {.input = {.brake = 0.3}});
    const double weight = params.mass * kStandardGravity;
    const double front = weight * (params.wheelbase - params.front_axle_distance) / params.wheelbase;
    // Moments about the middle of each track.
    const auto& w = car.state.wheels;
    EXPECT_NEAR(w[0].load - w[1].load, front * 2 * 0.05 / params.front.track, 2);
    EXPECT_NEAR(w[2].load - w[3].load, (weight - front) * 2 * 0.05 / params.rear.track, 2);
    EXPECT_NEAR(loadOf(car), weight, kForce);
    EXPECT_NEAR(car.output().chassis.roll, 0, 1e-3) << "stands level";
}

TEST(AtRest, LoadsScaleWithGravity) {
    VehicleParams params = reference::compact();
    const PlaneRoad road;
    reference::Car car{.vehicle = prepare(params, 1.62), .road = road};
    const Equilibrium rest = equilibrium(car.vehicle, {road, {0, 0, -1.62}}, {.input = {.brake = 1}});
    double sum = 0;
    for (std::size_t i = 0; i < kWheels; ++i) sum += rest.state.wheels[i].load;
    EXPECT_NEAR(sum, params.mass * 1.62, kForce);
}

// ---- Slopes ----

struct Balance {
    Vector3 force, moment;  // of the road on the car and of its weight, about the centre of gravity of the whole car
};

// Newton and Euler for the car as a whole: independent of how the program splits it into body and wheels.
Balance balance(const reference::Car& car) {
    const Vector3 up = car.motion.orientation * Vector3::UnitZ();
    Vector3 centre = car.motion.position_W;
    for (std::size_t i = 0; i < kWheels; ++i)
        centre += car.vehicle.corners[i].unsprung_mass / car.vehicle.params.mass * car.state.wheels[i].travel * up;
    Balance total{car.vehicle.params.mass * car.gravity_W, Vector3::Zero()};
    for (std::size_t i = 0; i < kWheels; ++i) {
        const reference::RoadForce road = reference::roadForce(car, i);
        const Vector3 normal = car.road.contact(road.point_W, i).normal_W;
        total.force += road.force_W;
        total.moment += (road.point_W - centre).cross(road.force_W) + car.state.wheels[i].mz * normal;
    }
    return total;
}

TEST(AtRest, ParkedOnTwentyPercentGradeRoadCarriesTheWeightInEveryDirection) {
    // In the plane of the road the contact patches hold the car; they settle over seconds.
    constexpr double kMoment = 0.5;  // N m
    const PlaneRoad road(0.2);
    for (const VehicleParams& params : cars()) {
        for (const double heading_deg : {0.0, 180.0, 90.0, 45.0, -135.0}) {
            const reference::Car car =
                reference::settled(params, road, {.heading = heading_deg * kDegree, .input = {.brake = 1}});
            const Balance left = balance(car);
            std::printf("%s, heading %4.0f deg: out of balance by %.3f N, %.3f N m; loads %.0f %.0f %.0f %.0f N\n",
                        params.name.c_str(), heading_deg, left.force.norm(), left.moment.norm(),
                        car.state.wheels[0].load, car.state.wheels[1].load, car.state.wheels[2].load,
                        car.state.wheels[3].load);
            EXPECT_LT(left.force.norm(), 4 * kForce) << heading_deg;
            EXPECT_LT(left.moment.norm(), kMoment) << heading_deg;
        }
    }
}

// Springs so stiff that the car keeps its height and attitude: then the textbook's load transfer holds.
VehicleParams stiff(VehicleParams params) {
    params = reference::simplified(params);
    for (AxleParams* axle : {&params.front, &params.rear}) {
        axle->suspension.spring *= 50;
        axle->suspension.anti_roll_bar = 0;
        axle->suspension.damper.bump = axle->suspension.damper.rebound = 20000;
        axle->tyre.parameters.pz1 *= 20;
    }
    return params;
}

TEST(AtRest, LoadTransferOnAGradeFollowsClosedForm) {
    // The stiff car still sinks by up to a millimetre and tilts by as much over its wheelbase.
    constexpr double kTransfer = 0.003;
    const double grade = 0.2;
    const PlaneRoad road(grade);
    const VehicleParams params = stiff(reference::compact());
    const double angle = std::atan(grade), weight = params.mass * kStandardGravity;
    const double b = params.wheelbase - params.front_axle_distance;
    for (const double up : {1.0, -1.0}) {
        const reference::Car car =
            reference::settled(params, road, {.heading = up > 0 ? 0.0 : std::numbers::pi, .input = {.brake = 1}});
        const double front = 0.5 * weight *
                             (std::cos(angle) * b - up * std::sin(angle) * params.centre_of_gravity_height) /
                             params.wheelbase;
        const double got = 0.5 * (car.state.wheels[0].load + car.state.wheels[1].load);
        const double along =
            car.state.wheels[0].fx + car.state.wheels[1].fx + car.state.wheels[2].fx + car.state.wheels[3].fx;
        std::printf("nose %s a 20 %% grade: front wheel load %.1f N, closed form %.1f N; tyres hold %.1f N of %.1f N\n",
                    up > 0 ? "up" : "down", got, front, along, up * weight * std::sin(angle));
        EXPECT_NEAR(got, front, kTransfer * weight);
        EXPECT_NEAR(along, up * weight * std::sin(angle), 1e-4 * weight);
    }

    // Across the slope, left side up: what the left wheels lose the right ones gain.
    const reference::Car across =
        reference::settled(params, road, {.heading = -std::numbers::pi / 2, .input = {.brake = 1}});
    double left = 0, lateral = 0;
    for (std::size_t i = 0; i < kWheels; ++i) {
        left += isLeft(i) ? across.state.wheels[i].load : 0;
        lateral += across.state.wheels[i].fy;
    }
    const double track = (b * params.front.track + params.front_axle_distance * params.rear.track) / params.wheelbase;
    const double expected =
        weight * (0.5 * std::cos(angle) - std::sin(angle) * params.centre_of_gravity_height / track);
    std::printf("across the grade: left wheels carry %.1f N, closed form %.1f N\n", left, expected);
    EXPECT_NEAR(left, expected, kTransfer * weight);
    EXPECT_NEAR(lateral, weight * std::sin(angle), 1e-4 * weight) << "the tyres push the car up, to its left";
}

// ---- Steady straight running ----

TEST(SteadyRunning, ForcesAndTorquesBalanceDragAndRollingResistance) {
    const PlaneRoad road;
    const double speed = 30;
    for (const VehicleParams& params : cars()) {
        const reference::Car car = reference::settled(params, road, {.speed = speed});
        const double pressure = 0.5 * params.aero.air_density * speed * speed;
        const double drag = pressure * params.aero.drag_area;
        const double lift = pressure * (params.aero.front_lift_area + params.aero.rear_lift_area);

        double along = 0, torque = 0, needed = 0;
        for (std::size_t i = 0; i < kWheels; ++i) {
            const WheelState& wheel = car.state.wheels[i];
            const TyreParams& tyre = car.vehicle.corners[i].tyre;
            along += std::cos(wheel.steer) * wheel.fx - std::sin(wheel.steer) * wheel.fy;
            torque += wheel.drive_torque;
            needed += wheel.radius * wheel.fx + tyre.parameters.qy1 * wheel.load * 2 / std::numbers::pi *
                                                    std::atan(tyre.parameters.Re * wheel.spin);  // (85)
        }
        std::printf(
            "%s at 30 m/s: tyres push %.3f N, drag %.3f N; loads %.2f N, weight less lift %.2f N; drive torque "
            "%.3f N m, needed %.3f N m; throttle %.3f\n",
            params.name.c_str(), along, drag, loadOf(car), params.mass * kStandardGravity - lift, torque, needed,
            car.input.throttle);
        // Lift stands on the body, which pitches.
        EXPECT_NEAR(along, drag - lift * car.output().chassis.pitch, 0.05);
        EXPECT_NEAR(loadOf(car), params.mass * kStandardGravity - lift, 0.1);
        EXPECT_NEAR(torque, needed, 0.05);

        // Moments about the rear axle: drag at its height, lift, weight.
        const double b = params.wheelbase - params.front_axle_distance;
        const double front = (params.mass * kStandardGravity * b - drag * params.aero.height) / params.wheelbase -
                             pressure * params.aero.front_lift_area;
        double resistance = 0;
        for (std::size_t i = 0; i < kWheels; ++i)
            resistance += car.vehicle.corners[i].tyre.parameters.qy1 * car.state.wheels[i].load;
        // Rolling resistance is a load that acts ahead of the axle: it tips the car backwards. The centre of gravity
        // moves with the body's pitch.
        const double got = car.state.wheels[0].load + car.state.wheels[1].load;
        const double tipped = -resistance / params.wheelbase;
        const double pitch = car.output().chassis.pitch;
        const double shifted = params.mass * kStandardGravity * pitch *
                               (params.centre_of_gravity_height - car.state.wheels[0].radius) / params.wheelbase;
        std::printf("  front axle load %.2f N, closed form %.2f N (of that rolling resistance %.2f N, pitch %.2f N)\n",
                    got, front + tipped + shifted, tipped, shifted);
        EXPECT_NEAR(got, front + tipped + shifted, 1.5);

        // Engine power, gearbox losses and tyre power agree.
        const DrivelineParams& drive = params.driveline;
        const double ratio =
            drive.gearbox.ratios[static_cast<std::size_t>(car.state.driveline.gear - 1)] * drive.gearbox.final_drive;
        EXPECT_NEAR(car.state.engine_torque * ratio * drive.gearbox.efficiency, torque, 1e-3 * torque);
        EXPECT_GT(car.input.throttle, 0);
        EXPECT_LT(car.input.throttle, 1);
    }
}

TEST(SteadyRunning, NothingMovesForTwoSecondsAfterTheStart) {
    constexpr double kStill = 1e-6;  // m/s and rad/s
    struct Case {
        const char* name;
        double grade, bank, heading_deg, speed;
    };
    for (const VehicleParams& params : cars()) {
        for (const Case& c : {Case{"level, 80 km/h", 0, 0, 0, 80 / 3.6},
                              {"level, 130 km/h", 0, 0, 0, 130 / 3.6},
                              {"level, 20 km/h, any heading", 0, 0, 37, 20 / 3.6},
                              {"5 % up at 80 km/h", 0.05, 0, 0, 80 / 3.6},
                              {"2 % down at 80 km/h", -0.02, 0, 0, 80 / 3.6},
                              {"3 % up at 36 km/h", 0.03, 0, 0, 10},
                              {"up a bank at 80 km/h", 0, 0.04, 90, 80 / 3.6}}) {
            const PlaneRoad road(c.grade, c.bank);
            reference::Car car =
                reference::settled(params, road, {.heading = c.heading_deg * kDegree, .speed = c.speed});
            const Vector3 velocity = car.motion.velocity_W;
            double moved = 0, turned = 0;
            for (int k = 0; k < 2000; ++k) {
                car.step(kStep);
                moved = std::max(moved, (car.motion.velocity_W - velocity).norm());
                turned = std::max(turned, car.motion.angular_velocity_W.norm());
            }
            std::printf("%-28s %-28s velocity changes by %.1e m/s, turns at %.1e rad/s, throttle %.3f\n",
                        params.name.c_str(), c.name, moved, turned, car.input.throttle);
            EXPECT_LT(moved, kStill) << params.name << ", " << c.name;
            EXPECT_LT(turned, kStill) << params.name << ", " << c.name;
        }
    }
}

TEST(AtRest, ParkedCarStays) {
    struct Case {
        double heading_deg, duration;
    };
    // Across the slope the aligning torque of a tyre that stands, which follows the sign of Vx over 0.01 m/s (34),
    // (35), feeds a slow yaw oscillation: after half a minute it would show.
    for (const Case& c : {Case{0, 60}, {180, 10}, {90, 10}, {45, 10}}) {
        const PlaneRoad road(0.2);
        reference::Car car =
            reference::settled(reference::compact(), road, {.heading = c.heading_deg * kDegree, .input = {.brake = 1}});
        const Vector3 place = car.motion.position_W;
        for (long k = 0; k < std::lround(c.duration / kStep); ++k) car.step(kStep);
        const double crept = (car.motion.position_W - place).norm();
        std::printf("parked for %.0f s on 20 %%, heading %.0f deg: crept %.1e m\n", c.duration, c.heading_deg, crept);
        EXPECT_LT(crept, 1e-7);
    }
}

}  // namespace
}  // namespace tread::vehicle_static_test
