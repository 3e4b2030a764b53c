#include "scenario/path.h"

#include <algorithm>
#include <cmath>

#include "base/math/elementary.h"

namespace tread {
namespace {

constexpr double kSame = 1e-6;  // m: of two points as near as this, the first one counts, on a path that comes back

}  // namespace

Path::Path(std::vector<Point> points, bool closed) : closed_(closed) {
    for (const Point& point : points) {
        const double step = points_.empty() ? 0 : hypotenuse(point.x - points_.back().x, point.y - points_.back().y);
        if (!points_.empty() && step == 0) continue;
        way_.push_back(way_.empty() ? 0 : way_.back() + step);
        points_.push_back(point);
    }
}

double Path::lapStart(double way) const {
    return closed_ ? std::floor(way / length()) * length() : 0;
}

std::size_t Path::pieceAt(double way) const {
    const auto behind = std::upper_bound(way_.begin() + 1, way_.end() - 1, way);
    return static_cast<std::size_t>(behind - way_.begin()) - 1;
}

Point Path::at(double way) const {
    way -= lapStart(way);
    const std::size_t i = pieceAt(way);
    const double share = (way - way_[i]) / (way_[i + 1] - way_[i]);
    return {points_[i].x + share * (points_[i + 1].x - points_[i].x),
            points_[i].y + share * (points_[i + 1].y - points_[i].y)};
}

double Path::between(const std::vector<double>& values, double way) const {
    way -= lapStart(way);
    const std::size_t i = pieceAt(way);
    const double share = std::clamp((way - way_[i]) / (way_[i + 1] - way_[i]), 0.0, 1.0);
    return (1 - share) * values[i] + share * values[i + 1];
}

double Path::nearest(const Point& here, double from, double reach) const {
    double best = from, least = hypotenuse(at(from).x - here.x, at(from).y - here.y);
    double lap = lapStart(from);
    for (std::size_t i = pieceAt(from - lap); lap + way_[i] <= from + reach;) {
        const Point &a = points_[i], &b = points_[i + 1];
        const double length = way_[i + 1] - way_[i];
        const double along = ((here.x - a.x) * (b.x - a.x) + (here.y - a.y) * (b.y - a.y)) / length;
        const bool last = i + 2 == points_.size();
        const double onPiece = last && !closed_ ? std::max(along, 0.0) : std::clamp(along, 0.0, length);
        const double way = lap + way_[i] + onPiece;
        if (way >= from) {
            const double distance = hypotenuse(at(way).x - here.x, at(way).y - here.y);
            if (distance < least - kSame) {
                least = distance;
                best = way;
            }
        }
        if (!last) {
            ++i;
        } else if (closed_) {
            i = 0;
            lap += this->length();
        } else {
            break;
        }
    }
    return best;
}

double Path::nearest(const Point& here) const {
    return nearest(here, 0, closed_ ? 0.5 * length() : length());
}

double Path::aside(const Point& here, double way) const {
    way -= lapStart(way);
    const std::size_t i = pieceAt(way);
    const Point &a = points_[i], &b = points_[i + 1], foot = at(way);
    return ((b.x - a.x) * (here.y - foot.y) - (b.y - a.y) * (here.x - foot.x)) / (way_[i + 1] - way_[i]);
}

}  // namespace tread
