// Drivers that watch the car, against cars whose motion has a closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/yaml/read.h"
#include "scenario/driver.h"

namespace tread::closed_loop_test {
namespace {

constexpr double kStep = 0.001;  // s
const KnownSteering kCar{.wheelbase = 2.5, .ratio = 16};

Scenario scenarioOf(const std::string& text) {
    return readYamlText<Scenario>(text, "scenario.yaml");
}

// A car on rails: it turns as its front wheels point, at the speed of its pedals.
struct Kinematic {
    ChassisOutput chassis;
    double pull = 0;  // m/s2 at full throttle, and at full brake backwards

    explicit Kinematic(double speed) { chassis.vx = speed; }
    void step(const VehicleInput& input) {
        ChassisOutput& c = chassis;
        c.vx += kStep * pull * (input.throttle - input.brake);
        c.yaw_rate = c.vx * std::tan(input.steering_wheel_angle / kCar.ratio) / kCar.wheelbase;
        c.ay = c.vx * c.yaw_rate;
        c.x += kStep * c.vx * std::cos(c.yaw + 0.5 * kStep * c.yaw_rate);
        c.y += kStep * c.vx * std::sin(c.yaw + 0.5 * kStep * c.yaw_rate);
        c.yaw += kStep * c.yaw_rate;
    }
};

// Drives until a time and calls watch(time, car).
template <class Watch>
Kinematic drive(const Scenario& scenario, Kinematic car, double until, const Watch& watch) {
    Driver driver(scenario, {}, kCar);
    for (long k = 0; static_cast<double>(k) * kStep < until; ++k) {
        const double t = static_cast<double>(k) * kStep;
        driver.look(t, car.chassis);
        car.step(driver.inputAt(t + kStep));
        watch(t + kStep, car.chassis);
    }
    return car;
}

// With a car that turns as its wheels point, the curvature closes in as 1 - exp(-bandwidth t).
TEST(ClosedLoop, CurvatureClosesInWithTheBandwidth) {
    constexpr double kSmall = 2e-3;  // of the target: tan(angle), and the hand's step behind the eye
    for (const char* steering : {"hold_radius: {radius: -200, bandwidth: 2}",
                                 "hold_lateral_acceleration: {target: -2, bandwidth: 2}"}) {  // 20 m/s: 200 m
        const Scenario scenario =
            scenarioOf(std::string("phases: [{steering: {") + steering + "}, until: {time: 20}}]");
        drive(scenario, Kinematic(20), 4, [&](double t, const ChassisOutput& car) {
            const double expected = -(1 - std::exp(-2 * t)) / 200;
            ASSERT_NEAR(car.yaw_rate / car.vx, expected, kSmall / 200) << steering << " at " << t;
        });
    }
}

TEST(ClosedLoop, HandStaysWhereTheControllerLeftIt) {
    const Scenario scenario =
        scenarioOf("phases: [{steering: {hold_radius: {radius: 100}}, until: {time: 10}}, {until: {time: 20}}]");
    const Kinematic car = drive(scenario, Kinematic(20), 19, [](double, const ChassisOutput&) {});
    EXPECT_NEAR(car.chassis.yaw_rate / car.chassis.vx, 0.01, 1e-5);
}

TEST(ClosedLoop, DriverReturnsToAStraightPathAndStaysOnACircle) {
    const Scenario straight = scenarioOf(
        "course: {path: [{x: 0, y: 1.5}, {x: 1000, y: 1.5}]}\n"
        "phases: [{steering: {follow_path: {understeer: 0}}, until: {time: 20}}]");
    const Kinematic car = drive(straight, Kinematic(20), 8, [](double, const ChassisOutput&) {});
    EXPECT_NEAR(car.chassis.y, 1.5, 0.005);
    EXPECT_NEAR(car.chassis.yaw, 0, 0.001);

    std::string points;
    for (int degree = 0; degree <= 720; ++degree) {
        const double a = degree * std::acos(-1.0) / 180;
        points += (degree ? ", " : "") + std::string("{x: ") + std::to_string(100 * std::sin(a)) +
                  ", y: " + std::to_string(100 - 100 * std::cos(a)) + "}";
    }
    const Scenario circle = scenarioOf("course: {path: [" + points +
                                       "]}\nphases: [{steering: {follow_path: {understeer: 0}}, until: {time: 60}}]");
    drive(circle, Kinematic(15), 50, [&](double t, const ChassisOutput& c) {
        // Pure pursuit of a circle has no steady error; the beginning, from zero curvature, has.
        if (t > 5) {
            ASSERT_NEAR(std::hypot(c.x, c.y - 100), 100, 0.05) << t;
        }
    });
}

// A driver with a dead time and a lag does what one without does, later: hand angle over a ramp of demand.
TEST(ClosedLoop, HandsFollowTheEyesByDelayLagAndAtMostTheirRate) {
    const auto angleAt = [](const std::string& driver, double t) {
        SteerControl hands(kCar, Path({{0, 0}, {10, 0}, {20, 5}, {500, 245}}));
        const SteeringSignal signal =
            readYamlText<Phase>(
                "steering: {follow_path: {preview_time: 1, understeer: 0, " + driver + "}}\nuntil: {time: 1}", "x")
                .steering;
        hands.begin(0);
        ChassisOutput still;  // the eye sees the same arc all the time
        still.vx = 20;
        for (long k = 0; static_cast<double>(k) * kStep <= t + 1e-9; ++k)
            hands.look(signal, still, static_cast<double>(k) * kStep, kStep);
        return hands.angle();
    };
    const double asked = angleAt("delay: 0, lag: 0, largest_rate: 1e4", 0);
    ASSERT_GT(asked, 0.1);
    EXPECT_EQ(angleAt("delay: 0.2, lag: 0, largest_rate: 1e4", 0.199), 0);
    EXPECT_EQ(angleAt("delay: 0.2, lag: 0, largest_rate: 1e4", 0.2), asked);
    EXPECT_NEAR(angleAt("delay: 0, lag: 0.1, largest_rate: 1e4", 0.1 - kStep), asked * (1 - std::exp(-1.0)), 1e-9);
    EXPECT_NEAR(angleAt("delay: 0, lag: 0, largest_rate: 1", 0.1 - kStep), 0.1, 1e-9);
}

TEST(ClosedLoop, SpeedFollowsAProfileUpAndWithTheBrakeDown) {
    const Scenario scenario = scenarioOf(
        "phases:\n  - throttle: {hold_speed: {proportional: 1, integral: 1, brake: 0.5, profile: [[0, 10], [10, 20], "
        "[14, 20], [19, 10]]}}\n    until: {time: 60}");
    Kinematic car(10);
    car.pull = 5;
    drive(scenario, car, 19, [&](double t, const ChassisOutput& c) {
        const double wanted = t < 10 ? 10 + t : t < 14 ? 20 : 20 - 2 * (t - 14);
        ASSERT_NEAR(c.vx, wanted, 0.6) << t;
        // Behind an integrator, this controller follows a ramp without error.
        if ((t > 8 && t < 10) || (t > 18 && t < 19)) {
            ASSERT_NEAR(c.vx, wanted, 0.02) << t;
        }
    });
}

TEST(ClosedLoop, WithoutAGainTheControllerNeverBrakes) {
    const Scenario scenario = scenarioOf("phases: [{throttle: {hold_speed: {speed: 10}}, until: {time: 60}}]");
    Kinematic car(20);
    car.pull = 5;
    EXPECT_EQ(drive(scenario, car, 10, [](double, const ChassisOutput&) {}).chassis.vx, 20);
}

// ---- Courses ----

constexpr const char* kLaneChange = R"(
course:
  begin: 50
  car: {width: 1.8, ahead: 2, behind: 2}
  sections:
    - {from: 0, to: 12, edge: left, at: 0, width_factor: 1.1, width_extra: 0.25}
    - {from: 25.5, to: 36.5, edge: right, at: 1, width_extra: 1}
    - {from: 49, to: 61, edge: left, at: 0, width_factor: 1.3, width_extra: 0.25, width_least: 3}
phases: [{steering: {follow_path: {}}, until: {x_above: 111}}]
)";

TEST(Course, LanesAreAsWideAsTheCarNeedsAndTheFirstIsInItsWay) {
    const auto found = lanes(scenarioOf(kLaneChange).course);
    ASSERT_EQ(found.size(), 3u);
    const double first = 1.1 * 1.8 + 0.25;
    EXPECT_DOUBLE_EQ(found[0].from, 50);
    EXPECT_DOUBLE_EQ(found[2].to, 111);
    EXPECT_NEAR(found[0].left, first / 2, 1e-12);
    EXPECT_NEAR(found[0].right, -first / 2, 1e-12);
    EXPECT_NEAR(found[1].right - found[0].left, 1, 1e-12);
    EXPECT_NEAR(found[1].left - found[1].right, 2.8, 1e-12);
    EXPECT_NEAR(found[2].left, found[0].left, 1e-12);
    EXPECT_NEAR(found[2].left - found[2].right, 3, 1e-12) << "1.3 b + 0.25 would be 2.59 m";
}

TEST(Course, PathRunsThroughTheMiddleOfTheLanes) {
    const CourseParams course = scenarioOf(kLaneChange).course;
    const Path path(coursePath(course));
    const auto through = lanes(course);
    for (const Lane& lane : through) {
        const Point middle{0.5 * (lane.from + lane.to), 0.5 * (lane.left + lane.right)};
        const Point on_path = path.at(path.nearest(middle));
        EXPECT_NEAR(on_path.x, middle.x, 1e-9);
        EXPECT_NEAR(on_path.y, middle.y, 1e-9);
    }
    // Half-way between two lanes, half-way across.
    const double y = 0.5 * (0.5 * (through[0].left + through[0].right) + 0.5 * (through[1].left + through[1].right));
    const Point half = path.at(path.nearest({50 + 18.75, y}));
    EXPECT_NEAR(half.x, 50 + 18.75, 0.01);
    EXPECT_NEAR(half.y, y, 0.01);
}

TEST(Course, LanesThatTheCarCannotReachAreFaults) {
    const auto faultOf = [](std::string from, const std::string& to) {
        std::string text = kLaneChange;
        text.replace(text.find(from), from.size(), to);
        try {
            scenarioOf(text);
        } catch (const LoadError& error) {
            return error.problems().front().text;
        }
        return std::string("no fault");
    };
    EXPECT_EQ(faultOf("edge: right, at: 1, width_extra: 1", "edge: right, at: 1, width_extra: -0.1"),
              "found lane 2 narrower than the car, which cannot go through");
    EXPECT_EQ(faultOf("from: 25.5", "from: 12"),
              "found lane 2 beside the end of the one before, expected a distance to get there");
    EXPECT_EQ(faultOf("begin: 50", "begin: 1.5"),
              "the first lane begins beside the car or behind it, expected ahead of its front end");
}

TEST(Course, ADriverWithoutPathIsAFault) {
    try {
        scenarioOf("phases: [{steering: follow_path, until: {time: 1}}]");
        FAIL() << "no fault";
    } catch (const LoadError& error) {
        EXPECT_EQ(error.problems().front().path, "course");
    }
}

}  // namespace
}  // namespace tread::closed_loop_test
