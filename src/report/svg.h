// A chart as SVG: cross-plots, paths, tyre curves. Nothing but text goes out: no fonts, no
// scripts, no references.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/palette.h"

namespace tread {

struct Series {
    std::string name;       // in the legend; without a name the curve is not listed
    std::vector<double> x;  // values that are not finite interrupt the line
    std::vector<double> y;
    Colour colour = Colour::automatic;
    bool dashed = false;
    double width = 1.8;  // of the line, in pixels
    bool line = true;
    bool markers = false;
};

struct ChartAxis {
    std::string label;
    std::string unit;  // of the values as given; "-" for pure numbers
    std::optional<double> lowest = {};
    std::optional<double> highest = {};
};

struct ChartLabel {  // a word at a point of the chart
    double x;
    double y;
    std::string text;
};

// A chart of this width, or wider, takes the whole width of a page.
inline constexpr double kWideChart = 1000;  // pixels

struct Chart {
    std::string title;
    ChartAxis x;
    ChartAxis y;
    std::vector<Series> series;
    std::vector<ChartLabel> labels = {};
    bool equal_aspect = false;  // one metre is as long in x as in y; the chart becomes lower for a flat curve
    std::string note = {};      // a sentence below the chart; in a page only
    double width = 480;         // pixels
    double height = 360;
};

// For an HTML page, whose style sheet colours text and grid.
std::string svgInline(const Chart& chart);

}  // namespace tread
