#include "scenario/cones.h"

#include <cmath>

#include "base/math/elementary.h"

namespace tread {

std::vector<Point> conesOf(const std::vector<Lane>& course) {
    std::vector<Point> cones;
    for (const Lane& lane : course) {
        for (int i = 0; i < lane.cones; ++i) {
            const double x = lane.from + (lane.to - lane.from) * i / (lane.cones - 1);
            cones.push_back({x, lane.left});
            cones.push_back({x, lane.right});
        }
    }
    return cones;
}

std::vector<Point> conesOf(const CourseParams& course) {
    std::vector<Point> cones = conesOf(lanes(course));
    for (const PathPoint& cone : course.cones) cones.push_back({cone.x, cone.y});
    return cones;
}

bool covers(const CarOutline& car, const Point& here, double yaw, const Point& point) {
    const double dx = point.x - here.x, dy = point.y - here.y;
    const double along = dx * cosine(yaw) + dy * sine(yaw);
    const double across = dy * cosine(yaw) - dx * sine(yaw);
    return along > -car.behind && along < car.ahead && std::abs(across) < 0.5 * car.width;
}

}  // namespace tread
