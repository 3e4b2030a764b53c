// The course as a driver knows it before the drive: path, curvature and the speed that is wanted at each place.
#pragma once

#include <vector>

#include "scenario/path.h"

namespace tread {

// What a driver knows of the car's grip.
struct KnownGrip {
    double lateral = 9;  // m/s2, at which an axle's tyres are at their end
};

class CoursePlan {
public:
    CoursePlan() = default;
    // `start_speed`: m/s, at the beginning of an open course.
    explicit CoursePlan(const CourseParams& course, const KnownGrip& grip = {});

    bool empty() const { return path_.empty(); }
    const Path& path() const { return path_; }

    // Of a way along the course, which goes on over laps.
    double curvature(double way) const { return at(curvature_, way); }  // 1/m
    double speed(double way) const { return at(speed_, way); }          // m/s; 0: none is wanted
    double width(double way) const { return at(width_, way); }          // m; 0: not given
    double acceleration(double way) const;                              // m/s2, of the wanted speed

    // Laps of a closed course that are complete there; of an open one the share that is driven.
    double laps(double way) const;

private:
    double at(const std::vector<double>& values, double way) const;

    Path path_;
    std::vector<double> curvature_, speed_, width_;  // at each point of the path
};

// Speed over a path from its curvature: v = sqrt(lateral / |curvature|), then backward and forward along the path what
// braking and acceleration are left on the friction ellipse,
//     (ax / limit)^2 + (v^2 curvature / lateral)^2 <= 1.
// `way`: m, increasing, one per curvature. A closed path goes on where it ends.
std::vector<double> speedFromLimits(const std::vector<double>& way, const std::vector<double>& curvature, bool closed,
                                    const SpeedLimits& limits);

}  // namespace tread
