// The height of a road on a regular grid of points, from a file or sampled from another road.
//
// Between the points the surface is two triangles per cell, divided along the line from (x, y + step) to (x + step, y):
// as Bullet's height field divides it, so that a wheel and a collision shape find the same ground. Beyond its border
// the surface goes on level.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tread/api.h"
#include "tread/describe.h"
#include "tread/problem.h"

namespace tread {

// Height of a surface over a place, and how it rises along x and y.
struct SurfacePoint {
    double height = 0;   // m
    double slope_x = 0;  // -
    double slope_y = 0;  // -

    SurfacePoint& operator+=(const SurfacePoint& other) {
        height += other.height;
        slope_x += other.slope_x;
        slope_y += other.slope_y;
        return *this;
    }
    friend SurfacePoint operator*(double factor, const SurfacePoint& point) {
        return {factor * point.height, factor * point.slope_x, factor * point.slope_y};
    }
};

// Coordinates and heights as they can be on Earth, spacings that can be measured: m.
inline constexpr Limits kOnEarth{-1e7, 1e7};
inline constexpr Limits kGridSpacing{1e-4, 1e5};

struct HeightField {
    static constexpr bool kIncludable = true;

    double x_first = 0;
    double y_first = 0;
    double x_spacing = kRequired;
    double y_spacing = kRequired;
    int columns = 2;
    std::vector<double> heights;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x_first), About{"m", "x of the first row", kOnEarth});
        field(TREAD_FIELD(y_first), About{"m", "y of the first column", kOnEarth});
        field(TREAD_FIELD(x_spacing), About{"m", "distance between rows", kGridSpacing});
        field(TREAD_FIELD(y_spacing), About{"m", "distance between columns", kGridSpacing});
        field(TREAD_FIELD(columns), About{"-", "points in a row", {2, 1e6}});
        field(TREAD_FIELD(heights),
              About{"m", "heights, row by row: all of the first x, then all of the next", kOnEarth});
    }

    static void check(const auto& self, auto&& complain) {
        const auto columns = static_cast<std::size_t>(self.columns);
        if (self.heights.size() < 2 * columns || self.heights.size() % columns != 0) {
            complain("heights", "found " + std::to_string(self.heights.size()) + " heights, expected rows of " +
                                    std::to_string(columns) + ", and at least two of them");
        }
    }

    std::size_t rows() const { return heights.size() / static_cast<std::size_t>(columns); }
    double node(std::size_t row, std::size_t column) const {
        return heights[row * static_cast<std::size_t>(columns) + column];
    }

    // The triangle over a place.
    TREAD_API SurfacePoint at(double x, double y) const;
};
static_assert(describesEveryMember<HeightField>());

// Reads a CSV file: a first row with any name that holds "[m]" and the y of every column, then rows of x and heights.
//     x\y [m], -1, 0, 1
//     0,        0, 0, 0.01
//     0.5,      0, 0, 0.02
// Both must increase in equal steps. Blank lines and lines that begin with # do not count. True when the file is such
// a file by its name; what is wrong with it goes to `problems`.
TREAD_API bool readForeign(HeightField& field, const std::filesystem::path& file, std::vector<Problem>& problems);

}  // namespace tread
