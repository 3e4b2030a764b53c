// What a driver sees must not depend on the time step of the world.

#include <gtest/gtest.h>

#include <cstdio>

#include "shared/vehicle_run.h"

namespace tread::step_size_test {
namespace {

using shared::channel;

Log drive(const std::string& name, double rate) {
    Scenario scenario = shared::scenario(name);
    scenario.step = 1 / rate;
    scenario.log.rate = rate;
    return simulate(shared::compact(), scenario);
}

TEST(StepSize, StepSteerYawRateIsTheSameAt30To1000Hz) {
    const Log fine = drive("step_steer_80", 1000);
    const double peak = shared::peak(fine, "chassis.yaw_rate");
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        const Log coarse = drive("step_steer_80", rate);
        double largest = 0;
        const auto& time = channel(coarse, "time");
        const auto& yaw_rate = channel(coarse, "chassis.yaw_rate");
        for (std::size_t i = 0; i < time.size(); ++i) {
            largest = std::max(largest, std::abs(yaw_rate[i] - shared::valueAt(fine, "chassis.yaw_rate", time[i])));
        }
        std::printf("step steer, yaw rate at %.0f Hz against 1000 Hz: largest difference %.3f %% of the peak\n", rate,
                    100 * largest / peak);
        // The stock vehicle: 10 to 71 % at 60 Hz. At 30 Hz the steering ramp itself, read every 33 ms, is 1 % off.
        if (rate >= 60) {
            EXPECT_LE(largest, 0.01 * peak);
        }
    }
}

double stoppingDistance(double rate, const std::string& name) {
    const Log log = drive(name, rate);
    const auto& time = channel(log, "time");
    const auto& x = channel(log, "chassis.x");
    std::size_t begin = 0;
    while (time[begin] < 1.0 - 1e-9) ++begin;
    return x.back() - x[begin] + (time[begin] - 1.0) * channel(log, "chassis.vx")[begin];
}

TEST(StepSize, StoppingDistanceIsTheSameAt30To1000Hz) {
    for (const char* name : {"straight_braking_100", "straight_braking_100_part"}) {
        double shortest = kInfinity, longest = 0;
        std::printf("%s: ", name);
        for (const double rate : {30.0, 60.0, 120.0, 240.0, 1000.0}) {
            const double distance = stoppingDistance(rate, name);
            std::printf("%.0f Hz %.3f m, ", rate, distance);
            shortest = std::min(shortest, distance);
            longest = std::max(longest, distance);
        }
        std::printf("spread %.3f %%\n", 100 * (longest / shortest - 1));
        EXPECT_LE(longest, 1.01 * shortest);  // the stock vehicle: up to 449 %
    }
}

TEST(StepSize, ParkedCarStaysOnASlopeAtAnyHeadingAndRate) {
    for (const double rate : {30.0, 60.0, 240.0, 1000.0}) {
        for (const double heading : {0.0, 45.0, 90.0, 180.0, 250.0}) {
            Scenario scenario = shared::scenario("parked_on_slope");
            scenario.step = 1 / rate;
            scenario.log.rate = 10;
            scenario.start.heading = heading * 3.14159265358979 / 180;
            const Log log = simulate(shared::compact(), scenario);
            const auto& x = channel(log, "chassis.x");
            const auto& y = channel(log, "chassis.y");
            double largest = 0;
            for (std::size_t i = 10; i < x.size(); ++i)
                largest = std::max(largest, std::hypot(x[i] - x[10], y[i] - y[10]));
            std::printf("20 %% slope, %.0f Hz, heading %.0f deg: moved %.4f mm in a minute\n", rate, heading,
                        1000 * largest);
            EXPECT_LE(largest, 0.5e-3);  // the stock vehicle: 153 to 7073 mm
        }
    }
}

}  // namespace
}  // namespace tread::step_size_test
