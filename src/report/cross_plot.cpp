#include "report/cross_plot.h"

#include "report/text.h"

namespace tread {

const Channel* completeChannel(const Log& log, std::string_view name) {
    const Channel* channel = log.find(name);
    return channel && log.samples() > 0 && channel->values.size() == log.samples() ? channel : nullptr;
}

std::optional<PlotValues> valuesFor(const Log& log, const PlotAxis& axis) {
    const Channel* channel = completeChannel(log, axis.channel);
    if (!channel) return std::nullopt;
    const DisplayUnit shown = displayUnitAs(channel->unit, axis.unit);
    PlotValues out{channel->values, shown.unit};
    for (double& value : out.values) value *= shown.scale;
    return out;
}

std::optional<Chart> crossPlot(const Log& log, std::string title, const PlotAxis& x, const PlotAxis& y) {
    auto xs = valuesFor(log, x), ys = valuesFor(log, y);
    if (!xs || !ys) return std::nullopt;
    Chart chart{.title = std::move(title),
                .x = {std::string(x.label), xs->unit},
                .y = {std::string(y.label), ys->unit},
                .series = {}};
    chart.series.push_back(
        {.name = "", .x = std::move(xs->values), .y = std::move(ys->values), .colour = Colour::blue});
    return chart;
}

}  // namespace tread
