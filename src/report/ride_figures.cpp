#include "report/ride_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "metrics/ride.h"
#include "metrics/spectrum.h"
#include "metrics/vibration_weighting.h"
#include "report/cross_plot.h"
#include "report/text.h"

namespace tread {
namespace {

constexpr PlotAxis kTime{"time", "time", "s"};
constexpr PlotAxis kVertical{"chassis.az", "vertical acceleration", "m/s2"};
constexpr double kHighest = 30;       // Hz: body and wheel hop lie below, and what people feel most
constexpr double kSegments = 4;       // of the record's length make a segment, a compromise of scatter and resolution
constexpr double kShortest = 1;       // s of a segment: the body's bounce, at about 1 Hz, must fit
constexpr double kPerSegment = 0.25;  // distance of the frequencies over the resolution, 1 / segment

// A channel over the time that is evaluated; nothing when that is too short.
std::optional<TimeSeries> evaluated(const Log& log, const std::string& name) {
    const Channel* channel = completeChannel(log, name);
    if (!channel) return std::nullopt;
    const TimeSeries whole{log.channels.front().values, channel->values};
    if (whole.end() - whole.begin() - kRideApproach < kSegments * kShortest) return std::nullopt;
    return part(whole, whole.begin() + kRideApproach, whole.end());
}

struct Density {
    std::vector<double> frequency;  // Hz
    std::vector<double> power;      // squared unit per Hz
};

Density densityOf(const TimeSeries& series) {
    const double segment = (series.end() - series.begin()) / kSegments;
    Density out;
    for (double f = 1 / segment; f <= kHighest; f += kPerSegment / segment) out.frequency.push_back(f);
    out.power = powerSpectralDensity(series, out.frequency, segment);
    return out;
}

Chart spectrumChart(std::string title, ChartAxis y) {
    Chart chart{.title = std::move(title), .x = {"frequency", "Hz", 0.0, kHighest}, .y = std::move(y), .series = {}};
    chart.y.lowest = 0;
    return chart;
}

std::optional<Chart> accelerationSpectrum(const Log& log) {
    const auto az = evaluated(log, std::string(kVertical.channel));
    if (!az) return std::nullopt;
    const Density density = densityOf(*az);
    Chart chart = spectrumChart("Spectrum of the vertical acceleration", {"power spectral density", "(m/s²)²/Hz"});
    Series plain{
        .name = "unweighted", .x = density.frequency, .y = density.power, .colour = Colour::grey, .dashed = true};
    Series weighted{.name = "weighted by Wk", .x = density.frequency, .y = density.power, .colour = Colour::blue};
    for (std::size_t i = 0; i < weighted.y.size(); ++i) {
        const double weight = vibrationWeight(VibrationWeighting::Wk, weighted.x[i]);
        weighted.y[i] *= weight * weight;
    }
    chart.series = {std::move(plain), std::move(weighted)};
    chart.note = "The area below the weighted curve is the square of the weighted vertical acceleration (ISO 2631-1).";
    return chart;
}

std::optional<Chart> loadSpectra(const Log& log) {
    Chart chart = spectrumChart("Spectra of the wheel loads", {"power spectral density", "kN2/Hz"});
    constexpr double kKilo = 1000;
    for (const WheelLook& wheel : kWheelLooks) {
        const auto load = evaluated(log, fmt::format("wheel.{}.load", wheel.key));
        if (!load) continue;
        Density density = densityOf(*load);
        for (double& power : density.power) power /= kKilo * kKilo;
        chart.series.push_back({.name = std::string(wheel.label),
                                .x = std::move(density.frequency),
                                .y = std::move(density.power),
                                .colour = wheel.colour,
                                .dashed = wheel.dashed});
    }
    if (chart.series.empty()) return std::nullopt;
    return chart;
}

std::optional<Chart> loadsOverTime(const Log& log) {
    Chart chart{.title = "Wheel loads", .x = {"time", "s"}, .y = {"wheel load", "N"}, .series = {}};
    for (const WheelLook& wheel : kWheelLooks) {
        const Channel* load = completeChannel(log, fmt::format("wheel.{}.load", wheel.key));
        if (!load) continue;
        chart.series.push_back({.name = std::string(wheel.label),
                                .x = log.channels.front().values,
                                .y = load->values,
                                .colour = wheel.colour,
                                .dashed = wheel.dashed});
    }
    if (chart.series.empty()) return std::nullopt;
    return chart;
}

std::vector<Chart> those(std::initializer_list<std::optional<Chart>> charts) {
    std::vector<Chart> out;
    for (const auto& chart : charts) {
        if (chart) out.push_back(*chart);
    }
    return out;
}

}  // namespace

std::vector<Chart> rideFigures(const Log& log) {
    return those(
        {crossPlot(log, "Vertical acceleration", kTime, kVertical), accelerationSpectrum(log), loadSpectra(log)});
}

std::vector<Chart> bumpFigures(const Log& log) {
    return those({crossPlot(log, "Vertical acceleration", kTime, kVertical), loadsOverTime(log)});
}

}  // namespace tread
