// Driving a course: how close to its path, how quickly, and whether its single cones are passed.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "scenario/cones.h"
#include "scenario/course_plan.h"

namespace tread {
namespace {

constexpr double kNearLine = 1;  // m: a drive that begins within that behind the line begins its first lap there

struct Driven {
    double lap_time = kUndefined, laps = kUndefined, length = kUndefined;  // s, -, m
    double largest_error = 0, rms_error = 0;                               // m
    double speed_error = kUndefined;                                       // m/s
    double cones_hit = kUndefined, wrong_side = kUndefined;
    double entry_speed = 0, largest_ay = kUndefined, largest_sideslip = kUndefined, largest_steering = kUndefined;
    bool complete() const { return laps >= 1; }
    double clean() const {
        if (std::isnan(laps)) return kUndefined;
        return complete() && !(cones_hit > 0) && !(wrong_side > 0) ? 1 : 0;
    }
};

MetricTable<Driven> courseTable() {
    return {
        {{"lap_time", "Lap time", "s",
          "of the fastest complete lap, from line to line, interpolated; of an open course from its beginning to its "
          "end; undefined without the scenario and when none is complete",
          Say{1, "a lap takes {} s", 2}},
         [](const Driven& d) { return d.lap_time; }},
        {{"largest_cross_track_error", "Cross-track error, maximum", "m",
          "largest distance of the centre of gravity from the path of the course",
          Say{2, "at most {} m off its path", 2}},
         [](const Driven& d) { return d.largest_error; }},
        {{"rms_cross_track_error", "Cross-track error, rms", "m", "root mean square of that distance over time"},
         [](const Driven& d) { return d.rms_error; }},
        {{"clean", "Course clean", "-",
          "1 when the course is driven to its end without touching a cone, each passed on the side of the path"},
         [](const Driven& d) { return d.clean(); }},
        {{"cones_hit", "Cones hit", "-",
          "single cones of the course that the outline of the car touches; undefined without cones"},
         [](const Driven& d) { return d.cones_hit; }},
        {{"cones_on_wrong_side", "Cones passed on the wrong side", "-",
          "single cones that the car passes on the other side than the path does"},
         [](const Driven& d) { return d.wrong_side; }},
        {{"entry_speed", "Speed at the beginning of the course", "m/s", "speed at the beginning of the course",
          Say{3, "enters at {} km/h", 1, 3.6}},
         [](const Driven& d) { return d.entry_speed; }},
        {{"mean_speed", "Speed, mean", "m/s", "length of the course over the lap time"},
         [](const Driven& d) { return d.length / d.lap_time; }},
        {{"rms_speed_error", "Speed error, rms", "m/s",
          "root mean square over time of the target speed minus the speed of the car"},
         [](const Driven& d) { return d.speed_error; }},
        {{"laps", "Laps completed", "-", "complete laps"}, [](const Driven& d) { return d.laps; }},
        {{"largest_ay", "Lateral acceleration, peak", "m/s2", "largest magnitude of the lateral acceleration"},
         [](const Driven& d) { return d.largest_ay; }},
        {{"largest_sideslip", "Sideslip angle, peak", "deg", "largest magnitude of the sideslip angle"},
         [](const Driven& d) { return kDegrees * d.largest_sideslip; }},
        {{"largest_steering", "Steering-wheel angle, peak", "deg", "largest magnitude of the steering-wheel angle"},
         [](const Driven& d) { return kDegrees * d.largest_steering; }},
    };
}

double rms(const TimeSeries& series) {
    TimeSeries squares = series;
    for (double& value : squares.value) value *= value;
    return std::sqrt(mean(squares, squares.begin(), squares.end()));
}

double largestOf(const Log& log, std::string_view channel) {
    const auto series = channelIfThere(log, channel);
    return series ? largestSample(*series) : kUndefined;
}

// Times at which the car passes the line: at the beginning and after each lap.
void findLaps(const TimeSeries& way, const CoursePlan& plan, Driven& found) {
    found.length = plan.path().length();
    double from = way.value.front();
    if (std::abs(from) < kNearLine) from = std::max(from, 0.0);
    double lap = std::ceil(from / found.length - kNearLine / found.length);
    auto passed = firstCrossing(way, std::max(lap * found.length, way.value.front()), way.begin());
    found.laps = 0;
    while (passed) {
        const auto next = firstCrossing(way, ++lap * found.length, *passed);
        if (!next) break;
        found.laps += 1;
        if (!(found.lap_time <= *next - *passed)) found.lap_time = *next - *passed;
        passed = plan.path().closed() ? next : std::nullopt;
    }
}

// The side of the car's way on which a point lies, 1 left and -1 right, where the way passes it most closely.
double sideOf(const Point& point, const TimeSeries& x, const TimeSeries& y) {
    double least = kInfinity, side = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double dx = x.value[i + 1] - x.value[i], dy = y.value[i + 1] - y.value[i];
        const double to_x = point.x - x.value[i], to_y = point.y - y.value[i];
        const double distance = std::hypot(to_x, to_y);
        if (distance >= least || (dx == 0 && dy == 0)) continue;
        least = distance;
        side = dx * to_y - dy * to_x > 0 ? 1 : -1;
    }
    return side;
}

void findCones(const Log& log, const CourseParams& course, const CoursePlan& plan, Driven& found) {
    if (course.cones.empty()) return;
    const auto needed = channels(log, {"chassis.x", "chassis.y", "chassis.yaw"});
    const TimeSeries &x = needed[0], &y = needed[1], &yaw = needed[2];
    found.cones_hit = found.wrong_side = 0;
    for (const PathPoint& cone : course.cones) {
        const Point place{cone.x, cone.y};
        bool hit = false;
        for (std::size_t i = 0; i + 1 < x.size() && !hit; ++i) {
            const double way = std::hypot(x.value[i + 1] - x.value[i], y.value[i + 1] - y.value[i]);
            if (std::hypot(place.x - x.value[i], place.y - y.value[i]) >
                way + course.car.ahead + course.car.behind + course.car.width)
                continue;
            const int steps = std::max(1, static_cast<int>(std::ceil(way / kWayStep)));
            for (int k = 0; k < steps && !hit; ++k) {
                const double share = static_cast<double>(k) / steps;
                const auto between = [&](const TimeSeries& s) {
                    return (1 - share) * s.value[i] + share * s.value[i + 1];
                };
                hit = covers(course.car, {between(x), between(y)}, between(yaw), place);
            }
        }
        found.cones_hit += hit ? 1 : 0;
        const double of_path = plan.path().aside(place, plan.path().nearest(place)) > 0 ? 1 : -1;
        found.wrong_side += sideOf(place, x, y) == of_path ? 0 : 1;
    }
}

Driven findDriven(const Log& log, const KnownCar& known) {
    const auto needed = channels(log, {"course.distance", "course.cross_track_error", "chassis.vx"});
    Driven found;
    found.largest_error = largestSample(needed[1]);
    found.rms_error = rms(needed[1]);
    found.entry_speed = needed[2].value.front();
    if (const auto wanted = channelIfThere(log, "course.speed"); wanted && largestSample(*wanted) > 0) {
        TimeSeries missing = *wanted;
        for (std::size_t i = 0; i < missing.size(); ++i) missing.value[i] -= needed[2].value[i];
        found.speed_error = rms(missing);
    }
    found.largest_ay = largestOf(log, "chassis.ay");
    found.largest_sideslip = largestOf(log, "chassis.sideslip");
    found.largest_steering = largestOf(log, "driver.steering_wheel_angle");
    if (!hasCourse(known.course)) return found;
    const CoursePlan plan(known.course);
    findLaps(needed[0], plan, found);
    findCones(log, known.course, plan, found);
    return found;
}

}  // namespace

Manoeuvre course() {
    return {"course", "driving a course: lap time, distance from its path, cones",
            [] { return definitions(courseTable()); },
            [](const Log& log, const KnownCar& car) { return values(courseTable(), findDriven(log, car)); }};
}

}  // namespace tread
