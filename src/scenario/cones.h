// The cones of a course.
#pragma once

#include <vector>

#include "scenario/course.h"

namespace tread {

// Along the edges of the lanes.
std::vector<Point> conesOf(const std::vector<Lane>& course);

// All of a course: along its lanes, and single ones.
std::vector<Point> conesOf(const CourseParams& course);

// Whether the outline of a car, whose centre of gravity is `here`, covers a point.
bool covers(const CarOutline& car, const Point& here, double yaw, const Point& point);

}  // namespace tread
