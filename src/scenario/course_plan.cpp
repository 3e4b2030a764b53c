#include "scenario/course_plan.h"

#include <algorithm>
#include <cmath>

#include "base/math/elementary.h"
#include "scenario/smooth_line.h"

namespace tread {
namespace {

constexpr double kSmoothSpacing = 0.5;  // m between the points of a smooth line: 2 mm off an arc of 15 m radius

// The line where the car starts, in its direction; as it is when it keeps its coordinates.
std::vector<Point> placed(const CourseLine& line) {
    std::vector<Point> points;
    for (const LinePoint& point : line.points) points.push_back({point.x, point.y});
    return points;
}

void moveToStart(std::vector<SmoothPoint>& line) {
    const Point origin = line.front().place, next = line[1].place;
    // The tangent at the beginning: half of the first piece's turn back from its chord.
    const double length = hypotenuse(next.x - origin.x, next.y - origin.y);
    const double heading = arctan2(next.y - origin.y, next.x - origin.x) - 0.5 * line.front().curvature * length;
    const double c = cosine(heading), s = sine(heading);
    // x and y apart, for the reason that road/fourier.h gives.
    std::vector<double> ahead;
    for (const SmoothPoint& point : line)
        ahead.push_back(c * (point.place.x - origin.x) + s * (point.place.y - origin.y));
    for (SmoothPoint& point : line) point.place.y = c * (point.place.y - origin.y) - s * (point.place.x - origin.x);
    for (std::size_t i = 0; i < line.size(); ++i) line[i].place.x = ahead[i];
}

SpeedLimits resolved(SpeedLimits limits, const KnownGrip& grip) {
    if (limits.of_car > 0) limits.lateral = limits.braking = limits.of_car * grip.lateral;
    return limits;
}

}  // namespace

std::vector<double> speedFromLimits(const std::vector<double>& way, const std::vector<double>& curvature, bool closed,
                                    const SpeedLimits& limits) {
    const std::size_t n = way.size();
    std::vector<double> speed(n, limits.highest);
    for (std::size_t i = 0; i < n; ++i) {
        if (curvature[i] != 0) speed[i] = std::min(speed[i], std::sqrt(limits.lateral / std::abs(curvature[i])));
    }
    // The speed at `to` that is reached from the one at `from`.
    const auto reach = [&](std::size_t from, std::size_t to, double limit) {
        const double v2 = speed[from] * speed[from];
        const double used = v2 * std::max(std::abs(curvature[from]), std::abs(curvature[to])) / limits.lateral;
        const double left = limit * std::sqrt(std::max(0.0, 1 - used * used));
        speed[to] = std::min(speed[to], std::sqrt(v2 + 2 * left * std::abs(way[to] - way[from])));
    };
    // The last point of a closed path is its first: a second round knows the speed with which the first began.
    for (int round = 0; round < (closed ? 2 : 1); ++round) {
        if (closed) speed[n - 1] = speed[0] = std::min(speed[0], speed[n - 1]);
        for (std::size_t i = n - 1; i > 0; --i) reach(i, i - 1, limits.braking);
        if (closed) speed[n - 1] = speed[0] = std::min(speed[0], speed[n - 1]);
        for (std::size_t i = 0; i + 1 < n; ++i) reach(i, i + 1, limits.acceleration);
    }
    if (closed) speed[n - 1] = speed[0] = std::min(speed[0], speed[n - 1]);
    return speed;
}

CoursePlan::CoursePlan(const CourseParams& course, const KnownGrip& grip) {
    const CourseLine& given = course.line;
    if (given.points.empty()) {
        path_ = Path(coursePath(course));
        return;
    }
    std::vector<SmoothPoint> line = smoothLine(placed(given), given.closed, kSmoothSpacing);
    if (line.empty()) return;
    if (!given.in_place) moveToStart(line);
    std::vector<Point> points;
    for (const SmoothPoint& point : line) {
        const LinePoint &from = given.points[point.piece], &to = given.points[(point.piece + 1) % given.points.size()];
        points.push_back(point.place);
        curvature_.push_back(point.curvature);
        width_.push_back((1 - point.share) * from.width + point.share * to.width);
        speed_.push_back((1 - point.share) * from.speed + point.share * to.speed);
    }
    path_ = Path(std::move(points), given.closed);
    if (given.limits.given())
        speed_ = speedFromLimits(path_.ways(), curvature_, given.closed, resolved(given.limits, grip));
}

double CoursePlan::at(const std::vector<double>& values, double way) const {
    return values.empty() ? 0 : path_.between(values, way);
}

double CoursePlan::acceleration(double way) const {
    constexpr double kAside = 0.5;  // m to either side
    const double before = speed(way - kAside), after = speed(way + kAside);
    return (after * after - before * before) / (4 * kAside);
}

double CoursePlan::laps(double way) const {
    return path_.empty() ? 0 : way / path_.length();
}

}  // namespace tread
