#include "report/diagnosis_charts.h"

#include <algorithm>
#include <deque>

#include "log/resample.h"
#include "report/diagnosis_tables.h"
#include "report/text.h"

namespace tread {
namespace {

constexpr std::size_t kChannels = 3;    // those with the largest shares of the gap
constexpr std::size_t kRecordings = 4;  // held-out ones first

// The channels that hold most of the gap, of those that were recorded in some drive.
std::vector<std::string> worstChannels(const Diagnosis& diagnosis) {
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, share] : diagnosis.where.channels) order.push_back({share, name});
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(order.size(), kChannels); ++i) names.push_back(order[i].second);
    return names;
}

// Held-out drives first: they judge; then those with most of the gap.
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
    const char* name;  // nullptr: told by who asks
    const Log Overlay::*log;
    Colour colour;
    bool dashed;
    double width;
};
constexpr Look kLooks[] = {{"measured", &Overlay::measured, Colour::grey, false, 4},
                           {"nominal", &Overlay::nominal, Colour::vermillion, true, 1.5},
                           {"calibrated", &Overlay::calibrated, Colour::amber, false, 1.5},
                           {nullptr, &Overlay::extended, Colour::blue, false, 2}};

// Values of a channel of another log at the times of the measured one; kept as long as the page is made.
class Curves {
public:
    const std::vector<double>* on(const std::vector<double>& time, const Log& log, const std::string& channel) {
        const Channel* found = log.find(channel);
        if (!found || log.samples() < 2) return nullptr;
        const std::vector<double>& own = log.channels.front().values;
        kept_.push_back(own == time ? found->values : resample(own, found->values, time));
        return &kept_.back();
    }

private:
    std::deque<std::vector<double>> kept_;
};

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
    if (diagnosis.overlays.size() > kRecordings)
        page.text("Held-out drives first, then those with most of the gap; the logs beside this page have all.");
    page.timeCharts(charts);
}

}  // namespace tread
