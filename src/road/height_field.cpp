#include "tread/height_field.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// The cell of a coordinate and the share of it that is behind; beyond the ends the surface is level.
struct Cell {
    std::size_t first;
    double share;
    bool beyond;
};
Cell cellOf(double u, std::size_t nodes) {
    const double last = static_cast<double>(nodes - 1);
    const double inside = u > 0 ? std::min(u, last) : 0;  // 0 also for what is no number
    const double first = std::min(std::floor(inside), last - 1);
    return {static_cast<std::size_t>(first), inside - first, u < 0 || u > last};
}

}  // namespace

SurfacePoint HeightField::at(double x, double y) const {
    const Cell row = cellOf((x - x_first) / x_spacing, rows());
    const Cell column = cellOf((y - y_first) / y_spacing, static_cast<std::size_t>(columns));
    const double far_x = node(row.first + 1, column.first), far_y = node(row.first, column.first + 1);
    SurfacePoint point;
    if (row.share + column.share <= 1) {
        const double corner = node(row.first, column.first);
        point = {corner, far_x - corner, far_y - corner};
        point.height += row.share * point.slope_x + column.share * point.slope_y;
    } else {
        const double corner = node(row.first + 1, column.first + 1);
        point = {corner, corner - far_y, corner - far_x};
        point.height -= (1 - row.share) * point.slope_x + (1 - column.share) * point.slope_y;
    }
    point.slope_x = row.beyond ? 0 : point.slope_x / x_spacing;
    point.slope_y = column.beyond ? 0 : point.slope_y / y_spacing;
    return point;
}

}  // namespace tread
