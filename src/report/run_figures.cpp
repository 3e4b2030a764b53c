#include "report/run_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "report/cross_plot.h"
#include "report/ticks.h"

namespace tread {
namespace {

double extent(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0 : *high - *low;
}

// About six moments at round times, none where the car has hardly moved since the last.
std::vector<Pose> fewPoses(const Log& log, double apart) {
    const std::vector<double>& time = log.channels.front().values;
    const std::vector<double>&x = log.find("chassis.x")->values, &y = log.find("chassis.y")->values;
    const std::vector<double>& yaw = log.find("chassis.yaw")->values;
    const AxisRange duration{time.front(), time.back()};
    std::vector<Pose> poses;
    for (const double moment : ticks(duration, niceStep(duration.span(), 6))) {
        const auto at =
            std::min<std::size_t>(std::lower_bound(time.begin(), time.end(), moment) - time.begin(), time.size() - 1);
        const Pose pose{moment, x[at], y[at], yaw[at]};
        if (poses.empty() || std::hypot(pose.x - poses.back().x, pose.y - poses.back().y) > apart)
            poses.push_back(pose);
    }
    return poses;
}

}  // namespace

Series carOutline(const Pose& pose, double ahead, double behind, double width) {
    const double shoulder = ahead - 0.25 * (ahead + behind);
    const std::array<std::array<double, 2>, 6> shape = {{{-behind, 0.5 * width},
                                                         {shoulder, 0.5 * width},
                                                         {ahead, 0.0},
                                                         {shoulder, -0.5 * width},
                                                         {-behind, -0.5 * width},
                                                         {-behind, 0.5 * width}}};
    Series series{.name = "", .x = {}, .y = {}, .colour = Colour::vermillion};
    series.width = 1.5;
    for (const auto& [along, across] : shape) {
        series.x.push_back(pose.x + along * std::cos(pose.yaw) - across * std::sin(pose.yaw));
        series.y.push_back(pose.y + along * std::sin(pose.yaw) + across * std::cos(pose.yaw));
    }
    return series;
}

std::optional<Chart> pathFigure(const Log& log, const CarShape& car) {
    const Channel* x = completeChannel(log, "chassis.x");
    const Channel* y = completeChannel(log, "chassis.y");
    const Channel* yaw = completeChannel(log, "chassis.yaw");
    if (!x || !y) return std::nullopt;

    Chart chart{.title = "Path from above", .x = {"x", "m"}, .y = {"y", "m"}, .series = {}};
    chart.equal_aspect = true;
    chart.series.push_back({.name = "centre of gravity", .x = x->values, .y = y->values, .colour = Colour::blue});
    if (!yaw) return chart;

    // On a long path a car to scale would be a speck: it is enlarged by a round factor then, and the note says so.
    constexpr double kSmallest = 0.06;  // of the path
    const double path = std::max(extent(x->values), extent(y->values));
    const double enlarged = std::max(1.0, niceStep(kSmallest * path / car.length(), 1));
    const double length = enlarged * car.length(), width = enlarged * car.width;
    for (const Pose& pose : fewPoses(log, 1.1 * length)) {
        chart.series.push_back(carOutline(pose, enlarged * car.ahead, enlarged * car.behind, width));
        const double beside = 0.5 * width + 0.06 * std::max(path, length);
        chart.labels.push_back({pose.x + beside * std::sin(pose.yaw), pose.y - beside * std::cos(pose.yaw),
                                fmt::format("{:g} s", pose.time)});
    }
    if (chart.series.size() > 1)
        chart.series[1].name = enlarged > 1 ? fmt::format("car, enlarged {:g} times", enlarged) : "car";
    return chart;
}

namespace {

// Nothing when the log lacks a force.
std::optional<Series> usedFriction(const Log& log, const WheelLook& wheel) {
    constexpr double kLifted = 0.05;  // of the wheel's largest load: below, a ratio of two small forces says nothing
    const std::string prefix = fmt::format("wheel.{}.", wheel.key);
    const Channel* fx = completeChannel(log, prefix + "fx");
    const Channel* fy = completeChannel(log, prefix + "fy");
    const Channel* load = completeChannel(log, prefix + "load");
    if (!fx || !fy || !load) return std::nullopt;
    const Channel* speed = completeChannel(log, kForwardSpeed.channel);
    const double least = kLifted * *std::max_element(load->values.begin(), load->values.end());
    Series series{.name = std::string(wheel.label), .x = {}, .y = {}, .colour = wheel.colour, .dashed = wheel.dashed};
    for (std::size_t i = 0; i < log.samples(); ++i) {
        const double fz = load->values[i];
        const bool rolls = !speed || std::abs(speed->values[i]) > kStanding;
        const bool drawn = fz > least && rolls;
        series.x.push_back(drawn ? fy->values[i] / fz : std::nan(""));
        series.y.push_back(drawn ? fx->values[i] / fz : std::nan(""));
    }
    return series;
}

Series circle(std::string name, double radius) {
    Series series{.name = std::move(name), .x = {}, .y = {}, .colour = Colour::grey};
    series.width = 1.2;
    for (int degree = 0; degree <= 360; degree += 5) {
        series.x.push_back(radius * std::cos(degree * std::numbers::pi / 180));
        series.y.push_back(radius * std::sin(degree * std::numbers::pi / 180));
    }
    return series;
}

Chart frictionChart(std::string title, std::vector<Series> wheels, double height) {
    Chart chart{.title = std::move(title), .x = {"Fy / Fz", "-"}, .y = {"Fx / Fz", "-"}, .series = std::move(wheels)};
    chart.equal_aspect = true;
    chart.series.push_back(circle("μ = 1", 1));
    chart.height = height;  // room for a whole circle
    return chart;
}

}  // namespace

std::optional<Chart> frictionFigure(const Log& log) {
    std::vector<Series> wheels;
    for (const WheelLook& wheel : kWheelLooks) {
        if (auto series = usedFriction(log, wheel)) wheels.push_back(std::move(*series));
    }
    if (wheels.empty()) return std::nullopt;
    return frictionChart("Used friction", std::move(wheels), 480);
}

std::vector<Chart> wheelFrictionFigures(const Log& log) {
    std::vector<Chart> charts;
    for (const WheelLook& wheel : kWheelLooks) {
        auto series = usedFriction(log, wheel);
        if (!series) continue;
        charts.push_back(frictionChart(fmt::format("Friction circle, {}", wheel.label), {std::move(*series)}, 460));
    }
    return charts;
}

std::optional<Chart> steeringFigure(const Log& log) {
    const Channel* angle = completeChannel(log, kSteeringWheel.channel);
    constexpr double kStraight = 0.01;  // rad: a run without steering has no response to it
    if (!angle || extent(angle->values) < kStraight) return std::nullopt;
    return crossPlot(log, "Response to steering", kSteeringWheel, kLateral);
}

std::optional<Chart> accelerationFigure(const Log& log) {
    auto chart = crossPlot(log, "g-g diagram", kLateral, kLongitudinal);
    if (!chart) return chart;
    chart->series.push_back(circle("1 g", kStandardGravity));
    chart->equal_aspect = true;
    chart->height = 480;
    return chart;
}

}  // namespace tread
