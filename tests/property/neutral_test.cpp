// The default of every optional number is neutral: saying it changes no bit of a log, what belongs to an effect that is
// off is not felt, and an effect that is all but off all but leaves the log as it was.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields/numbers.h"
#include "base/text/number_text.h"
#include "base/yaml/setting.h"
#include "shared/vehicles.h"
#include "vehicle/fields.h"

namespace tread::neutral_test {
namespace {

// What the compact car's file must say, and defaults for the rest; its tyres are whole, their absent numbers being
// those of a tyre file.
VehicleParams barest() {
    VehicleParams shipped = reference::compact();
    VehicleParams car;
    car.driveline.engine.emplace();
    car.driveline.engine->full_load = shipped.driveline.engine->full_load;
    car.driveline.engine->drag = shipped.driveline.engine->drag;
    car.driveline.coupling = shipped.driveline.coupling;
    car.driveline.gearbox.ratios = shipped.driveline.gearbox.ratios;
    car.driveline.gearbox.shift_up_speed = shipped.driveline.gearbox.shift_up_speed;
    car.driveline.gearbox.shift_down_speed = shipped.driveline.gearbox.shift_down_speed;
    const std::vector<Number> theirs = numbers(shipped);
    for (const Number& own : numbers(car)) {
        const auto same =
            std::find_if(theirs.begin(), theirs.end(), [&](const Number& n) { return n.path == own.path; });
        if (std::isnan(*own.value)) *own.value = *same->value;
    }
    car.front.tyre = shipped.front.tyre;
    car.rear.tyre = shipped.rear.tyre;
    return car;
}

struct Channels {
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;
};

// Turning under throttle, then under brakes, on a slope, from equilibrium.
Channels drive(const VehicleParams& params) {
    constexpr double kStep = 0.001;  // s
    const PlaneRoad slope(0.03, 0.02, 0.9);
    reference::Car car = reference::settled(params, slope, {.speed = 16});
    VehicleOutput out;
    const std::vector<Number> channels = numbers(out);
    Channels log;
    for (const Number& n : channels) log.names.push_back(n.path);
    for (int k = 1; k <= 400; ++k) {
        const double t = k * kStep;
        VehicleInput in = car.input;
        in.steering_wheel_angle = std::sin(12 * t);
        in.throttle = t < 0.2 ? 0.6 : 0;
        in.brake = t < 0.2 ? 0 : 0.3;
        car.step(in, kStep);
        out = car.output();
        std::vector<double> row;
        for (const Number& n : channels) row.push_back(*n.value);
        log.rows.push_back(std::move(row));
    }
    return log;
}

bool identical(const Channels& a, const Channels& b) {
    for (std::size_t k = 0; k < a.rows.size(); ++k) {
        if (std::memcmp(a.rows[k].data(), b.rows[k].data(), a.rows[k].size() * sizeof(double)) != 0) return false;
    }
    return a.rows.size() == b.rows.size();
}

void set(VehicleParams& car, const std::string& assignment, std::string_view what) {
    applySettings(car, std::span(&assignment, 1), what,
                  [](std::string_view) { return std::string("tread describe vehicle"); });
}

std::string assignment(const std::string& path, double value) {
    return path + "=" + numberText(value);
}

TEST(Neutral, EveryDefaultThatIsSaidLeavesTheLogAsItIs) {
    VehicleParams car = barest();
    const Channels before = drive(car);
    VehicleParams silent;
    silent.driveline.engine.emplace();
    const std::vector<Number> own = numbers(car);
    std::size_t said = 0;
    for (const Number& n : numbers(silent)) {
        const auto same = std::find_if(own.begin(), own.end(), [&](const Number& o) { return o.path == n.path; });
        if (same == own.end() || *same->value != *n.value) continue;  // a number that the file must say
        if (n.path.find(".tyre.") != std::string::npos) continue;     // a tyre is a file of its own
        VehicleParams saying = car;
        set(saying, assignment(n.path, *n.value), "default");  // throws where a default is beyond its limits
        EXPECT_TRUE(identical(drive(saying), before)) << n.path;
        ++said;
    }
    EXPECT_GT(said, 60u);
    std::printf("%zu defaults said one by one\n", said);
}

TEST(Neutral, AWheelThatSaysWhatItsAxleSaysIsAsAnyOther) {
    VehicleParams car = barest();
    const Channels before = drive(car);
    for (AxleParams* axle : {&car.front, &car.rear}) {
        axle->left = {.tyre = axle->tyre, .tyre_surroundings = axle->tyre_surroundings};
        axle->right = axle->left;
    }
    EXPECT_TRUE(identical(drive(car), before));
}

TEST(Neutral, WhatBelongsToAnEffectThatIsOffIsNotFelt) {
    VehicleParams car = barest();
    const Channels before = drive(car);
    for (const std::string name :
         {"steering.inertia=0.2", "front.suspension.longitudinal_damping=50",
          "front.suspension.bump_stop.clearance=0.5", "front.tyre_surroundings.pressure.radial_stiffness=0.7",
          "rear.tyre_surroundings.pressure.slip_stiffness=0.2",
          "front.tyre_surroundings.pressure.cornering_stiffness=0.5",
          "rear.tyre_surroundings.pressure.cornering_peak_load=0.5", "brakes.anti_lock.authority_offset=-1",
          "brakes.stability_control.authority_offset=-1"}) {
        VehicleParams other = car;
        set(other, name, "what is off");
        EXPECT_TRUE(identical(drive(other), before)) << name;
    }
}

TEST(Neutral, AnEffectThatIsAllButOffLeavesTheLogAllButAsItWas) {
    // An effect is skipped where it is neutral: what it does besides must not show, or switching it on would be felt.
    constexpr double kNothing = 1e-6;  // of any unit: less is no movement
    VehicleParams car = barest();
    const Channels before = drive(car);
    for (const std::string name :
         {"steering.delay=1e-8", "steering.lag=1e-8", "steering.play=1e-9", "steering.column_compliance=1e-9",
          "steering.rack_compliance=1e-12", "front.suspension.steer_by_aligning_moment=1e-12",
          "rear.suspension.steer_by_longitudinal_force=1e-13", "front.suspension.camber_by_lateral_force=1e-13",
          "front.suspension.longitudinal_compliance=1e-10", "rear.suspension.longitudinal_compliance=1e-10",
          "front.suspension.damper.friction=1e-6", "front.tyre_surroundings.ply_steer=1e-10",
          "rear.tyre_surroundings.conicity=1e-10", "front.tyre_surroundings.grip_difference=1e-9",
          "front.tyre_surroundings.temperature.friction=1e-9", "rear.tyre_surroundings.temperature.stiffness=1e-9",
          "lateral_offset=1e-9", "brakes.front_disc.fade=1e-10", "driveline.front_differential.open.locking=1e-9"}) {
        VehicleParams other = car;
        set(other, name, "all but off");
        const Channels after = drive(other);
        EXPECT_FALSE(identical(after, before)) << name << " does nothing";
        double worst = 0;
        std::string where;
        for (std::size_t i = 0; i < before.names.size(); ++i) {
            double peak = kNothing, largest = 0, in_a_step = 0;
            for (std::size_t k = 0; k < before.rows.size(); ++k) {
                peak = std::max(peak, std::abs(before.rows[k][i]));
                largest = std::max(largest, std::abs(after.rows[k][i] - before.rows[k][i]));
                if (k > 0) in_a_step = std::max(in_a_step, std::abs(before.rows[k][i] - before.rows[k - 1][i]));
            }
            // A part that moves of itself feels the forces on it a step late.
            EXPECT_LT(largest, std::max(1e-3 * peak, in_a_step)) << name << ", " << before.names[i];
            if (largest / peak > worst) {
                worst = largest / peak;
                where = before.names[i];
            }
        }
        std::printf("%-55s %.1e of the peak in %s\n", name.c_str(), worst, where.c_str());
    }
}

}  // namespace
}  // namespace tread::neutral_test
