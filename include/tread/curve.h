// A curve through given points: piecewise linear, held constant beyond both ends.
#pragma once

#include "tread/cpp20.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tread {

struct Curve {
    struct Point {
        double x;
        double y;
        bool operator==(const Point&) const = default;
    };
    std::vector<Point> points;  // x strictly increasing (the reader checks)

    bool empty() const { return points.empty(); }
    bool operator==(const Curve&) const = default;

    // Value at x; 0 for a curve without points. NaN gives NaN: what broke down upstream stays visible.
    double operator()(double x) const {
        if (points.empty()) return 0;
        if (std::isnan(x)) return x;
        if (x <= points.front().x) return points.front().y;
        if (x >= points.back().x) return points.back().y;
        const auto right = std::upper_bound(points.begin(), points.end(), x,
                                            [](double value, const Point& point) { return value < point.x; });
        const auto left = right - 1;
        return left->y + (right->y - left->y) * (x - left->x) / (right->x - left->x);
    }
};

}  // namespace tread
