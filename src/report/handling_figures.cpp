#include "report/handling_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/math/median.h"
#include "metrics/metrics.h"
#include "metrics/sine_with_dwell.h"
#include "report/cross_plot.h"
#include "report/shown_metric.h"
#include "report/text.h"
#include "tread/vehicle_output.h"

namespace tread {
namespace {

// A line of that slope through the middle of the points between two x; nothing without points there.
std::optional<Series> lineThrough(const Series& curve, double slope, double from, double to) {
    std::vector<double> offsets;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (curve.x[i] >= from && curve.x[i] <= to) offsets.push_back(curve.y[i] - slope * curve.x[i]);
    }
    if (offsets.empty()) return std::nullopt;
    const double offset = median(std::move(offsets)), end = *std::max_element(curve.x.begin(), curve.x.end());
    return Series{
        .name = "", .x = {0, end}, .y = {offset, offset + slope * end}, .colour = Colour::vermillion, .dashed = true};
}

// Where the steering wheel is held, the path says how the car understeers.
std::optional<Chart> curvatureFigure(const Log& log) {
    const Channel *ay = completeChannel(log, kLateral.channel), *rate = completeChannel(log, kYawRate.channel);
    const Channel* speed = completeChannel(log, kForwardSpeed.channel);
    if (!ay || !rate || !speed) return std::nullopt;
    Series curve{.name = "", .x = ay->values, .y = rate->values, .colour = Colour::blue};
    for (std::size_t i = 0; i < curve.y.size(); ++i)
        curve.y[i] = speed->values[i] > kStanding ? curve.y[i] / speed->values[i] : std::nan("");
    return Chart{.title = "Curvature of the path",
                 .x = {std::string(kLateral.label), ay->unit},
                 .y = {"yaw rate / speed", "1/m"},
                 .series = {std::move(curve)}};
}

}  // namespace

std::optional<Chart> understeerFigure(const RunReport& content) {
    const auto understeer = metricNamed(content.metrics, "understeer_gradient");
    const std::string note =
        understeer ? fmt::format("Understeer gradient {:.3g} deg/g at the road wheels.", *understeer) : "";
    const auto slope = metricNamed(content.metrics, "steering_wheel_gradient");
    if (!slope) {
        auto chart = curvatureFigure(content.log);
        if (chart) chart->note = note;
        return chart;
    }
    auto chart = crossPlot(content.log, "Understeer", kLateral, kSteeringWheel);
    if (!chart) return chart;
    // A right turn is drawn as a left one.
    Series& curve = chart->series.front();
    curve.name = "steering wheel";
    const auto [low, high] = std::minmax_element(curve.x.begin(), curve.x.end());
    if (-*low > *high) {
        for (auto* values : {&curve.x, &curve.y}) {
            for (double& value : *values) value = -value;
        }
    }
    const double largest = *std::max_element(curve.x.begin(), curve.x.end());
    const double upper = std::min(0.375 * kStandardGravity, 0.6 * largest);
    if (auto line = lineThrough(curve, *slope / kStandardGravity, 0.1 * kStandardGravity, upper)) {
        line->name = fmt::format("{:.3g} deg/g at the steering wheel", *slope);
        chart->series.push_back(*std::move(line));
    }
    chart->note = note;
    return chart;
}

