#include "report/diagnosis_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "diagnose/answer/diagnosis.h"
#include "log/resample.h"
#include "report/diagnosis_tables.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Overlay;

constexpr double kMatters = 0.05;       // share of the gap from which a channel is drawn
constexpr std::size_t kChannels = 4;    // channels drawn of a drive: those with the largest parts of its gap
constexpr std::size_t kRecordings = 3;  // drives that are not folded away: those with the largest gaps
constexpr double kDeviations = 2;       // half width of the tolerance band, in standard deviations

double sumOf(const std::map<std::string, double>& gap) {
    double sum = 0;
    for (const auto& [channel, squares] : gap) sum += squares;
    return sum;
}

// Channels that have a noteworthy share of the gap of all drives; all channels where there is no gap.
std::vector<std::string> channelsThatMatter(const std::vector<Overlay>& overlays) {
    std::map<std::string, double> gap;
    for (const Overlay& overlay : overlays)
        for (const auto& [channel, squares] : overlay.gap) gap[channel] += squares;
    const double all = sumOf(gap);
    std::vector<std::string> names;
    for (const auto& [channel, squares] : gap)
        if (squares >= kMatters * all) names.push_back(channel);
    return names;
}

std::vector<std::string> channelsOf(const Overlay& overlay, const std::vector<std::string>& matter) {
    std::vector<std::string> names;
    for (const std::string& channel : matter)
        if (overlay.measured.find(channel)) names.push_back(channel);
    const auto gap = [&](const std::string& channel) {
        const auto found = overlay.gap.find(channel);
        return found == overlay.gap.end() ? 0.0 : found->second;
    };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return gap(a) > gap(b); });
    names.resize(std::min(names.size(), kChannels));
    return names;
}

// Drives with the largest gaps first.
std::vector<const Overlay*> inOrder(const std::vector<Overlay>& overlays) {
    std::vector<const Overlay*> order;
    for (const Overlay& overlay : overlays) order.push_back(&overlay);
    std::stable_sort(order.begin(), order.end(),
                     [](const Overlay* a, const Overlay* b) { return sumOf(a->gap) > sumOf(b->gap); });
    return order;
}

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

// A stage of the model as it is drawn.
struct Look {
    std::string name;
    const Log Overlay::*log;
    Colour colour;
    bool dashed;
    double width;
};

std::vector<Look> looksOf(const StageNames& names) {
    std::vector<Look> looks{{"nominal", &Overlay::nominal, Colour::vermillion, true, 1.5}};
    if (!names.calibrated.empty()) looks.push_back({names.calibrated, &Overlay::calibrated, Colour::amber, false, 1.5});
    looks.push_back({names.extended, &Overlay::extended, Colour::blue, false, 2});
    return looks;
}

// The time after which a drive is not compared.
std::vector<double> cutOf(const Diagnosis& diagnosis, const Overlay& overlay) {
    for (const diagnose::answer::Cut& cut : diagnosis.cuts)
        if (cut.recording == overlay.recording) return {cut.until};
    return {};
}

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
                               .colour = Colour::vermillion};
}

// What the charts of one drive share.
struct Drawn {
    const Overlay& overlay;
    const std::vector<Look>& looks;
    std::vector<double> cut;
};

TimeChart overlayOf(const Drawn& drive, const std::string& channel, Curves& curves) {
    const Overlay& overlay = drive.overlay;
    const Channel& measured = *overlay.measured.find(channel);
    const DisplayUnit shown = displayUnit(measured.unit, channel);
    TimeChart chart{.title = overlay.recording + (overlay.hold_out ? " (held out)" : "") + ": " + shownName(channel),
                    .unit = shown.unit,
                    .time = overlay.measured.channels.front().values,
                    .curves = {{"measured", measured.values, shown.scale, Colour::grey, false, 2.5}}};
    for (const Look& look : drive.looks) {
        if (const auto* values = curves.on(overlay.measured.channels.front().values, overlay.*look.log, channel))
            chart.curves.push_back({look.name, *values, shown.scale, look.colour, look.dashed, look.width});
    }
    chart.envelope = allowedOf(overlay, channel, shown.scale, curves);
    chart.marks = drive.cut;
    return chart;
}

// Measured minus model, as far as they are compared, and the band that noise and usual disturbances cause.
TimeChart residualOf(const Drawn& drive, const std::string& channel, Curves& curves) {
    const Overlay& overlay = drive.overlay;
    const Channel *rows = overlay.rows.find(channel), *floor = overlay.floor.find(channel);
    TimeChart chart{.title = "Measured minus model", .unit = {}, .time = {}, .curves = {}};
    if (!rows || !floor) return chart;
    const DisplayUnit shown = displayUnit(rows->unit, channel);
    chart.unit = shown.unit;
    chart.time = overlay.rows.channels.front().values;
    std::vector<double> high = floor->values;
    for (double& value : high)
        if (!std::isfinite(value)) value = kRequired;
    for (const Look& look : drive.looks) {
        const Channel* model = (overlay.*look.log).find(channel);
        if (!model || model->values.size() != rows->values.size()) continue;
        std::vector<double> left(rows->values);
        for (std::size_t i = 0; i < left.size(); ++i)
            left[i] = std::isfinite(high[i]) ? left[i] - model->values[i] : kRequired;
        chart.curves.push_back(
            {look.name, curves.kept(std::move(left)), shown.scale, look.colour, look.dashed, look.width});
    }
    std::vector<double> low(high);
    for (double& value : low) value = -value;
    chart.envelope = TimeChart::Envelope{.name = "noise and usual disturbances (1 sd)",
                                         .low = curves.kept(std::move(low)),
                                         .high = curves.kept(std::move(high)),
                                         .scale = shown.scale,
                                         .colour = Colour::green};
    chart.marks = drive.cut;
    return chart;
}

void addWords(HtmlPage& page, const Diagnosis& diagnosis) {
    const bool bands = std::any_of(diagnosis.overlays.begin(), diagnosis.overlays.end(),
                                   [](const Overlay& overlay) { return !overlay.allowed.channels.empty(); });
    page.text("Drives with the largest gaps first. The logs next to this page contain all channels.");
    if (bands)
        page.text(
            "Shaded: range of the nominal car for its numbers within their tolerances. The tolerances hardly explain a "
            "measurement that is outside this range by more than its noise. There is no range for held-out drives.");
    if (diagnosis.compared)
        page.text(
            "Measured values are shown minus the gap between the nominal car and the reference, the same drive before "
            "the change.");
    if (!diagnosis.cuts.empty()) page.text("Dashed vertical line: not compared from there on.");
}

}  // namespace

void addOverlays(HtmlPage& page, const Diagnosis& diagnosis, const StageNames& names) {
    addWords(page, diagnosis);
    Curves curves;
    const std::vector<Look> looks = looksOf(names);
    const std::vector<std::string> matter = channelsThatMatter(diagnosis.overlays);
    std::vector<std::vector<TimeChart>> open, folded;
    const std::vector<const Overlay*> order = inOrder(diagnosis.overlays);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Drawn drive{*order[i], looks, cutOf(diagnosis, *order[i])};
        for (const std::string& channel : channelsOf(*order[i], matter))
            (i < kRecordings ? open : folded)
                .push_back({overlayOf(drive, channel, curves), residualOf(drive, channel, curves)});
    }
    page.stackedTimeCharts(open);
    if (folded.empty()) return;
    const std::size_t others = order.size() - kRecordings;
    page.fold(fmt::format("{} other drive{}", others, others == 1 ? "" : "s"));
    page.stackedTimeCharts(folded);
    page.unfold();
}

}  // namespace tread
