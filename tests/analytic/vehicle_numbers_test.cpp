// Every number of a car's file acts, the optional ones not at their default, and nothing else does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "base/numbers.h"
#include "shared/vehicles.h"

namespace tread {
namespace {

constexpr double kStep = 0.001;  // s

struct Drive {
    reference::Car start;
    int steps;
    VehicleInput (*driver)(double t, VehicleInput in);
};

// Short drives that between them use every part of the car.
std::vector<Drive> drives(const VehicleParams& params) {
    static const PlaneRoad level, slope(0.03, 0.02, 0.9);
    std::vector<Drive> all;
    // Turning with throttle and brakes, on a slope, at speeds that use all gears.
    for (const double speed : {30.0, 16.0, 12.0, 8.0}) {
        all.push_back(Drive{reference::settled(params, slope, {.speed = speed}), 200, [](double t, VehicleInput in) {
                                in.steering_wheel_angle = 1.5 * std::sin(15 * t);
                                in.throttle = t < 0.1 ? 0.7 : 0;
                                in.brake = t < 0.1 ? 0 : 0.35;
                                return in;
                            }});
    }
    // Dropped askew onto its stops.
    reference::Car dropped = reference::settled(params, level, {.input = {.brake = 0.5}});
    dropped.motion.position_W.z() += 0.4;
    dropped.motion.angular_velocity_W = {0.6, 0.4, 0.2};
    all.push_back(Drive{dropped, 600, [](double, VehicleInput in) { return in; }});
    // Revving up declutched to the speed limit, letting the clutch in.
    all.push_back(
        Drive{reference::settled(params, level, {.input = {.brake = 0.5}}), 900, [](double t, VehicleInput in) {
                  in.throttle = 1;
                  in.clutch = t < 0.7 ? 1 : 0;
                  return in;
              }});
    // Letting the hand wheel go in a turn.
    all.push_back(Drive{reference::settled(params, level, {.speed = 15}), 300, [](double t, VehicleInput in) {
                            in.steering_wheel_angle = std::min(4 * t, 0.6);
                            in.hands_off = t < 0.2 ? 0 : 1;
                            return in;
                        }});
    // Into the shift up from first gear, at full throttle, and down from second.
    const GearboxParams& box = params.driveline.gearbox;
    const auto inGear = [&](std::size_t gear, double gearbox_speed, double throttle) {
        const double ratio = box.ratios[gear - 1] * box.final_drive;
        const double speed = gearbox_speed / ratio * params.front.tyre.parameters.Re;
        reference::Car car = reference::settled(params, level, {.speed = speed});
        car.state.driveline.gear = static_cast<int>(gear);
        car.state.driveline.engine_speed = car.state.driveline.gearbox_speed = gearbox_speed;
        car.input.throttle = throttle;
        return car;
    };
    all.push_back(Drive{inGear(1, 0.99 * box.shift_up_speed, 1), 300, [](double, VehicleInput in) { return in; }});
    all.push_back(Drive{inGear(2, 1.06 * box.shift_down_speed, 0), 300, [](double, VehicleInput in) {
                            in.brake = 0.2;
                            return in;
                        }});
    // Pulling in every gear.
    for (std::size_t gear = 1; gear <= box.ratios.size(); ++gear) {
        const double speed = 0.5 * (box.shift_up_speed + box.shift_down_speed);
        all.push_back(Drive{inGear(gear, speed, 1), 50, [](double, VehicleInput in) { return in; }});
    }
    return all;
}

// Everything that a log would hold.
std::vector<double> log(const Drive& drive, const VehicleParams& params) {
    std::vector<double> values;
    reference::Car car{.vehicle = prepare(params),
                       .road = drive.start.road,
                       .motion = drive.start.motion,
                       .state = drive.start.state,
                       .input = drive.start.input};
    VehicleOutput out;
    const std::vector<Number> channels = numbers(out);
    for (int k = 1; k <= drive.steps; ++k) {
        car.step(drive.driver(k * kStep, car.input), kStep);
        if (k % 20 != 0) continue;
        out = car.output();
        for (const Number& n : channels) values.push_back(*n.value);
    }
    return values;
}

bool identical(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST(NumbersOfACar, EachOneIsFelt) {
    // A number that the program reads and forgets would leave the log as it is.
    VehicleParams params = reference::compact();
    // What the shipped car has not may still be wanted.
    params.inertia.roll_yaw = 20;
    params.rear.suspension.steer_by_lateral_force = 1e-6;
    params.driveline.front_share = 0.6;
    for (AxleParams* axle : {&params.front, &params.rear}) {
        axle->suspension.damper.friction = 30;
        axle->suspension.side_view_slope_driving = 0.05;
        axle->tyre.parameters.pVx1 = 0.01;
        axle->tyre.parameters.qx1 = 1e-5;
        axle->suspension.steer_by_aligning_moment = 1e-5;
        axle->suspension.steer_by_longitudinal_force = 1e-6;
        axle->suspension.camber_by_lateral_force = 1e-6;
        axle->suspension.longitudinal_compliance = 1e-6;
        axle->tyre_surroundings = {.pressure = {.inflation = 200000,
                                                .radial_stiffness = 0.7,
                                                .slip_stiffness = 0.2,
                                                .cornering_stiffness = 0.5,
                                                .cornering_peak_load = 0.4},
                                   .temperature = {.start = 300,
                                                   .heat_capacity = 2000,
                                                   .slip_share = 0.7,
                                                   .cooling = 10,
                                                   .cooling_by_speed = 1,
                                                   .friction = 0.001,
                                                   .friction_squared = -1e-5,
                                                   .stiffness = -0.002},
                                   .ply_steer = 0.001,
                                   .conicity = 0.002};
    }
    // One wheel wears another tyre than its axle.
    params.rear.right = {.tyre = params.rear.tyre, .tyre_surroundings = params.rear.tyre_surroundings};
    params.rear.right.tyre->parameters.Ro -= 0.002;
    params.steering = {.ratio = params.steering.ratio,
                       .ratio_curve = {},
                       .ackermann = params.steering.ackermann,
                       .delay = 0.012,
                       .lag = 0.02,
                       .play = 0.02,
                       .column_compliance = 0.005,
                       .rack_compliance = 2e-5,
                       .caster_trail = 0.02,
                       .scrub_radius = 0.01,
                       .inertia = 0.05,
                       .damping = 0.2,
                       .friction = 0.3};
    const std::vector<Drive> all_drives = drives(params);
    std::vector<std::vector<double>> before;
    for (const Drive& drive : all_drives) before.push_back(log(drive, params));
    for (const auto& values : before)
        EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }));

    std::size_t felt = 0;
    const std::vector<Number> all = numbers(params);
    for (const Number& n : all) {
        const double value = *n.value;
        *n.value = value - 0.01 * (std::abs(value) + (value == 0 ? 0.1 : 0.0));
        bool changed = false;
        for (std::size_t i = 0; i < all_drives.size() && !changed; ++i)
            changed = !identical(log(all_drives[i], params), before[i]);
        EXPECT_TRUE(changed) << n.path;
        felt += changed;
        *n.value = value;
    }
    std::printf("%zu of %zu numbers of a car are felt\n", felt, all.size());
}

}  // namespace
}  // namespace tread
