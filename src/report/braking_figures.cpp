#include "report/braking_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "metrics/stop.h"
#include "report/cross_plot.h"
#include "report/shown_metric.h"

namespace tread {
namespace {

constexpr double kPressed = 0.01;  // of the brake pedal

// The way since the brake pedal went down, m; before that not a number, which is not drawn.
std::vector<double> brakingWay(const std::vector<double>& time, const std::vector<double>& brake,
                               const std::vector<double>& speed) {
    std::vector<double> way(time.size(), std::nan(""));
    const auto first = static_cast<std::size_t>(
        std::find_if(brake.begin(), brake.end(), [](double pedal) { return pedal > kPressed; }) - brake.begin());
    if (first < way.size()) way[first] = 0;
    for (std::size_t i = first + 1; i < way.size(); ++i)
        way[i] = way[i - 1] + 0.5 * (speed[i] + speed[i - 1]) * (time[i] - time[i - 1]);
    return way;
}

Chart overWay(std::string title, ChartAxis y, const std::vector<double>& way, std::vector<double> values) {
    Chart chart{
        .title = std::move(title), .x = {"distance from the brake pedal on", "m"}, .y = std::move(y), .series = {}};
    chart.series.push_back({.name = "", .x = way, .y = std::move(values), .colour = Colour::blue});
    return chart;
}

// The largest deceleration that is drawn, as the metric has it.
void addPeak(Chart& chart, const std::vector<Metric>& metrics) {
    const auto peak = metricNamed(metrics, "peak_deceleration");
    if (!peak) return;
    const Series& curve = chart.series.front();
    std::size_t most = curve.x.size();
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (std::isfinite(curve.x[i]) && (most == curve.x.size() || curve.y[i] > curve.y[most])) most = i;
    }
    if (most == curve.x.size()) return;
    chart.series.push_back({.name = fmt::format("peak, {:.2f} m/s²", *peak),
                            .x = {curve.x[most]},
                            .y = {*peak},
                            .colour = Colour::amber,
                            .line = false,
                            .markers = true});
}

}  // namespace

std::vector<Chart> brakingFigures(const RunReport& content) {
    const Log& log = content.log;
    const Channel *brake = completeChannel(log, "driver.brake"), *vx = completeChannel(log, kForwardSpeed.channel);
    const Channel* ax = completeChannel(log, kLongitudinal.channel);
    if (!brake || !vx ||
        std::none_of(brake->values.begin(), brake->values.end(), [](double p) { return p > kPressed; }))
        return {};
    const std::vector<double> way = brakingWay(log.channels.front().values, brake->values, vx->values);
    const PlotValues speed = *valuesFor(log, kForwardSpeed);
    // Braking, without the jerk of coming to rest; of a log without standstill, without what is nearly one.
    const std::vector<double>& time = log.channels.front().values;
    const std::optional<double> end = developedEnd(log);
    std::vector<double> way_braking = way;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (end ? time[i] > *end : vx->values[i] < kStanding) way_braking[i] = std::nan("");
    }
    std::vector<Chart> charts{overWay("Speed", {"speed", speed.unit, 0.0}, way, speed.values)};

    if (ax) {
        std::vector<double> deceleration;
        for (const double value : ax->values) deceleration.push_back(-value);
        Chart chart = overWay("Deceleration", {"deceleration", ax->unit}, way_braking, std::move(deceleration));
        chart.series.front().name = "deceleration";
        addPeak(chart, content.metrics);
        if (const auto mean = metricNamed(content.metrics, "mfdd"))
            chart.series.push_back({.name = fmt::format("mean fully developed, {:.2f} m/s²", *mean),
                                    .x = {0, way.back()},
                                    .y = {*mean, *mean},
                                    .colour = Colour::vermillion,
                                    .dashed = true});
        if (end) chart.note = "Down to 10 % of the initial speed, the end of the mean fully developed deceleration.";
        charts.push_back(std::move(chart));
    }

    Chart slip{.title = "Slip of the wheels", .x = charts.front().x, .y = {"slip", "%"}, .series = {}};
    for (const WheelLook& wheel : kWheelLooks) {
        const std::string name = fmt::format("wheel.{}.slip_ratio", wheel.key);
        if (auto values = valuesFor(log, {name, "slip", "%"}))
            slip.series.push_back({.name = std::string(wheel.label),
                                   .x = way_braking,
                                   .y = std::move(values->values),
                                   .colour = wheel.colour,
                                   .dashed = wheel.dashed});
    }
    if (!slip.series.empty()) charts.push_back(std::move(slip));
    return charts;
}

}  // namespace tread
