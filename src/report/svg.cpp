#include "report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "base/text/markup.h"
#include "report/decimate.h"
#include "report/text.h"
#include "report/ticks.h"

namespace tread {
namespace {

constexpr double kFont = 12;        // pixels
constexpr double kCharacter = 6.6;  // mean width of a character of that font, a little on the safe side
constexpr double kLegendRow = 18;   // pixels
constexpr double kMargin = 10;      // around everything
constexpr double kPadding = 0.04;   // of the span of the values, free on both sides
constexpr std::string_view kDashed = R"( stroke-dasharray="6 3")";
constexpr std::string_view kSolid = R"( stroke-linecap="round")";  // a curve of one point is a dot
constexpr std::size_t kMostPoints = 2000;
constexpr std::string_view kInk = "#1c2024", kGrid = "#dfe2e6", kAxis = "#9aa1a9";

using Out = std::back_insert_iterator<std::string>;

double textWidth(std::string_view text) {
    // Bytes that continue a UTF-8 character take no room of their own.
    const auto characters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
    return static_cast<double>(characters) * kCharacter;
}

struct SeriesLook {
    std::string_view colour;
    bool dashed;
};

SeriesLook lookOf(const Series& series, std::size_t index) {
    if (series.colour != Colour::automatic) return {hex(series.colour), series.dashed};
    const CurveLook automatic = automaticLook(index);
    return {hex(automatic.colour), series.dashed || automatic.dashed};
}

// Where everything goes: the plot rectangle in pixels and the values at its edges.
struct Layout {
    double left = 0, top = 0, width = 0, height = 0, total_height = 0;
    AxisRange x{0, 1}, y{0, 1};
    double step_x = 1, step_y = 1;
    std::vector<std::vector<std::size_t>> legend;  // rows of indices of series

    double pixelX(double value) const { return (value - x.lowest) / x.span() * width; }
    double pixelY(double value) const { return (y.highest - value) / y.span() * height; }
};

// Smallest and largest value of the points that are drawn, a little room around; never empty.
AxisRange rangeOf(const Chart& chart, std::vector<double> Series::*values, double ChartLabel::*label_value,
                  const ChartAxis& axis) {
    AxisRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Series& series : chart.series) {
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
            const double value = (series.*values)[i];
            range.lowest = std::min(range.lowest, value);
            range.highest = std::max(range.highest, value);
        }
    }
    for (const ChartLabel& label : chart.labels) {
        const double value = label.*label_value;
        if (!std::isfinite(value)) continue;
        range = {std::min(range.lowest, value), std::max(range.highest, value)};
    }
    if (!(range.lowest <= range.highest)) range = {0, 1};
    const double size = std::max({1.0, std::abs(range.lowest), std::abs(range.highest)});
    if (range.span() < 1e-9 * size) {  // constant but for rounding
        range = {range.lowest - 0.1 * size, range.highest + 0.1 * size};
    }
    const double padding = kPadding * range.span();
    range = {axis.lowest.value_or(range.lowest - padding), axis.highest.value_or(range.highest + padding)};
    if (!(range.highest > range.lowest)) range.highest = range.lowest + 1;
    return range;
}

std::vector<std::vector<std::size_t>> legendRows(const Chart& chart) {
    std::vector<std::vector<std::size_t>> rows;
    double used = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        if (chart.series[i].name.empty()) continue;
        const double width = 44 + textWidth(chart.series[i].name);
        if (used + width > chart.width - 2 * kMargin) {
            rows.emplace_back();
            used = 0;
        }
        rows.back().push_back(i);
        used += width;
    }
    return rows;
}

void equaliseAspect(Layout& layout) {
    constexpr double kFlattest = 0.3;  // height over width of the plot of a straight path
    layout.height = std::clamp(layout.width * layout.y.span() / layout.x.span(),
                               std::min(kFlattest * layout.width, layout.height), layout.height);
    const double per_pixel = std::max(layout.x.span() / layout.width, layout.y.span() / layout.height);
    const auto widen = [per_pixel](AxisRange& range, double pixels) {
        const double more = (per_pixel * pixels - range.span()) / 2;
        range = {range.lowest - more, range.highest + more};
    };
    widen(layout.x, layout.width);
    widen(layout.y, layout.height);
}

