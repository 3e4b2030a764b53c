#include "report/replay_road.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "report/pack.h"
#include "tread/road_surface.h"

namespace tread {
namespace {

constexpr double kAround = 80;              // m of plane around the way
constexpr double kTile = 4;                 // m, side of a tile
constexpr double kBesideTheWay = 3;         // m of uneven road beside the way
constexpr double kEven = 0.0005;            // m: a tile that is plane to this is drawn as four corners
constexpr int kFinest = 40;                 // cells along the side of a tile: 0.1 m
constexpr std::size_t kMostNodes = 120000;  // in the page: about 320 kB

using Tile = std::pair<int, int>;  // its place in tiles along x and y

RoadArea areaAround(std::span<const Point> way) {
    const auto [left, right] = std::minmax_element(way.begin(), way.end(), [](auto a, auto b) { return a.x < b.x; });
    const auto [low, high] = std::minmax_element(way.begin(), way.end(), [](auto a, auto b) { return a.y < b.y; });
    return {left->x - kAround, right->x + kAround, low->y - kAround, high->y + kAround};
}

std::set<Tile> tilesBeside(std::span<const Point> way) {
    const auto index = [](double at) { return static_cast<int>(std::floor(at / kTile)); };
    std::set<Tile> tiles;
    for (const Point& point : way) {
        for (int i = index(point.x - kBesideTheWay); i <= index(point.x + kBesideTheWay); ++i) {
            for (int j = index(point.y - kBesideTheWay); j <= index(point.y + kBesideTheWay); ++j) tiles.insert({i, j});
        }
    }
    return tiles;
}

class Surface {
public:
    explicit Surface(const RoadParams& params) : grade_(params.grade), bank_(params.bank), road_(params) {}

    // Height above the plane at the nodes of a tile, row by row along x.
    std::vector<double> heights(const Tile& tile, int cells) const {
        std::vector<double> out;
        for (int i = 0; i <= cells; ++i) {
            for (int j = 0; j <= cells; ++j) {
                const double x = kTile * (tile.first + static_cast<double>(i) / cells);
                const double y = kTile * (tile.second + static_cast<double>(j) / cells);
                out.push_back(road_.at(x, y).height - grade_ * x - bank_ * y);
            }
        }
        return out;
    }

    bool even(const Tile& tile) const {
        const std::vector<double> corner = heights(tile, 1), all = heights(tile, kFinest);
        for (int i = 0; i <= kFinest; ++i) {
            for (int j = 0; j <= kFinest; ++j) {
                const double u = static_cast<double>(i) / kFinest, v = static_cast<double>(j) / kFinest;
                const double plane =
                    (1 - u) * ((1 - v) * corner[0] + v * corner[1]) + u * ((1 - v) * corner[2] + v * corner[3]);
                if (std::abs(all[static_cast<std::size_t>(i * (kFinest + 1) + j)] - plane) > kEven) return false;
            }
        }
        return true;
    }

private:
    double grade_, bank_;
    RoadSurface road_;
};

std::size_t nodesOf(int cells) {
    return static_cast<std::size_t>((cells + 1) * (cells + 1));
}

nlohmann::ordered_json mesh(const RoadParams& params, std::span<const Point> way) {
    const Surface surface(params);
    const std::set<Tile> tiles = tilesBeside(way);
    std::vector<int> cells;
    for (const Tile& tile : tiles) cells.push_back(surface.even(tile) ? 1 : kFinest);
    const auto uneven = static_cast<std::size_t>(std::count(cells.begin(), cells.end(), kFinest));
    int finest = kFinest;
    while (finest > 1 && uneven * nodesOf(finest) > kMostNodes) finest /= 2;

    std::vector<double> heights;
    auto places = nlohmann::ordered_json::array();
    auto cell = cells.begin();
    for (const Tile& tile : tiles) {
        const int n = std::min(*cell++, finest);
        const std::vector<double> here = surface.heights(tile, n);
        heights.insert(heights.end(), here.begin(), here.end());
        places.push_back({tile.first, tile.second, n});
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (heights.empty() || *high - *low < kEven) return nullptr;

    std::vector<std::uint16_t> steps;
    const double step = (*high - *low) / 65535;
    for (const double height : heights)
        steps.push_back(static_cast<std::uint16_t>(std::lround((height - *low) / step)));
    return {{"tile", kTile}, {"tiles", places}, {"lowest", *low}, {"step", step}, {"heights", packed(steps)}};
}

}  // namespace

nlohmann::ordered_json replayRoad(const RoadParams& road, std::span<const Point> way) {
    const RoadArea area = areaAround(way);
    auto patches = nlohmann::ordered_json::array();
    for (const FrictionPatch& patch : road.friction_patches) {
        const RoadArea seen{std::max(patch.x_from, area.x_from), std::min(patch.x_to, area.x_to),
                            std::max(patch.y_from, area.y_from), std::min(patch.y_to, area.y_to)};
        if (seen.x_from >= seen.x_to || seen.y_from >= seen.y_to) continue;
        patches.push_back(
            {{"friction", road.friction * patch.friction}, {"area", {seen.x_from, seen.x_to, seen.y_from, seen.y_to}}});
    }
    return {{"area", {area.x_from, area.x_to, area.y_from, area.y_to}},
            {"grade", road.grade},
            {"bank", road.bank},
            {"friction", road.friction},
            {"patches", patches},
            {"mesh", mesh(road, way)}};
}

}  // namespace tread
