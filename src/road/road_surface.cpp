#include "tread/road_surface.h"

#include <array>
#include <cmath>

#include "base/math/elementary.h"
#include "road/fade.h"
#include "road/obstacle.h"
#include "road/plane.h"
#include "road/roughness.h"

namespace tread {
namespace {

constexpr double kCrownFade = 20;  // m, over which the crown begins: what a road takes to change its cross fall

}  // namespace

struct RoadSurface::Parts {
    RoadParams params;
    double half_side;  // m, of the square over which a tyre averages
    std::vector<ObstacleSurface> obstacles;
    std::optional<Roughness> roughness;
};

RoadSurface::RoadSurface(const RoadParams& params) {
    auto parts = std::make_unique<Parts>(Parts{params, 0.5 * params.contact_length, {}, {}});
    for (const Obstacle& obstacle : params.obstacles) parts->obstacles.emplace_back(obstacle);
    if (isRough(params.roughness)) parts->roughness.emplace(params.roughness, params.contact_length);
    parts_ = std::move(parts);
}

RoadSurface::~RoadSurface() = default;

RoadContact RoadSurface::contact(const Vector3& centre_W, std::size_t) const {
    const SurfacePoint road = averaged(centre_W.x(), centre_W.y());
    RoadContact contact;
    contact.point_W = Vector3(centre_W.x(), centre_W.y(), road.height);
    contact.normal_W = Vector3(-road.slope_x, -road.slope_y, 1).normalized();
    contact.friction = friction(centre_W.x(), centre_W.y());
    return contact;
}

// Grade, bank and crown: a hyperbola whose asymptotes are the two falls, through 0 at the crown.
SurfacePoint RoadSurface::base(double x, double y) const {
    const RoadParams& p = parts_->params;
    SurfacePoint point{p.grade * x + p.bank * y, p.grade, p.bank};
    if (p.crown != 0) {
        const double aside = y - p.crown_y;
        const double root = hypotenuse(aside, p.crown_rounding);
        const SurfacePoint crown{-p.crown * (root - p.crown_rounding), 0, -p.crown * aside / root};
        point += fadedIn(crown, x - p.crown_begin, kCrownFade);
    }
    return point;
}

SurfacePoint RoadSurface::at(double x, double y) const {
    SurfacePoint point = base(x, y);
    for (const ObstacleSurface& obstacle : parts_->obstacles) point += obstacle.at(x, y, 0);
    if (parts_->roughness) point += parts_->roughness->at(x, y);
    if (parts_->params.height_field) point += parts_->params.height_field->at(x, y);
    return point;
}

SurfacePoint RoadSurface::averaged(double x, double y) const {
    SurfacePoint point = base(x, y);
    for (const ObstacleSurface& obstacle : parts_->obstacles) point += obstacle.at(x, y, parts_->half_side);
    if (parts_->roughness) point += parts_->roughness->averaged(x, y);
    if (parts_->params.height_field) point += fieldAveraged(x, y);
    return point;
}

// Height and slopes are both means of the same nine points (Gauss and Legendre): the slopes are those of the mean
// height.
SurfacePoint RoadSurface::fieldAveraged(double x, double y) const {
    const HeightField& field = *parts_->params.height_field;
    if (parts_->half_side <= 0) return field.at(x, y);
    const double away = std::sqrt(0.6) * parts_->half_side;
    struct Place {
        double offset, weight;
    };
    const std::array<Place, 3> places{{{-away, 5 / 18.0}, {0, 8 / 18.0}, {away, 5 / 18.0}}};
    SurfacePoint mean;
    for (const Place& along : places) {
        for (const Place& across : places)
            mean += along.weight * across.weight * field.at(x + along.offset, y + across.offset);
    }
    return mean;
}

double RoadSurface::friction(double x, double y) const {
    const RoadParams& p = parts_->params;
    for (auto patch = p.friction_patches.rbegin(); patch != p.friction_patches.rend(); ++patch) {
        if (x >= patch->x_from && x < patch->x_to && y >= patch->y_from && y < patch->y_to)
            return p.friction * patch->friction;
    }
    return p.friction;
}

std::unique_ptr<Road> makeRoad(const RoadParams& params) {
    const bool plane = params.crown == 0 && params.friction_patches.empty() && params.obstacles.empty() &&
                       !isRough(params.roughness) && !params.height_field;
    if (plane) return std::make_unique<PlaneRoad>(params.grade, params.bank, params.friction);
    return std::make_unique<RoadSurface>(params);
}

HeightField sampled(const RoadSurface& road, const RoadArea& area, double spacing) {
    // Whole cells that cover the area.
    const auto nodes = [&](double from, double to) {
        return static_cast<std::size_t>(std::max(1.0, std::ceil((to - from) / spacing - 1e-9))) + 1;
    };
    HeightField field;
    field.x_first = area.x_from;
    field.y_first = area.y_from;
    field.x_spacing = field.y_spacing = spacing;
    field.columns = static_cast<int>(nodes(area.y_from, area.y_to));
    const std::size_t rows = nodes(area.x_from, area.x_to);
    field.heights.reserve(rows * static_cast<std::size_t>(field.columns));
    for (std::size_t i = 0; i < rows; ++i) {
        for (int j = 0; j < field.columns; ++j) {
            const double x = area.x_from + static_cast<double>(i) * spacing, y = area.y_from + j * spacing;
            field.heights.push_back(road.at(x, y).height);
        }
    }
    return field;
}

}  // namespace tread