std::optional<Chart> stepFigure(const RunReport& content) {
    const auto amplitude = metricNamed(content.metrics, "steering_amplitude");  // deg
    const Channel* hand = completeChannel(content.log, kSteeringWheel.channel);
    if (!amplitude || *amplitude == 0 || !hand) return std::nullopt;
    const double step = *amplitude / displayUnit("rad").scale;
    const std::vector<double>& time = content.log.channels.front().values;

    // Time zero of the standard: half the steering input.
    std::size_t half = 0;
    while (half < time.size() && (hand->values[half] - hand->values.front()) / step < 0.5) ++half;
    if (half == time.size()) return std::nullopt;
    std::vector<double> since = time;
    for (double& t : since) t -= time[half];

    constexpr double kBefore = 0.5, kAfter = 3;  // s
    Chart chart{.title = "Response to the step",
                .x = {"time from half the steering input", "s"},
                .y = {"share of the steady value", "-"},
                .series = {}};
    chart.x.lowest = std::max(-kBefore, since.front());
    chart.x.highest = std::min(kAfter, since.back());
    const auto add = [&](const PlotAxis& axis, std::string_view steady_name, std::string_view time_name,
                         Colour colour) {
        const Channel* channel = completeChannel(content.log, axis.channel);
        const auto gain = steady_name.empty() ? std::optional(1.0) : metricNamed(content.metrics, steady_name);
        if (!channel || !gain || *gain == 0) return;
        Series curve{.name = std::string(axis.label), .x = since, .y = channel->values, .colour = colour};
        for (double& value : curve.y) value = (value - channel->values.front()) / (*gain * step);
        curve.dashed = steady_name.empty();
        chart.series.push_back(std::move(curve));
        const auto answered = metricNamed(content.metrics, time_name);
        if (!answered) return;
        Series mark{.name = fmt::format("90 % after {:.3g} s", *answered),
                    .x = {*answered, *answered},
                    .y = {0, 0.9},
                    .colour = colour,
                    .dashed = true};
        mark.width = 1.2;
        chart.series.push_back(std::move(mark));
    };
    add(kSteeringWheel, "", "", Colour::grey);
    add(kYawRate, "yaw_rate_gain", "yaw_rate_response_time", Colour::blue);
    add(kLateral, "ay_gain", "ay_response_time", Colour::vermillion);
    return chart;
}

std::vector<Chart> dwellFigures(const Log& log) {
    const auto hand = valuesFor(log, kSteeringWheel), yaw_rate = valuesFor(log, kYawRate);
    if (!hand || !yaw_rate) return {};
    DwellSteering steering{};
    try {
        steering = dwellSteering(log);
    } catch (const MetricError&) {
        return {};
    }
    constexpr double kBefore = 0.5;  // s
    const std::vector<double>& time = log.channels.front().values;
    const double end = steering.end + kYawRateChecks.back().after + kBefore;
    const auto over = [&](const char* title, const PlotAxis& axis, const PlotValues& values) {
        Chart chart{.title = title, .x = {"time", "s"}, .y = {std::string(axis.label), values.unit}, .series = {}};
        chart.x.lowest = steering.begin - kBefore;
        chart.x.highest = std::min(end, time.back());
        chart.series.push_back(
            {.name = std::string(axis.label), .x = time, .y = values.values, .colour = Colour::blue});
        return chart;
    };
    const auto upright = [](const Chart& chart, double at, std::string name) {
        const auto& values = chart.series.front().y;
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        Series line{.name = std::move(name), .x = {at, at}, .y = {*low, *high}, .colour = Colour::grey, .dashed = true};
        line.width = 1.2;
        return line;
    };
    Chart wheel = over("Steering", kSteeringWheel, *hand),
          turning = over("Yaw rate after the steering", kYawRate, *yaw_rate);
    for (Chart* chart : {&wheel, &turning})
        chart->series.push_back(upright(*chart, steering.end, "completion of steer"));
    const double peak = displayUnit("rad/s").scale * steering.peak_yaw_rate;
    Colour colour = Colour::vermillion;
    for (const YawRateCheck& check : kYawRateChecks) {
        const double at = steering.end + check.after, limit = check.share * peak;
        turning.series.push_back(
            {.name = fmt::format("{:.2f} s later: at most {:.0f} % of the peak", check.after, 100 * check.share),
             .x = {at, at},
             .y = {0, limit},
             .colour = colour,
             .width = 4,
             .markers = true});
        colour = Colour::amber;
    }
    turning.note = "Passed when the curve crosses both bars, or lies on the far side of zero.";
    return {wheel, turning};
}

}  // namespace tread
