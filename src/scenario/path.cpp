#include "scenario/path.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

constexpr double kSame = 1e-6;  // m: of two points as near as this, the first one counts, on a path that comes back

}  // namespace

Path::Path(std::vector<Point> points) {
    for (const Point& point : points) {
        const double step = points_.empty() ? 0 : std::hypot(point.x - points_.back().x, point.y - points_.back().y);
        if (!points_.empty() && step == 0) continue;
        way_.push_back(way_.empty() ? 0 : way_.back() + step);
        points_.push_back(point);
    }
}

std::size_t Path::pieceAt(double way) const {
    const auto behind = std::upper_bound(way_.begin() + 1, way_.end() - 1, way);
    return static_cast<std::size_t>(behind - way_.begin()) - 1;
}

Point Path::at(double way) const {
    const std::size_t i = pieceAt(way);
    const double share = (way - way_[i]) / (way_[i + 1] - way_[i]);
    return {points_[i].x + share * (points_[i + 1].x - points_[i].x),
            points_[i].y + share * (points_[i + 1].y - points_[i].y)};
}

double Path::nearest(const Point& here, double from, double reach) const {
    double best = from, least = std::hypot(at(from).x - here.x, at(from).y - here.y);
    for (std::size_t i = pieceAt(from); i + 1 < points_.size() && way_[i] <= from + reach; ++i) {
        const Point &a = points_[i], &b = points_[i + 1];
        const double length = way_[i + 1] - way_[i];
        const double along = ((here.x - a.x) * (b.x - a.x) + (here.y - a.y) * (b.y - a.y)) / length;
        const bool last = i + 2 == points_.size();
        const double way = way_[i] + std::clamp(along, 0.0, last ? along + length : length);
        if (way < from) continue;
        const double distance = std::hypot(at(way).x - here.x, at(way).y - here.y);
        if (distance < least - kSame) {
            least = distance;
            best = way;
        }
    }
    return best;
}

double Path::nearest(const Point& here) const {
    return nearest(here, 0, way_.back());
}

}  // namespace tread
