#include "scenario/smooth_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/math/elementary.h"

namespace tread {
namespace {

using Numbers = std::vector<double>;

// One equation of a tridiagonal system: below x[i - 1] + on x[i] + above x[i + 1] = right.
struct Row {
    double below = 0, on = 1, above = 0, right = 0;
};

// Thomas' algorithm.
Numbers tridiagonal(std::vector<Row> rows) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double factor = rows[i].below / rows[i - 1].on;
        rows[i].on -= factor * rows[i - 1].above;
        rows[i].right -= factor * rows[i - 1].right;
    }
    Numbers x(rows.size());
    for (std::size_t i = rows.size(); i-- > 0;)
        x[i] = (rows[i].right - (i + 1 < rows.size() ? rows[i].above * x[i + 1] : 0)) / rows[i].on;
    return x;
}

// The same where the last unknown stands before the first (Sherman and Morrison, Ann. Math. Stat. 21, 1950).
Numbers cyclic(std::vector<Row> rows) {
    Row &first = rows.front(), &last = rows.back();
    const double corner = -first.on, share_of_last = first.below / corner;
    first.on -= corner;
    last.on -= last.above * share_of_last;
    std::vector<Row> beside = rows;
    for (Row& row : beside) row.right = 0;
    beside.front().right = corner;
    beside.back().right = last.above;
    Numbers x = tridiagonal(rows);
    const Numbers z = tridiagonal(beside);
    const double factor = (x.front() + share_of_last * x.back()) / (1 + z.front() + share_of_last * z.back());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= factor * z[i];
    return x;
}

// Second derivatives of a cubic spline at its knots, which are `length` apart: length[i] behind knot i.
Numbers bends(const Numbers& value, const Numbers& length, bool closed) {
    const std::size_t n = value.size();
    std::vector<Row> rows(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (!closed && (i == 0 || i + 1 == n)) continue;  // natural ends
        const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
        rows[i] = {length[before], 2 * (length[before] + length[i]), length[i],
                   6 * ((value[after] - value[i]) / length[i] - (value[i] - value[before]) / length[before])};
    }
    return closed ? cyclic(std::move(rows)) : tridiagonal(std::move(rows));
}

// Value and first two derivatives at a share of the piece between two knots.
struct Cubic {
    double value, slope, bend;
};
Cubic cubic(double from, double to, double bend_from, double bend_to, double length, double share) {
    const double a = 1 - share, b = share;
    const double square = length * length / 6;
    return {a * from + b * to + square * ((a * a * a - a) * bend_from + (b * b * b - b) * bend_to),
            (to - from) / length + length / 6 * ((3 * b * b - 1) * bend_to - (3 * a * a - 1) * bend_from),
            a * bend_from + b * bend_to};
}

}  // namespace

std::vector<SmoothPoint> smoothLine(std::vector<Point> points, bool closed, double spacing) {
    const auto apart = [](const Point& a, const Point& b) { return hypotenuse(b.x - a.x, b.y - a.y); };
    std::vector<std::size_t> kept;  // of the given points
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept.empty() || apart(points[kept.back()], points[i]) > 0) kept.push_back(i);
    }
    if (closed && kept.size() > 1 && apart(points[kept.back()], points[kept.front()]) == 0) kept.pop_back();
    const std::size_t n = kept.size();
    if (n < (closed ? 3u : 2u)) return {};
    Numbers x, y, length;
    for (std::size_t i = 0; i < n; ++i) {
        x.push_back(points[kept[i]].x);
        y.push_back(points[kept[i]].y);
        length.push_back(apart(points[kept[i]], points[kept[(i + 1) % n]]));
    }
    const Numbers bend_x = bends(x, length, closed), bend_y = bends(y, length, closed);

    std::vector<SmoothPoint> line;
    const std::size_t pieces = closed ? n : n - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        const std::size_t next = (i + 1) % n;
        const int steps = std::max(1, static_cast<int>(std::ceil(length[i] / spacing)));
        const bool last = i + 1 == pieces;
        for (int k = 0; k < steps + (last ? 1 : 0); ++k) {
            const double share = static_cast<double>(k) / steps;
            const Cubic along = cubic(x[i], x[next], bend_x[i], bend_x[next], length[i], share);
            const Cubic across = cubic(y[i], y[next], bend_y[i], bend_y[next], length[i], share);
            const double speed = hypotenuse(along.slope, across.slope);
            const double turn = along.slope * across.bend - across.slope * along.bend;
            line.push_back({{along.value, across.value}, turn / (speed * speed * speed), kept[i], share});
        }
    }
    return line;
}

}  // namespace tread