Layout layoutOf(const Chart& chart) {
    Layout layout;
    layout.x = rangeOf(chart, &Series::x, &ChartLabel::x, chart.x);
    layout.y = rangeOf(chart, &Series::y, &ChartLabel::y, chart.y);
    layout.legend = legendRows(chart);

    layout.top = kMargin + (chart.title.empty() ? 0 : 22) + kLegendRow * static_cast<double>(layout.legend.size()) + 4;
    const double bottom = kMargin + 2 * kFont + 14;  // tick labels and the axis label
    layout.height = std::max(40.0, chart.height - layout.top - bottom);

    // Room for the widest y label; for equal aspect the range may still widen, which adds at most a character.
    layout.step_y = niceStep(layout.y.span(), std::max(2, static_cast<int>(layout.height / 34)));
    double widest = chart.equal_aspect ? kCharacter : 0;
    double extra = widest;
    for (const double tick : ticks(layout.y, layout.step_y)) {
        widest = std::max(widest, extra + textWidth(tickLabel(tick, layout.step_y)));
    }
    layout.left = kMargin + kFont + 12 + widest;
    layout.width = std::max(40.0, chart.width - layout.left - kMargin - 6);
    if (chart.equal_aspect) equaliseAspect(layout);

    layout.step_x = niceStep(layout.x.span(), std::max(2, static_cast<int>(layout.width / 46)));
    if (chart.equal_aspect) {
        layout.step_y = layout.step_x;
        if (ticks(layout.y, layout.step_y).size() < 2) layout.step_y = niceStep(layout.y.span(), 4);
    }
    layout.total_height = layout.top + layout.height + bottom;
    return layout;
}

void writeFrame(Out out, const Chart& chart, const Layout& layout) {
    const double right = layout.left + layout.width, bottom = layout.top + layout.height;
    for (const double tick : ticks(layout.x, layout.step_x)) {
        const double x = layout.left + layout.pixelX(tick);
        fmt::format_to(out, R"(<line class="{}" stroke="{}" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)",
                       tick == 0 ? "axis" : "grid", tick == 0 ? kAxis : kGrid, x, layout.top, x, bottom);
        fmt::format_to(out, R"(<text class="ink" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)", x,
                       bottom + kFont + 4, tickLabel(tick, layout.step_x));
    }
    for (const double tick : ticks(layout.y, layout.step_y)) {
        const double y = layout.top + layout.pixelY(tick);
        fmt::format_to(out, R"(<line class="{}" stroke="{}" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)",
                       tick == 0 ? "axis" : "grid", tick == 0 ? kAxis : kGrid, layout.left, y, right, y);
        fmt::format_to(out, R"(<text class="ink" x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>)", layout.left - 6,
                       y + 0.35 * kFont, tickLabel(tick, layout.step_y));
    }
    fmt::format_to(
        out, R"(<rect class="axis" fill="none" stroke="{}" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)",
        kAxis, layout.left, layout.top, layout.width, layout.height);
    fmt::format_to(out, R"(<text class="ink" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)",
                   layout.left + layout.width / 2, bottom + 2 * kFont + 10,
                   escapeMarkup(withUnit(chart.x.label, chart.x.unit)));
    fmt::format_to(
        out,
        R"svg(<text class="ink" transform="translate({:.1f} {:.1f}) rotate(-90)" text-anchor="middle">{}</text>)svg",
        kMargin + 0.8 * kFont, layout.top + layout.height / 2, escapeMarkup(withUnit(chart.y.label, chart.y.unit)));
}

