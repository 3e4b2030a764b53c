// Courses: smooth lines through points, speed from limits, ways over laps, the file of a centreline.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

#include "metrics/metrics.h"
#include "places/places.h"
#include "scenario/course_file.h"
#include "scenario/course_plan.h"
#include "scenario/smooth_line.h"
#include "shared/scratch.h"

namespace tread::course_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 50;  // m

// A circle to the left that begins at the origin along x, `count` points a lap.
std::vector<Point> circle(int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const double a = 2 * kPi * i / count;
        points.push_back({kRadius * std::sin(a), kRadius * (1 - std::cos(a))});
    }
    return points;
}

CourseParams circleCourse(int count) {
    CourseParams course;
    for (const Point& p : circle(count)) course.line.points.push_back({.x = p.x, .y = p.y});
    course.line.closed = true;
    return course;
}

TEST(SmoothLine, ThroughACircleHasItsCurvatureAndLength) {
    const std::vector<SmoothPoint> line = smoothLine(circle(60), true, 0.5);
    for (const SmoothPoint& p : line) {
        EXPECT_NEAR(p.curvature, 1 / kRadius, 1e-3 / kRadius);
        EXPECT_NEAR(std::hypot(p.place.x, p.place.y - kRadius), kRadius, 1e-4);
    }
    EXPECT_NEAR(line.front().place.x, line.back().place.x, 1e-9);
    EXPECT_NEAR(line.front().place.y, line.back().place.y, 1e-9);
}

TEST(SmoothLine, OpenHasStraightEndsAndPassesOverRepeatedPoints) {
    const std::vector<SmoothPoint> line = smoothLine({{0, 0}, {10, 0}, {10, 0}, {20, 5}}, false, 1);
    EXPECT_EQ(line.front().curvature, 0);
    EXPECT_NEAR(line.back().curvature, 0, 1e-12);
    EXPECT_NEAR(line.back().place.y, 5, 1e-12);
    EXPECT_TRUE(smoothLine({{0, 0}, {1, 0}}, true, 1).empty()) << "two points enclose nothing";
}

TEST(CoursePlan, WaysGoOnOverLapsAndErrorsAreThoseOfAKnownOffset) {
    const CoursePlan plan(circleCourse(90));
    const double lap = plan.path().length();
    EXPECT_NEAR(lap, 2 * kPi * kRadius, 0.01);
    EXPECT_NEAR(plan.path().at(2.25 * lap).x, kRadius, 0.01);
    EXPECT_NEAR(plan.laps(2.25 * lap), 2.25, 1e-12);
    // 0.3 m inside of the circle, through the line and on.
    double way = plan.path().nearest({0, 0.3});
    for (int degree = 0; degree < 800; degree += 2) {
        const double a = degree * kPi / 180, r = kRadius - 0.3;
        const Point here{r * std::sin(a), kRadius - r * std::cos(a)};
        way = plan.path().nearest(here, way, 20);
        ASSERT_NEAR(way, a * kRadius, 0.02) << degree;
        ASSERT_NEAR(plan.path().aside(here, way), 0.3, 0.001) << degree;
    }
}

TEST(CoursePlan, BeginsWhereTheCarStartsUnlessItKeepsItsPlace) {
    CourseParams course = circleCourse(90);
    for (LinePoint& p : course.line.points) {
        const double x = p.x, y = p.y;
        p.x = 7 - y;  // turned by a right angle and moved
        p.y = x - 3;
    }
    const CoursePlan moved(course);
    EXPECT_NEAR(moved.path().at(0).x, 0, 1e-9);
    EXPECT_NEAR(moved.path().at(0.25 * moved.path().length()).x, kRadius, 0.01);
    EXPECT_NEAR(moved.path().at(0.25 * moved.path().length()).y, kRadius, 0.01);
    course.line.in_place = true;
    EXPECT_NEAR(CoursePlan(course).path().at(0).x, 7, 1e-9);
}

