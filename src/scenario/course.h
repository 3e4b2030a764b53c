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
        if (self.from >= self.to) complain("to", "a lane must end behind its beginning (from < to)");
    }
};
static_assert(describesEveryMember<LaneSection>());

struct CourseParams {
    double begin = 0;
    CarOutline car;
    std::vector<LaneSection> sections;
    std::vector<PathPoint> path;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(begin),
              About{"m", "where the course begins: from there the sections are measured"}.unjudged());
        field(TREAD_FIELD(car), About{"", "outline of the car"});
        field(TREAD_FIELD(sections),
              About{"", "lanes between cones; the car starts in line with the middle of the first"});
        field(TREAD_FIELD(path), About{"", "path to follow, straight between its points; none: through the sections"});
    }
    static void check(const auto& self, auto&& complain) {
        if (!self.sections.empty() && self.car.width <= 0)
            complain("car", "found no width of the car, expected one: the lanes are as wide as the car needs");
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
                complain("sections", which + " beside the end of the one before, expected way to get there");
        }
    }
};
static_assert(describesEveryMember<CourseParams>());

struct Point {
    double x;  // m
    double y;  // m
};

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
