// The course of a manoeuvre: the path that a driver follows, and lanes between cones. Seen from above, in the
// horizontal axes of the world; the car starts at the origin and looks along x.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tread/describe.h"

namespace tread {

enum class Edge { right, left };
constexpr auto enumNames(Edge) {
    return std::array<std::string_view, 2>{"right", "left"};
}

struct PathPoint {
    double x = kRequired;
    double y = kRequired;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "forward of where the car starts"}.unjudged());
        field(TREAD_FIELD(y), About{"m", "to the left of it"}.unjudged());
    }
};
static_assert(describesEveryMember<PathPoint>());

// Outline of the car's body from above: what must not touch a cone.
struct CarOutline {
    double width = 0;
    double ahead = 0;
    double behind = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(width), About{"m", "width of the car without mirrors", kNonNegative}.usually(0.1, 3));
        field(TREAD_FIELD(ahead),
              About{"m", "from the centre of gravity to the front end", kNonNegative}.usually(0.05, 12));
        field(TREAD_FIELD(behind),
              About{"m", "from the centre of gravity to the rear end", kNonNegative}.usually(0.05, 12));
    }
};
static_assert(describesEveryMember<CarOutline>());

// A straight lane along x. Its width is width_factor * width of the car + width_extra, at least width_least.
struct LaneSection {
    double from = kRequired;
    double to = kRequired;
    Edge edge = Edge::right;
    double at = 0;
    double width_factor = 1;
    double width_extra = 0;
    double width_least = 0;
    int cones = 5;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(from), About{"m", "beginning, from the beginning of the course"}.unjudged());
        field(TREAD_FIELD(to), About{"m", "end, from the beginning of the course"}.unjudged());
        field(TREAD_FIELD(edge), About{"", "the edge of which `at` says where it lies"});
        field(TREAD_FIELD(at), About{"m", "lateral place of that edge, positive to the left"}.unjudged());
        field(TREAD_FIELD(width_factor),
              About{"-", "share of the lane's width over that of the car", kNonNegative}.usually(0, 5));
        field(TREAD_FIELD(width_extra), About{"m", "what the lane is wider than that"}.usually(-10, 10));
        field(TREAD_FIELD(width_least), About{"m", "least width of the lane", kNonNegative}.usually(0, 30));
        field(TREAD_FIELD(cones), About{"-", "cones along each edge, the first and the last at its ends", {2, 1000}});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.from >= self.to) complain("to", "a lane must end after its beginning (from < to)");
    }
};
static_assert(describesEveryMember<LaneSection>());

// A point of a centreline, as its file has it.
struct LinePoint {
    double x = kRequired;
    double y = kRequired;
    double width = 0;
    double bank = 0;
    double speed = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "place, first axis"}.unjudged());
        field(TREAD_FIELD(y), About{"m", "place, second axis, to the left of the first"}.unjudged());
        field(TREAD_FIELD(width), About{"m", "width of the road; 0: not given", kNonNegative}.usually(0.3, 100));
        field(TREAD_FIELD(bank), About{"rad",
                                       "cross slope of the road, positive with the right side down; read only: the "
                                       "road stays that of the scenario"}
                                     .usually(-1, 1));
        field(TREAD_FIELD(speed), About{"m/s", "target speed; 0: none", kNonNegative}.usually(0.1, 120));
    }
};
static_assert(describesEveryMember<LinePoint>());

// What a driver dares: the speed follows from the curvature of the path.
struct SpeedLimits {
    double lateral = 0;
    double acceleration = 2;
    double braking = 4;
    double highest = 60;
    double of_car = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(lateral),
              About{"m/s2", "largest lateral acceleration; 0: no speed from limits", kNonNegative}.usually(0.1, 30));
        field(TREAD_FIELD(acceleration),
              About{"m/s2", "largest acceleration, on the straight", kPositive}.usually(0.05, 20));
        field(TREAD_FIELD(braking), About{"m/s2", "largest deceleration, on the straight", kPositive}.usually(0.1, 30));
        field(TREAD_FIELD(highest), About{"m/s", "never faster than this", kPositive}.usually(0.1, 120));
        field(TREAD_FIELD(of_car),
              About{"-",
                    "in place of lateral and braking: share of the car's own limit, which is the grip of the axle that "
                    "reaches its end first, on its tyres at the static loads",
                    kFraction});
    }

    bool given() const { return lateral > 0 || of_car > 0; }
};
static_assert(describesEveryMember<SpeedLimits>());