TEST(SpeedFromLimits, IsThatOfTheLateralLimitOnACircle) {
    const SpeedLimits limits{.lateral = 5, .highest = 60};
    std::vector<double> way, curvature;
    for (int i = 0; i <= 100; ++i) {
        way.push_back(i);
        curvature.push_back(-0.02);
    }
    for (const double v : speedFromLimits(way, curvature, true, limits)) EXPECT_DOUBLE_EQ(v, std::sqrt(5 / 0.02));
    CourseParams course = circleCourse(90);
    course.line.limits = limits;
    EXPECT_NEAR(CoursePlan(course).speed(100), std::sqrt(5 * kRadius), 0.02);
    course.line.limits = {.of_car = 0.5};
    EXPECT_NEAR(CoursePlan(course, {.lateral = 10}).speed(100), std::sqrt(5 * kRadius), 0.02);
}

// 300 m of straight between bends of 20 m radius: v^2 = v0^2 + 2 a s from either end.
TEST(SpeedFromLimits, RisesAndFallsByTheLongitudinalLimits) {
    std::vector<double> way, curvature;
    for (int i = 0; i <= 400; ++i) {
        way.push_back(i);
        curvature.push_back(i < 50 || i > 350 ? 0.05 : 0);
    }
    const std::vector<double> v =
        speedFromLimits(way, curvature, false, {.lateral = 5, .acceleration = 2, .braking = 4, .highest = 100});
    const double slow = std::sqrt(5 / 0.05);
    EXPECT_DOUBLE_EQ(v[20], slow);
    // In the last metre of the bend nothing is left for acceleration.
    EXPECT_NEAR(v[150], std::sqrt(slow * slow + 2 * 2 * 100), 1e-9);
    EXPECT_NEAR(v[300], std::sqrt(slow * slow + 2 * 4 * 50), 1e-9);
}

TEST(CourseFile, ReadsColumnsWithTheirUnitsInAnyOrder) {
    std::vector<Problem> problems;
    const auto points =
        parseCourse("# a comment\nspeed [km/h],y [m],x [km]\n36,1,0\n72,2,0.01\n", "c.csv", false, problems);
    ASSERT_TRUE(problems.empty()) << problems.front().text;
    ASSERT_EQ(points.size(), 2u);
    EXPECT_DOUBLE_EQ(points[1].x, 10);
    EXPECT_DOUBLE_EQ(points[1].speed, 20);
    // The first point once more closes a course.
    EXPECT_EQ(parseCourse("x,y\n0,0\n10,0\n10,10\n0,0\n", "c.csv", true, problems).size(), 3u);
    EXPECT_TRUE(problems.empty());
}

TEST(CourseFile, EachFaultIsOneSentenceWithItsPlace) {
    const auto expect = [](const std::string& text, bool closed, int line, int column, const std::string& words) {
        std::vector<Problem> problems;
        parseCourse(text, "c.csv", closed, problems);
        ASSERT_EQ(problems.size(), 1u) << text;
        EXPECT_EQ(problems[0].line, line) << problems[0].text;
        EXPECT_EQ(problems[0].column, column) << problems[0].text;
        EXPECT_NE(problems[0].text.find(words), std::string::npos) << problems[0].text;
    };
    expect("", false, 1, 1, "found no line");
    expect("x,y,z\n0,0,0\n1,1,1\n", false, 1, 5, "found the column \"z\"");
    expect("x\n0\n1\n", false, 1, 1, "found no column y");
    expect("x [kg],y\n0,0\n1,1\n", false, 1, 1, "found a mass");
    expect("x,y\n0,0\n", false, 2, 1, "found 1 points, expected at least 2");
    expect("x,y\n0,0\n1,0\n", true, 3, 1, "at least 3 for a closed course");
    expect("x,y\n0,0\n1,0\n1,0\n2,0\n", false, 4, 1, "same point as in the line before");
    expect("x,y\n0,0\n1,nan\n", false, 3, 3, "found \"nan\" in column y, expected a number");
    expect("x,y,width\n0,0,5\n1,0,-5\n", false, 3, 5, "expected at least 0");
    expect("x,y,speed\n0,0,5\n1,0,-5\n", false, 3, 5, "expected at least 0");
    expect("x,y\n0,0\n1\n", false, 3, 1, "found 1 cells, expected 2");
    expect("x,y\n0,0\n10,0\n20,0\n30,0\n40,0\n", true, 6, 1, "found the last point 40 m from the first");
}

