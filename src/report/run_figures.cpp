#include "report/run_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "report/text.h"
#include "report/ticks.h"

namespace tread {
namespace {

std::vector<double> scaled(const std::vector<double>& values, double scale) {
    std::vector<double> out = values;
    for (double& value : out) value *= scale;
    return out;
}

double extent(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0 : *high - *low;
}

struct Pose {
    double time, x, y, yaw;
};

// A closed outline with a pointed nose, so that the heading can be seen.
Series outline(const Pose& pose, double length, double width) {
    static constexpr std::array<std::array<double, 2>, 6> kShape = {
        {{-0.5, 0.5}, {0.25, 0.5}, {0.5, 0.0}, {0.25, -0.5}, {-0.5, -0.5}, {-0.5, 0.5}}};
    Series series{.name = "", .x = {}, .y = {}, .colour = Colour::vermillion};
    series.width = 1.5;
    for (const auto& [along, across] : kShape) {
        series.x.push_back(pose.x + along * length * std::cos(pose.yaw) - across * width * std::sin(pose.yaw));
        series.y.push_back(pose.y + along * length * std::sin(pose.yaw) + across * width * std::cos(pose.yaw));
    }
    return series;
}

// About six moments at round times, none where the car has hardly moved since the last.
std::vector<Pose> fewPoses(const Log& log, double apart) {
    const std::vector<double>& time = log.channels.front().values;
    const std::vector<double>&x = log.find("chassis.x")->values, &y = log.find("chassis.y")->values;
    const std::vector<double>& yaw = log.find("chassis.yaw")->values;
    const Range duration{time.front(), time.back()};
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

const Channel* completeChannel(const Log& log, std::string_view name) {
    const Channel* channel = log.find(name);
    return channel && log.samples() > 0 && channel->values.size() == log.samples() ? channel : nullptr;
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
        chart.series.push_back(outline(pose, length, width));
        const double beside = 0.5 * width + 0.06 * std::max(path, length);
        chart.labels.push_back({pose.x + beside * std::sin(pose.yaw), pose.y - beside * std::cos(pose.yaw),
                                fmt::format("{:g} s", pose.time)});
    }
    if (chart.series.size() > 1)
        chart.series[1].name = enlarged > 1 ? fmt::format("car, {:g} times its size", enlarged) : "car";
    return chart;
}

std::optional<Chart> frictionFigure(const Log& log) {
    constexpr double kLifted = 0.05;  // of the wheel's largest load: below, a ratio of two small forces says nothing
    Chart chart{.title = "Used friction", .x = {"Fy / Fz", "-"}, .y = {"Fx / Fz", "-"}, .series = {}};
    chart.equal_aspect = true;
    for (const WheelLook& wheel : kWheelLooks) {
        const std::string prefix = fmt::format("wheel.{}.", wheel.key);
        const Channel* fx = completeChannel(log, prefix + "fx");
        const Channel* fy = completeChannel(log, prefix + "fy");
        const Channel* load = completeChannel(log, prefix + "load");
        if (!fx || !fy || !load) continue;
        const double least = kLifted * *std::max_element(load->values.begin(), load->values.end());
        Series series{
            .name = std::string(wheel.label), .x = {}, .y = {}, .colour = wheel.colour, .dashed = wheel.dashed};
        for (std::size_t i = 0; i < log.samples(); ++i) {
            const double fz = load->values[i];
            const bool on_ground = fz > least;
            series.x.push_back(on_ground ? fy->values[i] / fz : std::nan(""));
            series.y.push_back(on_ground ? fx->values[i] / fz : std::nan(""));
        }
        chart.series.push_back(std::move(series));
    }
    if (chart.series.empty()) return std::nullopt;

    Series circle{.name = "μ = 1", .x = {}, .y = {}, .colour = Colour::grey};
    circle.width = 1.2;
    for (int degree = 0; degree <= 360; degree += 5) {
        circle.x.push_back(std::cos(degree * std::numbers::pi / 180));
        circle.y.push_back(std::sin(degree * std::numbers::pi / 180));
    }
    chart.series.push_back(std::move(circle));
    chart.height = 480;  // room for a whole circle
    return chart;
}

std::optional<Chart> steeringFigure(const Log& log) {
    const Channel* angle = completeChannel(log, "driver.steering_wheel_angle");
    const Channel* ay = completeChannel(log, "chassis.ay");
    if (!angle || !ay) return std::nullopt;
    constexpr double kStraight = 0.01;  // rad: a run without steering has no response to it
    if (extent(angle->values) < kStraight) return std::nullopt;
    const DisplayUnit unit = displayUnit(angle->unit);
    Chart chart{.title = "Response to steering",
                .x = {"steering-wheel angle", unit.unit},
                .y = {"lateral acceleration", ay->unit},
                .series = {}};
    chart.series.push_back(
        {.name = "", .x = scaled(angle->values, unit.scale), .y = ay->values, .colour = Colour::blue});
    return chart;
}

}  // namespace tread
