#include "report/course_figure.h"

#include <algorithm>
#include <cmath>

#include "report/cross_plot.h"
#include "report/run_figures.h"
#include "scenario/cones.h"
#include "scenario/course_plan.h"

namespace tread {
namespace {

constexpr double kApart = 6.5;  // m of way between two outlines
constexpr double kBeside = 15;  // m that are shown before and behind the lanes

// Points of the path, and of a line beside it by a share of its width; nothing where no width is given.
Series besidePath(const CoursePlan& plan, double share, const char* name) {
    constexpr double kSpacing = 1;  // m, more than a chart shows
    Series series{.name = name, .x = {}, .y = {}, .colour = Colour::grey, .dashed = share == 0};
    series.width = 1.2;
    const double length = plan.path().length();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kSpacing)));
    for (int i = 0; i <= steps; ++i) {
        const double way = length * i / steps, width = plan.width(way);
        const Point here = plan.path().at(way), ahead = plan.path().at(way + 0.5 * kSpacing);
        const double dx = ahead.x - here.x, dy = ahead.y - here.y, step = std::hypot(dx, dy);
        const bool drawn = share == 0 || width > 0;
        series.x.push_back(drawn ? here.x - share * width * dy / step : std::nan(""));
        series.y.push_back(drawn ? here.y + share * width * dx / step : std::nan(""));
    }
    return series;
}

std::optional<Chart> lineFigure(const RunReport& content) {
    const CourseParams& course = content.record->scenario.course;
    const Channel *x = completeChannel(content.log, "chassis.x"), *y = completeChannel(content.log, "chassis.y");
    if (!x || !y) return std::nullopt;
    const CoursePlan plan(course);
    if (plan.empty()) return std::nullopt;
    Chart chart{.title = "Course from above", .x = {"x", "m"}, .y = {"y", "m"}, .series = {}};
    chart.equal_aspect = true;
    chart.width = kWideChart;
    // As high as the course is long, within what a page shows.
    Point low = plan.path().at(0), high = low;
    for (double way = 0; way < plan.path().length(); way += 1) {
        const Point here = plan.path().at(way);
        low = {std::min(low.x, here.x), std::min(low.y, here.y)};
        high = {std::max(high.x, here.x), std::max(high.y, here.y)};
    }
    const double share = (high.y - low.y) / std::max(1.0, high.x - low.x);
    chart.height = std::clamp(share * kWideChart, 230.0, 520.0);
    if (std::any_of(course.line.points.begin(), course.line.points.end(), [](const auto& p) { return p.width > 0; })) {
        chart.series.push_back(besidePath(plan, 0.5, "edges of the road"));
        chart.series.push_back(besidePath(plan, -0.5, ""));
    }
    Series path = besidePath(plan, 0, "path of the course");
    path.colour = Colour::vermillion;
    chart.series.push_back(std::move(path));
    chart.series.push_back({.name = "centre of gravity", .x = x->values, .y = y->values, .colour = Colour::blue});
    Series cones{.name = "cones", .x = {}, .y = {}, .colour = Colour::amber, .line = false, .markers = true};
    for (const PathPoint& cone : course.cones) {
        cones.x.push_back(cone.x);
        cones.y.push_back(cone.y);
    }
    if (!cones.x.empty()) chart.series.push_back(std::move(cones));
    return chart;
}

}  // namespace

std::optional<Chart> courseFigure(const RunReport& content) {
    if (!content.record) return std::nullopt;
    const CourseParams& course = content.record->scenario.course;
    const std::vector<Lane> driven = lanes(course);
    const Channel *x = completeChannel(content.log, "chassis.x"), *y = completeChannel(content.log, "chassis.y");
    const Channel* yaw = completeChannel(content.log, "chassis.yaw");
    if (driven.empty()) return lineFigure(content);
    if (!x || !y || !yaw) return std::nullopt;

    Chart chart{.title = "Course from above", .x = {"x", "m"}, .y = {"y", "m"}, .series = {}};
    chart.equal_aspect = true;
    chart.width = kWideChart;
    chart.height = 230;  // lanes are far longer than wide
    chart.x.lowest = driven.front().from - kBeside;
    chart.x.highest = driven.back().to + kBeside;
    for (const Lane& lane : driven) {
        for (const double edge : {lane.left, lane.right}) {
            Series line{
                .name = "", .x = {lane.from, lane.to}, .y = {edge, edge}, .colour = Colour::grey, .dashed = true};
            line.width = 1;
            chart.series.push_back(std::move(line));
        }
    }
    Series cones{.name = "cones", .x = {}, .y = {}, .colour = Colour::amber, .line = false, .markers = true};
    for (const Point& cone : conesOf(driven)) {
        cones.x.push_back(cone.x);
        cones.y.push_back(cone.y);
    }
    Series way{.name = "centre of gravity", .x = {}, .y = {}, .colour = Colour::blue};
    std::vector<Series> outlines;
    double next = *chart.x.lowest + course.car.behind;
    for (std::size_t i = 0; i < x->values.size(); ++i) {
        const Pose pose{0, x->values[i], y->values[i], yaw->values[i]};
        if (pose.x < *chart.x.lowest || pose.x > *chart.x.highest) continue;
        way.x.push_back(pose.x);
        way.y.push_back(pose.y);
        if (pose.x < next || pose.x > *chart.x.highest - course.car.ahead) continue;
        next = pose.x + kApart;
        outlines.push_back(carOutline(pose, course.car.ahead, course.car.behind, course.car.width));
    }
    if (!outlines.empty()) outlines.front().name = "car";
    chart.series.push_back(std::move(way));
    for (Series& outline : outlines) chart.series.push_back(std::move(outline));
    chart.series.push_back(std::move(cones));
    return chart;
}

}  // namespace tread
