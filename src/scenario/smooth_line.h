// A smooth line through given points: cubic splines of both coordinates over the length of the chords, whose curvature
// is continuous, as that of the clothoids of which roads are made.
#pragma once

#include <vector>

#include "scenario/course.h"

namespace tread {

struct SmoothPoint {
    Point place;
    double curvature;   // 1/m, positive to the left
    std::size_t piece;  // between the points `piece` and the next
    double share;       // of the way between them
};

// Points at most `spacing` m apart. At the ends of an open line the curvature is zero; a closed one comes back to its
// first point, which then stands at the end again. Points that repeat the one before are passed over.
std::vector<SmoothPoint> smoothLine(std::vector<Point> points, bool closed, double spacing);

}  // namespace tread
