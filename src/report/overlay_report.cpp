#include "report/overlay_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/compare.h"
#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

constexpr std::size_t kMostDrawn = 24;  // channels with charts; the table has all

// How much of its tolerance a channel uses: above 1 it is out.
double used(const ChannelOverlay& channel) {
    if (!std::isfinite(channel.largest)) return std::numeric_limits<double>::infinity();
    if (channel.tolerance > 0) return channel.largest / channel.tolerance;
    return channel.largest > 0 ? std::numeric_limits<double>::infinity() : 0;
}

std::vector<const ChannelOverlay*> worstFirst(const std::vector<ChannelOverlay>& channels) {
    std::vector<const ChannelOverlay*> order;
    for (const ChannelOverlay& channel : channels) order.push_back(&channel);
    std::stable_sort(order.begin(), order.end(), [](const ChannelOverlay* a, const ChannelOverlay* b) {
        if (a->ok != b->ok) return b->ok;
        return used(*a) > used(*b);
    });
    return order;
}

void addTable(HtmlPage& page, const std::vector<const ChannelOverlay*>& channels) {
    std::vector<std::vector<Cell>> rows;
    for (const ChannelOverlay* channel : channels) {
        const DisplayUnit shown = displayUnit(channel->unit, channel->name);
        const auto number = [&](double value) { return Cell{formatNumber(value * shown.scale), true}; };
        const std::string r_squared = channel->r_squared ? formatNumber(*channel->r_squared, 4)
                                      : channel->no_fit  ? "no fit"
                                                         : "";
        const std::string out = channel->first_time_out ? formatNumber(*channel->first_time_out, 6) : "";
        rows.push_back({{channel->ok ? "✓ within" : "✗ out", false, !channel->ok},
                        {channel->name},
                        number(channel->largest),
                        number(channel->rms),
                        {r_squared, true},
                        number(channel->tolerance),
                        {prettyUnit(shown.unit)},
                        {formatNumber(100 * used(*channel), 3), true, !channel->ok},
                        {out, true}});
    }
    page.table({"Result", "Channel", "Largest", "RMS", "R²", "Tolerance", "Unit", "Used, %", "First exceeded, s"},
               rows);
    page.text(
        "R²: share of the reference's variance that the candidate explains, 1 - sum of squared differences / sum of "
        "squares about the reference's mean.");
    if (std::any_of(channels.begin(), channels.end(), [](const auto* channel) { return channel->no_fit; }))
        page.text(fmt::format("{}.", kNoFit));
}

// "compact hatchback (out/a/log.csv)".
std::string nameAndFile(const std::string& name, const std::string& file) {
    return file.empty() || file == name ? name : fmt::format("{} ({})", name, file);
}

void addReplay(HtmlPage& page, const OverlayReport& content) {
    std::string replay = replayData(content.cars, content.scene);
    if (replay.empty()) return;
    page.section("Replay");
    page.replay(std::move(replay));
}

std::vector<double> differences(const ChannelOverlay& channel) {
    const std::size_t samples = std::min({channel.time.size(), channel.reference.size(), channel.candidate.size()});
    std::vector<double> out(samples);
    for (std::size_t i = 0; i < samples; ++i) out[i] = channel.candidate[i] - channel.reference[i];
    return out;
}

// Overlay and, beneath it, the difference with its tolerance.
std::vector<TimeChart> chartsOf(const OverlayReport& content, const ChannelOverlay& channel,
                                const std::vector<double>& difference) {
    const DisplayUnit shown = displayUnit(channel.unit, channel.name);
    const Colour colour = channel.ok ? overlayColour(1) : Colour::vermillion;
    TimeChart overlay{.title = channel.name, .unit = shown.unit, .time = channel.time, .curves = {}};
    overlay.curves = {{content.reference_name, channel.reference, shown.scale, overlayColour(0), false, 4},
                      {content.candidate_name, channel.candidate, shown.scale, colour}};
    for (std::size_t i = 0; i < channel.others.size(); ++i) {
        if (channel.others[i].empty()) continue;
        overlay.curves.push_back({content.other_names[i], channel.others[i], shown.scale, overlayColour(i + 2)});
    }

    TimeChart gap{.title = "Difference", .unit = shown.unit, .time = channel.time, .curves = {}};
    std::string name = fmt::format("difference, allowed ±{} (band)", formatNumber(channel.tolerance * shown.scale));
    gap.band = channel.tolerance * shown.scale;
    if (channel.first_time_out) {
        name += fmt::format(", first exceeded at {} s (dashed)", formatNumber(*channel.first_time_out, 6));
        gap.marks = overlay.marks = {*channel.first_time_out};
    }
    gap.curves = {{name, difference, shown.scale, colour}};
    return {overlay, gap};
}

// `gaps` holds the differences for as long as the page is built.
void addCurves(HtmlPage& page, const OverlayReport& content, const std::vector<const ChannelOverlay*>& channels,
               std::vector<std::vector<double>>& gaps) {
    if (channels.empty()) return;
    page.section("Curves, worst first");
    if (channels.size() > kMostDrawn) {
        page.text(
            fmt::format("The {} channels, out of {}, that use the most of their tolerance; the table below shows all.",
                        kMostDrawn, channels.size()));
    }
    const std::size_t drawn = std::min(channels.size(), kMostDrawn);
    for (std::size_t i = 0; i < drawn; ++i) gaps.push_back(differences(*channels[i]));
    std::vector<std::vector<TimeChart>> stacks;
    for (std::size_t i = 0; i < drawn; ++i) stacks.push_back(chartsOf(content, *channels[i], gaps[i]));
    page.stackedTimeCharts(stacks);
}

}  // namespace

std::string overlayReport(const OverlayReport& content) {
    const auto channels = worstFirst(content.channels);
    HtmlPage page(content.title);
    page.answer(content.answer, content.ok ? "within tolerance" : "out of tolerance", content.ok);
    page.warnings(content.warnings);
    page.keyValues({{"Reference", nameAndFile(content.reference_name, content.reference_file)},
                    {"Candidate", nameAndFile(content.candidate_name, content.candidate_file)},
                    {"Also drawn", fmt::format("{}", fmt::join(content.other_names, ", "))},
                    {"Made by", "tread " + content.version}});

    std::vector<std::vector<double>> gaps;  // complete before the charts refer to it
    addCurves(page, content, channels, gaps);
    page.section("Channels");
    addTable(page, channels);
    addReplay(page, content);
    return page.finish();
}

}  // namespace tread