// Crossing itself is no fault: a figure of eight is followed through its middle.
TEST(CourseFile, ALineMayCrossItself) {
    CourseParams course;
    for (int i = 0; i < 100; ++i) {
        const double a = 2 * kPi * i / 100;
        course.line.points.push_back({.x = 60 * std::sin(a), .y = 30 * std::sin(2 * a)});
    }
    course.line.closed = course.line.in_place = true;
    const CoursePlan plan(course);
    double way = 0;
    for (double s = 0; s < plan.path().length(); s += 1) {
        way = plan.path().nearest(plan.path().at(s), way, 20);
        ASSERT_NEAR(way, s, 0.01);
    }
}

// The shipped track is the integral of the clothoids that its file names.
TEST(CourseFile, TheShippedTrackIsMadeOfTheClothoidsThatItNames) {
    const std::string file = sourceFile("scenarios/courses/own_track.csv"), text = contentOf(file);
    std::vector<std::array<double, 3>> clothoids;
    std::istringstream lines(text);
    double length = 0;
    for (std::string line; std::getline(lines, line);) {
        std::array<double, 3> c{};
        if (std::sscanf(line.c_str(), "# clothoid: %lf, %lf, %lf", &c[0], &c[1], &c[2]) != 3) continue;
        clothoids.push_back(c);
        length += c[0];
    }
    ASSERT_GT(clothoids.size(), 10u);
    std::vector<Problem> problems;
    const auto points = parseCourse(text, file, true, problems);
    ASSERT_TRUE(problems.empty());
    const double apart = length / static_cast<double>(points.size());
    double x = 0, y = 0, heading = 0, way = 0, next = 0;
    std::size_t at = 0;
    for (const auto& [l, from, to] : clothoids) {
        const int steps = static_cast<int>(std::ceil(l / 0.002));
        const double ds = l / steps;
        for (int i = 0; i < steps; ++i) {
            if (way >= next - 1e-3 && at < points.size()) {
                ASSERT_NEAR(points[at].x, x, 0.01) << way;
                ASSERT_NEAR(points[at].y, y, 0.01) << way;
                next = static_cast<double>(++at) * apart;
            }
            const double middle = heading + 0.5 * ds * (from + (to - from) * (i + 0.25) / steps);
            x += ds * std::cos(middle);
            y += ds * std::sin(middle);
            heading += ds * (from + (to - from) * (i + 0.5) / steps);
            way += ds;
        }
    }
    EXPECT_EQ(at, points.size());
    EXPECT_NEAR(heading, 2 * kPi, 1e-5);
    EXPECT_NEAR(std::hypot(x, y), 0, 0.01);
}

// A log of a drive round the circle, 0.3 m inside at a constant speed.
TEST(CourseMetrics, LapTimeAndErrorAreThoseOfACircle) {
    const double v = 10, r = kRadius - 0.3;
    Log log;
    log.channels = {{"time", "s", {}},
                    {"course.distance", "m", {}},
                    {"course.cross_track_error", "m", {}},
                    {"chassis.vx", "m/s", {}},
                    {"course.speed", "m/s", {}}};
    const double lap = CoursePlan(circleCourse(90)).path().length();
    for (double t = 0; t < 70; t += 0.07) {
        const double row[] = {t, t * v / (2 * kPi * r) * lap, t < 35 ? 0.3 : -0.3, v, v + 0.5};
        for (std::size_t i = 0; i < 5; ++i) log.channels[i].values.push_back(row[i]);
    }
    const std::vector<Metric> found = metrics(log, "course", {.course = circleCourse(90)});
    const auto value = [&](std::string_view name) {
        for (const Metric& metric : found) {
            if (metric.name == name) return metric.value;
        }
        return std::nan("");
    };
    EXPECT_NEAR(value("lap_time"), 2 * kPi * r / v, 1e-6);
    EXPECT_EQ(value("laps"), 2);
    EXPECT_NEAR(value("largest_cross_track_error"), 0.3, 1e-12);
    EXPECT_NEAR(value("rms_cross_track_error"), 0.3, 1e-3);
    EXPECT_NEAR(value("rms_speed_error"), 0.5, 1e-9);
    EXPECT_EQ(value("clean"), 1);
}

}  // namespace
}  // namespace tread::course_test
