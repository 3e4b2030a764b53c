#include "report/frequency_figures.h"

#include "metrics/frequency_response.h"
#include "metrics/metrics.h"
#include "report/text.h"

namespace tread {
namespace {

using Value = double (*)(const FrequencyCurve&, double frequency);

Series curve(std::string name, const FrequencyCurve& points, Value value, double scale, Colour colour) {
    Series series{.name = std::move(name), .x = {}, .y = {}, .colour = colour};
    for (const FrequencyPoint& point : points) {
        series.x.push_back(point.frequency);
        series.y.push_back(scale * value(points, point.frequency));
    }
    return series;
}

Chart figure(std::string title, ChartAxis y, std::vector<Series> series) {
    Chart chart{.title = std::move(title), .x = {"frequency", "Hz"}, .y = std::move(y), .series = std::move(series)};
    chart.x.lowest = 0;
    return chart;
}

}  // namespace

std::vector<Chart> frequencyFigures(const Log& log) {
    SteeringResponse found;
    try {
        found = steeringResponse(log);
    } catch (const MetricError&) {
        return {};
    }
    const double degrees = displayUnit("rad").scale;
    const auto both = [&](Value value, double scale) {
        return std::vector<Series>{curve("yaw rate", found.yaw_rate, value, scale, Colour::blue),
                                   curve("lateral acceleration", found.ay, value, scale, Colour::vermillion)};
    };
    std::vector<Chart> charts{figure("Gain of the yaw rate", {"yaw rate / steering-wheel angle", "1/s", 0.0},
                                     {curve("", found.yaw_rate, gainAt, 1, Colour::blue)}),
                              figure("Gain of the lateral acceleration", {"ay / steering-wheel angle", "m/s2/deg", 0.0},
                                     {curve("", found.ay, gainAt, 1 / degrees, Colour::vermillion)}),
                              figure("Phase", {"phase against the steering wheel", "deg"}, both(phaseLagAt, -degrees))};
    if (found.segments > 1) {
        charts.push_back(figure("Coherence", {"coherence", "-", 0.0, 1.02}, both(coherenceAt, 1)));
    } else {
        charts.back().note = "From a single record, for which coherence is undefined.";
    }
    return charts;
}

}  // namespace tread
