#include <gtest/gtest.h>

#include <cmath>

#include "unit/metrics_sample.h"

namespace tread::metrics_lane_change_test {
namespace {

using sample::valueOf;

// One lane of 20 m, 2.4 m wide about y = 0, then a second one to the left; a car of 1.8 m by 4 m.
CourseParams course() {
    CourseParams out;
    out.begin = 10;
    out.car = {1.8, 2, 2};
    out.sections = {{.from = 0, .to = 20, .edge = Edge::right, .at = -1.2, .width_factor = 1, .width_extra = 0.6},
                    {.from = 40, .to = 60, .edge = Edge::right, .at = 1.8, .width_factor = 1, .width_extra = 0.6}};
    return out;
}

// Along x at 20 m/s; y over x, and the yaw angle, as given.
Log logOf(const std::function<double(double)>& y, double yaw = 0, double length = 90, double rate = 100) {
    const auto x = [](double t) { return 20 * t; };
    return sample::log(rate, length / 20,
                       {{"driver.steering_wheel_angle", "rad", [](double t) { return 0.5 * std::sin(2 * t); }},
                        {"chassis.x", "m", x},
                        {"chassis.y", "m", [=](double t) { return y(x(t)); }},
                        {"chassis.yaw", "rad", sample::constant(yaw)},
                        {"chassis.vx", "m/s", sample::constant(20)},
                        {"chassis.yaw_rate", "rad/s", sample::constant(0.2)},
                        {"chassis.ay", "m/s2", sample::constant(3)}});
}

// Changes lanes between x = 34 and x = 46, when the rear end has left the first lane and before the second begins.
double change(double x) {
    return 3 * std::clamp((x - 32.5) / 15, 0.0, 1.0);
}

std::vector<Metric> found(const Log& log) {
    return metrics(log, "lane_change", {.course = course()});
}

TEST(LaneChange, ACarBetweenTheConesIsClean) {
    for (const double rate : sample::kRates) {
        const auto clean = found(logOf(change, 0, 90, rate));
        EXPECT_EQ(valueOf(clean, "clean"), 1);
        EXPECT_EQ(valueOf(clean, "cones_hit"), 0);
        // 2.4 m less 1.8 m, halved; none of the corners is aside while in a lane.
        EXPECT_NEAR(valueOf(clean, "least_clearance"), 0.3, 1e-9) << rate;
        EXPECT_NEAR(valueOf(clean, "entry_speed"), 20, 1e-9);
        EXPECT_NEAR(valueOf(clean, "duration"), 60.0 / 20, 1e-9);
    }
}

TEST(LaneChange, EveryConeInTheWayIsHitOnce) {
    // Straight on: the first lane is clean, the right edge of the second, y = 1.8 m, is 0.9 m away.
    const auto straight = found(logOf([](double) { return 0; }));
    EXPECT_EQ(valueOf(straight, "cones_hit"), 0);
    EXPECT_NEAR(valueOf(straight, "least_clearance"), -0.9 - 1.8, 1e-9) << "right side to right edge, outside";
    EXPECT_EQ(valueOf(straight, "clean"), 0) << "no cone was touched, but the lane was left";
}

TEST(LaneChange, ConesUnderTheBodyAreHit) {
    // 0.4 m aside to the left: the left side stands 0.1 m beyond the left edges of the first lane: its 5 cones.
    const auto aside = found(logOf([](double x) { return x < 32 ? 0.4 : change(x); }));
    EXPECT_EQ(valueOf(aside, "cones_hit"), 5);
    EXPECT_NEAR(valueOf(aside, "least_clearance"), -0.1, 1e-9);
    EXPECT_EQ(valueOf(aside, "clean"), 0);
}

TEST(LaneChange, ASkewedCarTouchesWithItsCorners) {
    // Half the diagonal's reach to the side: 2 sin(yaw) + 0.9 cos(yaw).
    const double yaw = 0.1;
    const auto skewed = found(logOf(change, yaw));
    EXPECT_NEAR(valueOf(skewed, "least_clearance"), 1.2 - 2 * std::sin(yaw) - 0.9 * std::cos(yaw), 1e-6);
}

TEST(LaneChange, ACarThatDoesNotArriveIsNotClean) {
    const auto stopped = found(logOf(change, 0, 60));
    EXPECT_EQ(valueOf(stopped, "clean"), 0);
    EXPECT_TRUE(std::isnan(valueOf(stopped, "exit_speed")));
}

TEST(LaneChange, WithoutACourseItDoesNotShow) {
    EXPECT_NE(sample::errorOf(logOf(change), "lane_change").find("found only with its course"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_lane_change_test
