// Double lane change and obstacle avoidance, after ISO 3888-1 and -2: whether the car stays between the cones.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"
#include "scenario/cones.h"

namespace tread {
namespace {

constexpr double kLaneChangeHalfWidth = 0.05;  // s

struct LaneChange {
    double cones_hit = 0;
    double clearance = kInfinity;  // m, negative outside of the lane
    bool completed = false;
    double entry_speed = kUndefined, exit_speed = kUndefined;  // m/s
    double duration = kUndefined;                              // s
    double largest_ay = 0, largest_yaw_rate = 0, largest_steering = 0, largest_steering_rate = 0;
    double largest_sideslip = kUndefined;

    bool clean() const { return completed && cones_hit == 0 && clearance >= 0; }
};

MetricTable<LaneChange> laneChangeTable() {
    return {
        {{"clean", "Clean run (1: yes, 0: no)", "-",
          "1 when the car goes through the whole course within its lanes and without touching a cone"},
         [](const LaneChange& c) { return c.clean() ? 1.0 : 0.0; }},
        {{"entry_speed", "Entry speed", "m/s",
          "speed when the centre of gravity passes the beginning of the first lane",
          Say{2, "enters at {} km/h", 1, 3.6}},
         [](const LaneChange& c) { return c.entry_speed; }},
        {{"cones_hit", "Cones hit", "-", "cones that the outline of the car touches, seen from above",
          Say{1, "{} cones hit", 0}, "= 0"},
         [](const LaneChange& c) { return c.cones_hit; }},
        {{"least_clearance", "Clearance to the lanes, minimum", "m",
          "between the outline of the car and the edges of the lanes; negative: outside",
          Say{3, "minimum clearance {} m", 2}},
         [](const LaneChange& c) { return c.clearance; }},
        {{"exit_speed", "Exit speed", "m/s",
          "speed when it passes the end of the last lane; undefined when it does not"},
         [](const LaneChange& c) { return c.exit_speed; }},
        {{"duration", "Duration", "s", "time between entry and exit"}, [](const LaneChange& c) { return c.duration; }},
        {{"largest_ay", "Lateral acceleration, maximum", "m/s2",
          "largest magnitude of the lateral acceleration on the course"},
         [](const LaneChange& c) { return c.largest_ay; }},
        {{"largest_yaw_rate", "Yaw rate, maximum", "deg/s", "largest magnitude of the yaw rate on the course"},
         [](const LaneChange& c) { return kDegrees * c.largest_yaw_rate; }},
        {{"largest_sideslip", "Sideslip angle, maximum", "deg",
          "largest magnitude of the sideslip angle on the course"},
         [](const LaneChange& c) { return kDegrees * c.largest_sideslip; }},
        {{"largest_steering", "Steering-wheel angle, maximum", "deg",
          "largest magnitude of the steering-wheel angle on the course"},
         [](const LaneChange& c) { return kDegrees * c.largest_steering; }},
        {{"largest_steering_rate", "Steering-wheel rate, maximum", "deg/s",
          "largest rate of the steering wheel on the course"},
         [](const LaneChange& c) { return kDegrees * c.largest_steering_rate; }},
    };
}

struct Pose {
    double x, y, yaw;
};

struct Cone {
    double x, y;
    bool hit = false;
};

// Room between the corners that are in a lane and its edges.
double clearance(const CarOutline& car, const Pose& pose, const std::vector<Lane>& course) {
    double least = kInfinity;
    for (const double along : {car.ahead, -car.behind}) {
        for (const double across : {0.5 * car.width, -0.5 * car.width}) {
            const double x = pose.x + along * std::cos(pose.yaw) - across * std::sin(pose.yaw);
            const double y = pose.y + along * std::sin(pose.yaw) + across * std::cos(pose.yaw);
            for (const Lane& lane : course) {
                if (x < lane.from || x > lane.to) continue;
                least = std::min({least, lane.left - y, y - lane.right});
            }
        }
    }
    return least;
}

double largest(const TimeSeries& series, double from, double to) {
    return std::max(std::abs(highest(series, from, to).value), std::abs(lowest(series, from, to).value));
}

LaneChange findLaneChange(const Log& log, const KnownCar& known) {
    const std::vector<Lane> course = lanes(known.course);
    if (course.empty()) notFound("it can be found only with its course; name the scenario with the lanes");
    const auto needed = channels(log, {"chassis.x", "chassis.y", "chassis.yaw", "driver.steering_wheel_angle",
                                       "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries &x = needed[0], &y = needed[1], &yaw = needed[2];
    const auto entry = firstCrossing(x, course.front().from, x.begin());
    if (!entry) notFound("the car does not reach the first lane");
    // The tail is through when the rear end has left the last lane; the log may end before.
    const auto exit = firstCrossing(x, course.back().to, *entry);
    const double end = firstCrossing(x, course.back().to + known.course.car.behind, *entry).value_or(x.end());

    LaneChange found;
    std::vector<Cone> cones;
    for (const Point& place : conesOf(course)) cones.push_back({place.x, place.y});
    for (std::size_t i = 0; i + 1 < x.size() && x.time[i] < end; ++i) {
        const double way = std::hypot(x.value[i + 1] - x.value[i], y.value[i + 1] - y.value[i]);
        const int steps = std::max(1, static_cast<int>(std::ceil(way / kWayStep)));
        for (int k = 0; k < steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            const auto between = [&](const TimeSeries& s) { return (1 - share) * s.value[i] + share * s.value[i + 1]; };
            const Pose pose{between(x), between(y), between(yaw)};
            found.clearance = std::min(found.clearance, clearance(known.course.car, pose, course));
            for (Cone& cone : cones)
                cone.hit = cone.hit || covers(known.course.car, {pose.x, pose.y}, pose.yaw, {cone.x, cone.y});
        }
    }
    found.cones_hit =
        static_cast<double>(std::count_if(cones.begin(), cones.end(), [](const Cone& c) { return c.hit; }));
    found.completed = exit.has_value();
    const TimeSeries v = speed(log);
    found.entry_speed = at(v, *entry);
    if (exit) {
        found.exit_speed = at(v, *exit);
        found.duration = *exit - *entry;
    }
    found.largest_ay = largest(cleaned(needed[5], kLaneChangeHalfWidth), *entry, end);
    found.largest_yaw_rate = largest(cleaned(needed[4], kLaneChangeHalfWidth), *entry, end);
    found.largest_steering = largest(cleaned(needed[3], kLaneChangeHalfWidth), *entry, end);
    found.largest_steering_rate = largest(derivative(needed[3], kLaneChangeHalfWidth), *entry, end);
    if (const auto slip = sideslip(log))
        found.largest_sideslip = largest(cleaned(*slip, kLaneChangeHalfWidth), *entry, end);
    return found;
}

}  // namespace

Manoeuvre laneChange() {
    return {
        "lane_change", "lane changes between cones: cones hit, clearance, speeds (after ISO 3888)",
        [] { return definitions(laneChangeTable()); },
        [](const Log& log, const KnownCar& known) { return values(laneChangeTable(), findLaneChange(log, known)); }};
}

}  // namespace tread
