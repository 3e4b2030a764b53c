// Left is right in a mirror, and the world has no preferred direction.

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "shared/vehicle_run.h"

namespace tread::symmetry_test {
namespace {

using shared::channel;

Scenario stepSteer(double sign, double heading) {
    Scenario scenario = shared::scenario("step_steer_80");
    std::get<Ramp<Angle>>(scenario.phases[1].steering).to *= sign;
    scenario.start.heading = heading;
    scenario.phases[1].until.duration = 3;
    return scenario;
}

TEST(Symmetry, SteeringToTheOtherSideMirrorsTheCar) {
    const Log left = simulate(shared::compact(), stepSteer(1, 0));
    const Log right = simulate(shared::compact(), stepSteer(-1, 0));
    const auto compare = [&](const char* a, const char* b, double sign) {
        const auto& x = channel(left, a);
        const auto& y = channel(right, b);
        double largest = 0;
        for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - sign * y[i]));
        const double relative = largest / shared::peak(left, a);
        std::printf("mirror %s: %.1e of the peak\n", a, relative);
        EXPECT_LE(relative, 1e-12) << a;
    };
    compare("chassis.yaw_rate", "chassis.yaw_rate", -1);
    compare("chassis.ay", "chassis.ay", -1);
    compare("chassis.roll", "chassis.roll", -1);
    compare("chassis.vx", "chassis.vx", 1);
    compare("wheel.front_left.load", "wheel.front_right.load", 1);
    compare("wheel.rear_left.fy", "wheel.rear_right.fy", -1);
    compare("wheel.front_left.mz", "wheel.front_right.mz", -1);
}

TEST(Symmetry, TheWorldHasNoPreferredDirection) {
    const Log along = simulate(shared::compact(), stepSteer(1, 0));
    for (const double heading : {37.0, 90.0, 123.0, 270.0}) {
        const Log turned = simulate(shared::compact(), stepSteer(1, heading * std::numbers::pi / 180));
        double worst = 0;
        for (const char* name : {"chassis.yaw_rate", "chassis.ay", "chassis.roll", "chassis.vx",
                                 "wheel.front_left.load", "wheel.rear_right.fy"}) {
            double largest = 0;
            for (std::size_t i = 0; i < along.samples(); ++i) {
                largest = std::max(largest, std::abs(channel(along, name)[i] - channel(turned, name)[i]));
            }
            worst = std::max(worst, largest / shared::peak(along, name));
        }
        std::printf("world turned by %.0f deg: %.1e of the peak\n", heading, worst);
        EXPECT_LE(worst, 1e-9);
    }
}

}  // namespace
}  // namespace tread::symmetry_test
