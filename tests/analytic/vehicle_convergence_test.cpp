// Halving the step: the whole car converges, and with which order.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "shared/vehicles.h"

namespace tread::vehicle_convergence_test {
namespace {

// What is compared at the end of the manoeuvre: motion of the body, wheels and driveline.
constexpr std::array kNames{"x",        "y",      "z",    "yaw rate", "roll rate",   "pitch rate",
                            "travel 0", "load 1", "fy 2", "spin 3",   "engine speed"};
using Result = std::array<double, kNames.size()>;

struct Case {
    const char* name;
    double speed;
    VehicleInput (*input)(double t, const VehicleInput& start);
};

double smooth(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * x * (10 + x * (6 * x - 15));
}

Result driven(const reference::Car& start, const Case& c, double dt) {
    reference::Car car = start;
    const double duration = 0.8;
    const long steps = std::lround(duration / dt);
    for (long k = 1; k <= steps; ++k) car.step(c.input(static_cast<double>(k) * dt, start.input), dt);
    const VehicleOutput out = car.output();
    return {out.chassis.x,
            out.chassis.y,
            out.chassis.z,
            out.chassis.yaw_rate,
            out.chassis.roll_rate,
            out.chassis.pitch_rate,
            out.wheel[0].travel,
            out.wheel[1].load,
            out.wheel[2].fy,
            out.wheel[3].spin,
            out.driveline.engine_speed};
}

const Case kCases[] = {{"steering", 25,
                        [](double t, const VehicleInput& start) {
                            VehicleInput in = start;
                            in.steering_wheel_angle = 0.6 * smooth(t / 0.4);
                            return in;
                        }},
                       {"braking, declutched", 25,
                        [](double t, const VehicleInput& start) {
                            VehicleInput in = start;
                            in.throttle *= 1 - smooth(t / 0.2);
                            in.clutch = smooth(t / 0.2);
                            in.brake = 0.25 * smooth((t - 0.2) / 0.4);
                            return in;
                        }},
                       {"throttle", 25, [](double t, const VehicleInput& start) {
                            VehicleInput in = start;
                            in.throttle += 0.4 * smooth(t / 0.4);
                            return in;
                        }}};

// Errors as a share of how much the manoeuvre changed the quantity; 0 for what takes no part in it.
struct Errors {
    Result coarse{}, normal{}, fine{};  // at 2, 1 and 0.5 ms
};

Errors study(const VehicleParams& params, const Case& c) {
    const PlaneRoad road;
    const reference::Car start = reference::settled(params, road, {.speed = c.speed});
    const Result rest = driven(start, {"", 0, [](double, const VehicleInput& in) { return in; }}, 1e-3);
    const Result h2 = driven(start, c, 2e-3), h1 = driven(start, c, 1e-3), h0 = driven(start, c, 5e-4),
                 truth = driven(start, c, 2.5e-5);
    Errors errors;
    std::printf("%s, %s: errors at 2, 1, 0.5 ms as share of the change\n", params.name.c_str(), c.name);
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const double size = std::abs(truth[i] - rest[i]);
        if (size < 1e-6 * std::max(std::abs(truth[i]), 1e-2)) continue;
        const auto error = [&](const Result& r) { return std::abs(r[i] - truth[i]) / size; };
        errors.coarse[i] = error(h2);
        errors.normal[i] = error(h1);
        errors.fine[i] = error(h0);
        std::printf("  %-12s %.1e %.1e %.1e  order %.2f %.2f\n", kNames[i], error(h2), error(h1), error(h0),
                    std::log2(error(h2) / error(h1)), std::log2(error(h1) / error(h0)));
    }
    return errors;
}

TEST(Convergence, OneMillisecondIsCloseToTheTruth) {
    // The body and the wheels are second order but for small terms: the wheels' spin acts on the body half a step late.
    // The engine follows the wheels half a step late: 0.5 ms of a change that takes 0.4 s.
    constexpr double kCar = 3e-4, kEngine = 2e-3;
    for (const VehicleParams& params : {reference::compact(), reference::rearDriveSedan()}) {
        for (const Case& c : kCases) {
            const Errors errors = study(params, c);
            for (std::size_t i = 0; i < kNames.size(); ++i) {
                const double tolerance = i + 1 == kNames.size() ? kEngine : kCar;
                EXPECT_LT(errors.normal[i], tolerance) << params.name << ", " << c.name << ", " << kNames[i];
                EXPECT_LT(errors.fine[i], 0.7 * tolerance) << params.name << ", " << c.name << ", " << kNames[i];
            }
        }
    }
}

TEST(Convergence, LateralMotionIsOfSecondOrder) {
    const Errors errors = study(reference::compact(), kCases[0]);
    constexpr std::size_t kLateral = 1;  // y
    EXPECT_GT(std::log2(errors.coarse[kLateral] / errors.normal[kLateral]), 1.6);
    EXPECT_GT(std::log2(errors.normal[kLateral] / errors.fine[kLateral]), 1.5);
}

}  // namespace
}  // namespace tread::vehicle_convergence_test
