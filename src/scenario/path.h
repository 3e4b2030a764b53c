// A path of straight pieces, by its length.
#pragma once

#include <vector>

#include "scenario/course.h"

namespace tread {

class Path {
public:
    Path() = default;
    explicit Path(std::vector<Point> points);  // none, or at least two that differ

    bool empty() const { return points_.empty(); }

    // The point so far along the path, m; beyond its ends, straight on.
    Point at(double way) const;

    // How far along the path the point nearest to `here` is, at or behind `from`; looks `reach` ahead.
    double nearest(const Point& here, double from, double reach) const;
    double nearest(const Point& here) const;

private:
    std::size_t pieceAt(double way) const;

    std::vector<Point> points_;
    std::vector<double> way_;  // m, along the path up to each point
};

}  // namespace tread
