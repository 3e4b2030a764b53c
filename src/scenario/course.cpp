#include "scenario/course.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/math/elementary.h"

namespace tread {
namespace {

constexpr double kRun = 1000;     // m of straight before and behind the lanes
constexpr double kSpacing = 0.5;  // m between the points of a change of lanes

double widthOf(const LaneSection& section, const CarOutline& car) {
    return std::max(section.width_factor * car.width + section.width_extra, section.width_least);
}

double rightEdge(const LaneSection& section, const CarOutline& car) {
    return section.edge == Edge::right ? section.at : section.at - widthOf(section, car);
}

double middle(const Lane& lane) {
    return 0.5 * (lane.left + lane.right);
}

}  // namespace

bool hasCourse(const CourseParams& course) {
    return !course.sections.empty() || !course.path.empty() || course.line.given();
}

std::vector<Lane> lanes(const CourseParams& course) {
    std::vector<Lane> out;
    if (course.sections.empty()) return out;
    const LaneSection& first = course.sections.front();
    const double origin = rightEdge(first, course.car) + 0.5 * widthOf(first, course.car);
    for (const LaneSection& section : course.sections) {
        const double right = rightEdge(section, course.car) - origin;
        out.push_back({course.begin + section.from, course.begin + section.to, right,
                       right + widthOf(section, course.car), section.cones});
    }
    return out;
}

std::vector<Point> coursePath(const CourseParams& course) {
    std::vector<Point> path;
    for (const PathPoint& point : course.path) path.push_back({point.x, point.y});
    const std::vector<Lane> through = lanes(course);
    if (!path.empty() || through.empty()) return path;

    path.push_back({through.front().from - kRun, middle(through.front())});
    for (std::size_t i = 0; i < through.size(); ++i) {
        if (i > 0) {
            const Lane &before = through[i - 1], &next = through[i];
            const double length = next.from - before.to, across = middle(next) - middle(before);
            const int steps = static_cast<int>(std::ceil(length / kSpacing));
            for (int k = 1; k < steps; ++k) {
                const double share = static_cast<double>(k) / steps;
                path.push_back({before.to + share * length,
                                middle(before) + across * 0.5 * (1 - cosine(std::numbers::pi * share))});
            }
        }
        if (path.back().x < through[i].from) path.push_back({through[i].from, middle(through[i])});
        path.push_back({through[i].to, middle(through[i])});
    }
    path.push_back({through.back().to + kRun, middle(through.back())});
    return path;
}

}  // namespace tread
