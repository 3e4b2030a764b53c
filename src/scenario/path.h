// A path of straight pieces, by its length.
#pragma once

#include <vector>

#include "scenario/course.h"

namespace tread {

class Path {
public:
    Path() = default;
    // None, or at least two points that differ. The last point of a closed path is its first: ways go on over laps.
    explicit Path(std::vector<Point> points, bool closed = false);

    bool empty() const { return points_.empty(); }
    bool closed() const { return closed_; }
    double length() const { return way_.empty() ? 0 : way_.back(); }  // m, of one lap

    // The point so far along the path, m; beyond the ends of an open one, straight on.
    Point at(double way) const;

    // How far along the path the point nearest to `here` is, at or behind `from`; looks `reach` ahead.
    double nearest(const Point& here, double from, double reach) const;
    double nearest(const Point& here) const;

    // Distance from the path at that place, m, positive to its left.
    double aside(const Point& here, double way) const;

    // m, along the path up to each point; and a value between those that are given for the points.
    const std::vector<double>& ways() const { return way_; }
    double between(const std::vector<double>& values, double way) const;

private:
    std::size_t pieceAt(double way) const;
    double lapStart(double way) const;  // m, of the lap in which that is

    std::vector<Point> points_;
    std::vector<double> way_;
    bool closed_ = false;
};

}  // namespace tread