// A centreline from a file: smooth between its points, open or a circuit.
struct CourseLine {
    std::string file;
    bool closed = false;
    bool in_place = false;
    SpeedLimits limits = {};
    std::vector<LinePoint> points = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(
            TREAD_FIELD(file),
            About{"",
                  "CSV with the columns x, y and, if wanted, width, bank and speed, relative to the scenario's file"});
        field(TREAD_FIELD(closed), About{"", "the last point leads back to the first: the course goes on in laps"});
        field(TREAD_FIELD(in_place),
              About{"",
                    "the points keep their coordinates; otherwise the line is moved and turned so that it begins where "
                    "the car starts, in its direction"});
        field(TREAD_FIELD(limits), About{"", "speed from limits, in place of the column speed"});
        field(TREAD_FIELD(points), About{"", "the points themselves, as a run writes them; in place of a file"});
    }
    bool given() const { return !file.empty() || !points.empty(); }
};
static_assert(describesEveryMember<CourseLine>());

struct CourseParams {
    double begin = 0;
    CarOutline car;
    std::vector<LaneSection> sections;
    std::vector<PathPoint> path;
    CourseLine line = {};
    std::vector<PathPoint> cones = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(begin),
              About{"m", "where the course begins: from there the sections are measured"}.unjudged());
        field(TREAD_FIELD(car), About{"", "outline of the car"});
        field(TREAD_FIELD(sections),
              About{"", "lanes between cones; the car starts in line with the middle of the first"});
        field(TREAD_FIELD(path), About{"", "path to follow, straight between its points; none: through the sections"});
        field(TREAD_FIELD(line), About{"", "path from a file, with its speed"});
        field(TREAD_FIELD(cones), About{"", "single cones, each to be passed on the side on which the path passes it"});
    }
    static void check(const auto& self, auto&& complain) {
        if (!self.sections.empty() && self.car.width <= 0)
            complain("car", "found no width of the car, expected one: the lanes are as wide as the car needs");
        if (self.line.given() && (!self.path.empty() || !self.sections.empty()))
            complain("line", "found a line beside a path or sections, expected one of them");
        if (!self.cones.empty() && self.car.width <= 0)
            complain("car", "found no width of the car, expected one: a cone is hit where the car is");
        if (self.path.size() == 1) complain("path", "found one point, expected at least two");
        for (std::size_t i = 1; i < self.sections.size(); ++i) {
            if (self.sections[i].from < self.sections[i - 1].to)
                complain("sections", "the sections must follow each other along x");
        }
        if (self.sections.empty()) return;
        if (self.begin + self.sections.front().from < self.car.ahead)
            complain("begin", "the first lane begins beside the car or behind it, expected ahead of its front end");
        const auto all = lanes(self);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string which = "found lane " + std::to_string(i + 1);
            if (all[i].left - all[i].right < self.car.width)
                complain("sections", which + " narrower than the car, which cannot go through");
            if (i > 0 && all[i].from == all[i - 1].to &&
                (all[i].right > all[i - 1].left - self.car.width || all[i].left < all[i - 1].right + self.car.width))
                complain("sections", which + " beside the end of the one before, expected a distance to get there");
        }
    }
};
static_assert(describesEveryMember<CourseParams>());

struct Point {
    double x;  // m
    double y;  // m
};

bool hasCourse(const CourseParams& course);

// A section in the axes of the world.
struct Lane {
    double from, to;     // m, along x
    double right, left;  // m, along y
    int cones;
};
std::vector<Lane> lanes(const CourseParams& course);

// The path to follow: through the given points, or along the middle of the lanes with half a cosine from one to the
// next.
std::vector<Point> coursePath(const CourseParams& course);

}  // namespace tread
