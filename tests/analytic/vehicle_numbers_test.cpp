// Every number of a car's file acts, the optional ones not at their default, and nothing else does.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "base/fields/numbers.h"
#include "shared/equipped_car.h"
#include "shared/vehicles.h"

namespace tread::vehicle_numbers_test {
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
    // Letting the steering wheel go in a turn.
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
    // To where the controllers stay out: slowing down in a hard turn, full brakes at walking speed. Hot discs.
    const auto slowly = [&](double speed, VehicleInput (*driver)(double, VehicleInput)) {
        reference::Car car = reference::settled(params, level, {.speed = speed});
        for (std::size_t i = 0; i < kWheels; ++i) car.state.brakes.heating[i] = 250;
        all.push_back(Drive{car, 600, driver});
    };
    slowly(5.4, [](double t, VehicleInput in) {
        in.brake = 0.3;
        in.steering_wheel_angle = 5 * std::sin(20 * t);
        return in;
    });
    const auto full_brakes = [](double t, VehicleInput in) {
        in.throttle = 0;
        in.brake = t < 0.1 ? 0 : 1;
        in.steering_wheel_angle = std::min(50 * t, 5.0);
        in.parking_brake = t > 0.3 ? 0.4 : 0;
        return in;
    };
    for (const double speed : {4.5, 4.45, 4.4}) slowly(speed, full_brakes);
    // Turning in more than the road allows, by a little less than the stability control counts on.
    static const std::array wet{PlaneRoad(0, 0, 0.6), PlaneRoad(0, 0, 0.65), PlaneRoad(0, 0, 0.7),
                                PlaneRoad(0, 0, 0.75)};
    for (const PlaneRoad& road : wet) {
        all.push_back(Drive{reference::settled(params, road, {.speed = 22}), 1500, [](double t, VehicleInput in) {
                                in.steering_wheel_angle = std::min(3 * t, 1.8);
                                return in;
                            }});
    }
    // A long stop.
    all.push_back(Drive{reference::settled(params, level, {.speed = 18}), 1000, [](double t, VehicleInput in) {
                            in.throttle = 0;
                            in.brake = t < 0.05 ? 0 : 1;
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

// Changes every number whose path begins with one of the beginnings a little, one at a time, and looks for it in a log.
void expectEachIsFelt(VehicleParams params, const std::vector<std::string>& beginnings) {
    const std::vector<Drive> all_drives = drives(params);
    std::vector<std::vector<double>> before;
    for (const Drive& drive : all_drives) before.push_back(log(drive, params));
    for (const auto& values : before)
        EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }));

    std::size_t felt = 0, tried = 0;
    for (const Number& n : numbers(params)) {
        const auto begins = [&](const std::string& beginning) { return n.path.starts_with(beginning); };
        if (std::none_of(beginnings.begin(), beginnings.end(), begins)) continue;
        const double value = *n.value;
        // A threshold of a controller may lie between two of its samples: a larger change then crosses one.
        bool changed = false;
        for (const double share : {0.01, 0.1}) {
            *n.value = value - share * (std::abs(value) + (value == 0 ? 0.1 : 0.0));
            for (std::size_t i = 0; i < all_drives.size() && !changed; ++i)
                changed = !identical(log(all_drives[i], params), before[i]);
        }
        EXPECT_TRUE(changed) << n.path;
        felt += changed;
        ++tried;
        *n.value = value;
    }
    std::printf("%zu of %zu numbers of a car are felt\n", felt, tried);
}

TEST(NumbersOfACar, EachOneIsFelt) {
    // A number that the program reads and forgets would leave the log as it is. The place of a load needs a mass.
    VehicleParams params = shared::withEverything(reference::compact());
    params.load.mass = 60;
    expectEachIsFelt(params, {""});
}

TEST(NumbersOfACar, EachOneOfAHybridWithATorqueConverterIsFelt) {
    VehicleParams params = reference::compact();
    params.driveline.coupling = TorqueConverterParams{.capacity = {{{0, 0.0028}, {0.8, 0.002}, {1, 0}}},
                                                      .torque_ratio = {{{0, 2}, {0.85, 1}}},
                                                      .lock_up_torque = 10,
                                                      .lock_up_speed_ratio = 0.85,
                                                      .lock_up_gear = 1};
    params.driveline.motor = MotorParams{.torque = 100,
                                         .power = 25000,
                                         .speed_limit = 385,
                                         .no_load_speed = 2000,
                                         .inertia = 0.02,
                                         .drag = {{{0, 1}, {700, 3}}},
                                         .lift_off_regeneration = 0.2,
                                         .brake_regeneration = 0.1,
                                         .regeneration_speed = 100,
                                         .response_time = 0.04};
    expectEachIsFelt(params, {"driveline.coupling", "driveline.motor"});
}

}  // namespace
}  // namespace tread::vehicle_numbers_test
