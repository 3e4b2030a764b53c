#include "report/diagnosis_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "diagnose/answer/diagnosis.h"
#include "log/resample.h"
#include "report/diagnosis_tables.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Overlay;

constexpr std::size_t kChannels = 3;    // channels shown: those with the largest shares of the gap
constexpr std::size_t kRecordings = 4;  // recordings shown, held-out ones first
constexpr double kDeviations = 2;       // half width of the tolerance band, in standard deviations

// Channels with the largest shares of the gap among those recorded in some drive.
std::vector<std::string> worstChannels(const Diagnosis& diagnosis) {
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, share] : diagnosis.where.channels) order.push_back({share, name});
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(order.size(), kChannels); ++i) names.push_back(order[i].second);
    return names;
}

// Held-out drives first, because they test the model; then those with the largest shares of the gap.
std::vector<const Overlay*> shownOverlays(const Diagnosis& diagnosis) {
    std::vector<const Overlay*> order;
    for (const Overlay& overlay : diagnosis.overlays) order.push_back(&overlay);
    const auto share = [&](const Overlay* overlay) {
        const auto found = diagnosis.where.recordings.find(overlay->recording);
        return found == diagnosis.where.recordings.end() ? 0.0 : found->second;
    };
    std::stable_sort(order.begin(), order.end(), [&](const Overlay* a, const Overlay* b) {
        return a->hold_out != b->hold_out ? a->hold_out : share(a) > share(b);
    });
    order.resize(std::min(order.size(), kRecordings));
    return order;
}

struct Look {
    const char* name;  // nullptr: given by the caller
    const Log Overlay::*log;
    Colour colour;
    bool dashed;
    double width;
};
constexpr Look kLooks[] = {{"measured", &Overlay::measured, Colour::grey, false, 2.5},
                           {"nominal", &Overlay::nominal, Colour::vermillion, true, 1.5},
                           {"calibrated", &Overlay::calibrated, Colour::amber, false, 1.5},
                           {nullptr, &Overlay::extended, Colour::blue, false, 2}};

// Values of a channel of another log at the times of the measured one. They stay valid while the page is built.
class Curves {
public:
    const std::vector<double>* on(const std::vector<double>& time, const Log& log, const std::string& channel) {
        const Channel* found = log.find(channel);
        if (!found || log.samples() < 2) return nullptr;
        const std::vector<double>& own = log.channels.front().values;
        return &kept(own == time ? found->values : resample(own, found->values, time));
    }

    const std::vector<double>& kept(std::vector<double> values) {
        kept_.push_back(std::move(values));
        return kept_.back();
    }

private:
    std::deque<std::vector<double>> kept_;
};

// Band of the nominal car for numbers elsewhere within their tolerances.
std::optional<TimeChart::Envelope> allowedOf(const Overlay& overlay, const std::string& channel, double scale,
                                             Curves& curves) {
    const std::vector<double>& time = overlay.measured.channels.front().values;
    const auto *middle = curves.on(time, overlay.nominal, channel), *sd = curves.on(time, overlay.allowed, channel);
    if (!middle || !sd) return std::nullopt;
    std::vector<double> low(*middle), high(*middle);
    for (std::size_t i = 0; i < time.size(); ++i) {
        low[i] -= kDeviations * (*sd)[i];
        high[i] += kDeviations * (*sd)[i];
    }
    return TimeChart::Envelope{.name = fmt::format("what the tolerances allow ({:.0f} sd)", kDeviations),
                               .low = curves.kept(std::move(low)),
                               .high = curves.kept(std::move(high)),
                               .scale = scale,
                               .colour = kLooks[1].colour};
}

TimeChart chartOf(const Overlay& overlay, const std::string& channel, const char* extended, Curves& curves) {
    const Log& measured = overlay.measured;
    const DisplayUnit shown = displayUnit(measured.find(channel)->unit, channel);
    TimeChart chart{.title = overlay.recording + (overlay.hold_out ? " (held out)" : "") + ": " + shownName(channel),
                    .unit = shown.unit,
                    .time = measured.channels.front().values,
                    .curves = {}};
    for (const Look& look : kLooks) {
        if (const auto* values = curves.on(measured.channels.front().values, overlay.*look.log, channel))
            chart.curves.push_back(
                {look.name ? look.name : extended, *values, shown.scale, look.colour, look.dashed, look.width});
    }
    chart.envelope = allowedOf(overlay, channel, shown.scale, curves);
    return chart;
}

}  // namespace

void addOverlays(HtmlPage& page, const Diagnosis& diagnosis, const char* extended) {
    Curves curves;
    std::vector<TimeChart> charts;
    for (const Overlay* overlay : shownOverlays(diagnosis)) {
        for (const std::string& channel : worstChannels(diagnosis)) {
            if (overlay->measured.find(channel)) charts.push_back(chartOf(*overlay, channel, extended, curves));
        }
    }
    const bool bands = std::any_of(diagnosis.overlays.begin(), diagnosis.overlays.end(),
                                   [](const Overlay& overlay) { return !overlay.allowed.channels.empty(); });
    if (bands)
        page.text(
            "Shaded: range of the nominal car for its numbers within their tolerances. The tolerances hardly explain a "
            "measurement that is outside this range by more than its noise. There is no range for held-out drives.");
    if (diagnosis.compared)
        page.text(
            "Measured: minus the gap between the nominal car and the reference, the same drive before the change.");
    if (diagnosis.overlays.size() > kRecordings)
        page.text(
            "Held-out drives first, then those with the largest shares of the gap. The logs next to this page contain "
            "all drives.");
    page.timeCharts(charts);
}

}  // namespace tread