void writeLegend(Out out, const Chart& chart, const Layout& layout) {
    double y = kMargin + (chart.title.empty() ? 0 : 22) + 0.5 * kLegendRow;
    for (const auto& row : layout.legend) {
        double x = kMargin;
        for (const std::size_t index : row) {
            const Series& series = chart.series[index];
            const SeriesLook look = lookOf(series, index);
            if (series.line) {
                fmt::format_to(out, R"(<path stroke="{}" stroke-width="{:.3g}"{} d="M{:.1f} {:.1f}h22"/>)", look.colour,
                               std::max(2.0, series.width), look.dashed ? kDashed : kSolid, x, y);
            }
            if (series.markers) {
                fmt::format_to(out,
                               R"(<path stroke="{}" stroke-width="6" stroke-linecap="round" d="M{:.1f} {:.1f}h0"/>)",
                               look.colour, x + 11, y);
            }
            fmt::format_to(out, R"(<text class="ink" x="{:.1f}" y="{:.1f}">{}</text>)", x + 27, y + 0.35 * kFont,
                           escapeMarkup(series.name));
            x += 44 + textWidth(series.name);
        }
        y += kLegendRow;
    }
}

// The path data of one series: lines between finite points, or one dot each.
std::string pathOf(const Series& series, const Layout& layout, bool dots) {
    const std::array<std::span<const double>, 2> curves = {series.x, series.y};
    std::string data, last;
    bool pen_down = false;
    for (const std::size_t i : keepExtremes(curves, kMostPoints)) {
        if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
            pen_down = false;
            continue;
        }
        std::string point = fmt::format("{:.1f} {:.1f}", layout.pixelX(series.x[i]), layout.pixelY(series.y[i]));
        if (pen_down && point == last) continue;
        fmt::format_to(std::back_inserter(data), "{}{}{}", pen_down && !dots ? 'L' : 'M', point, dots ? "h0" : "");
        last = std::move(point);
        pen_down = true;
    }
    return data;
}

void writeSeries(Out out, const Chart& chart, const Layout& layout) {
    // An inner svg element clips to the plot without an identifier that would have to be unique in a page.
    fmt::format_to(out, R"(<svg x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}">)", layout.left, layout.top,
                   layout.width, layout.height);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const Series& series = chart.series[i];
        const SeriesLook look = lookOf(series, i);
        if (series.line) {
            fmt::format_to(out,
                           R"(<path fill="none" stroke="{}" stroke-width="{:.3g}" stroke-linejoin="round"{} d="{}"/>)",
                           look.colour, series.width, look.dashed ? kDashed : kSolid, pathOf(series, layout, false));
        }
        if (series.markers) {
            fmt::format_to(out, R"(<path stroke="{}" stroke-width="5" stroke-linecap="round" d="{}"/>)", look.colour,
                           pathOf(series, layout, true));
        }
    }
    for (const ChartLabel& label : chart.labels) {
        if (!std::isfinite(label.x) || !std::isfinite(label.y)) continue;
        fmt::format_to(out, R"(<text class="ink" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)",
                       layout.pixelX(label.x), layout.pixelY(label.y) + 0.35 * kFont, escapeMarkup(label.text));
    }
    fmt::format_to(out, "</svg>");
}

}  // namespace

std::string svgInline(const Chart& chart) {
    const Layout layout = layoutOf(chart);
    std::string text;
    const Out out(text);
    fmt::format_to(out,
                   R"(<svg class="tread-chart" viewBox="0 0 {:.0f} {:.0f}" width="{:.0f}" height="{:.0f}" role="img" )"
                   R"(aria-label="{}" font-family="system-ui, 'DejaVu Sans', sans-serif" font-size="{}" fill="{}">)",
                   chart.width, layout.total_height, chart.width, layout.total_height, escapeMarkup(chart.title), kFont,
                   kInk);
    if (!chart.title.empty()) {
        fmt::format_to(out, R"(<text class="ink" x="{:.1f}" y="{:.1f}" font-size="14" font-weight="600">{}</text>)",
                       kMargin, kMargin + 12, escapeMarkup(chart.title));
    }
    writeFrame(out, chart, layout);
    writeSeries(out, chart, layout);
    writeLegend(out, chart, layout);
    fmt::format_to(out, "</svg>");
    return text;
}

}  // namespace tread
