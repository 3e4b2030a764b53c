#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text/number_text.h"
#include "compare/compare.h"

namespace tread {
namespace {

std::vector<const ChannelComparison*> worstFirst(const Comparison& comparison) {
    std::vector<const ChannelComparison*> order;
    for (const ChannelComparison& channel : comparison.channels) order.push_back(&channel);
    std::stable_sort(order.begin(), order.end(), [](const ChannelComparison* a, const ChannelComparison* b) {
        if (a->same != b->same) return !a->same;
        return a->severity() > b->severity();
    });
    return order;
}

const ChannelComparison* firstToPart(const Comparison& comparison) {
    const ChannelComparison* first = nullptr;
    for (const ChannelComparison& channel : comparison.channels) {
        if (channel.first && (!first || channel.first->time < first->first->time)) first = &channel;
    }
    return first;
}

std::string commaSeparated(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

// A simulation has dozens of channels that no car logs.
std::string fewOf(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 8;
    if (names.size() <= kMost) return commaSeparated(names);
    return commaSeparated({names.begin(), names.begin() + kMost}) + fmt::format(" and {} more", names.size() - kMost);
}

// The unit behind a number in a sentence; nothing for a pure number.
std::string behind(const std::string& unit) {
    return unit.empty() || unit == "-" ? "" : " " + unit;
}

// A difference in words: in percent of the peak, or in its unit when the channel hardly moves.
std::string shareOfPeak(const ChannelComparison& channel) {
    if (channel.largest <= channel.peak) {
        return fmt::format("{:.2g} % of peak ({})", 100 * channel.largest / channel.peak, channel.channel);
    }
    return fmt::format("{:.2g}{} ({})", channel.largest, behind(channel.unit), channel.channel);
}

std::string answer(const Comparison& comparison) {
    if (!comparison.nothing.empty()) return "Nothing compared: " + comparison.nothing;
    const std::string channels = counted(comparison.channels.size(), "channel");
    if (comparison.same) {
        const auto worst = worstFirst(comparison);
        if (worst.front()->largest == 0) return fmt::format("Same, to the last digit: {}", channels);
        return fmt::format("Same within tolerance: {}, largest difference {}", channels, shareOfPeak(*worst.front()));
    }
    if (const ChannelComparison* first = firstToPart(comparison)) {
        return fmt::format("Different: {} of {}; first at t = {:.6g} s, {} {:.6g} instead of {:.6g}{}",
                           comparison.differing(), channels, first->first->time, first->channel,
                           first->first->candidate, first->first->reference, behind(first->unit));
    }
    if (!comparison.missing.empty()) {
        return fmt::format("Different: {} missing ({})", counted(comparison.missing.size(), "channel"),
                           commaSeparated(comparison.missing));
    }
    return "Different: " + comparison.faults.front();
}

std::string row(const ChannelComparison& channel, int width) {
    const std::string first = channel.first ? fmt::format("{:.6g}", channel.first->time) : "-";
    const std::string r_squared = channel.r_squared ? fmt::format("{:.4f}", *channel.r_squared)
                                  : channel.no_fit  ? "no-fit"
                                                    : "-";
    std::string out = fmt::format("{:<{}}  {:<9}  {:>10.4g}  {:>10.4g}  {:>10.4g}  {:>8}  {:>10.4g}  {:>10}  {:<6}",
                                  channel.channel, width, channel.same ? "same" : "different", channel.largest,
                                  channel.allowed, channel.rms, r_squared, channel.largest_time, first, channel.unit);
    if (channel.reference_not_finite + channel.candidate_not_finite > 0) {
        out += fmt::format("  not finite: {} in the reference, {} in the candidate", channel.reference_not_finite,
                           channel.candidate_not_finite);
    }
    return out.substr(0, out.find_last_not_of(' ') + 1) + '\n';
}

nlohmann::json jsonOf(const ChannelComparison& channel) {
    nlohmann::json out{{"channel", channel.channel},
                       {"unit", channel.unit},
                       {"same", channel.same},
                       {"samples", channel.samples},
                       {"peak", channel.peak},
                       {"allowed", channel.allowed},
                       {"largest_difference", channel.largest},
                       {"largest_difference_time", channel.largest_time},
                       {"rms_difference", channel.rms},
                       {"r_squared", nullptr},
                       {"no_fit", channel.no_fit},
                       {"reference_not_finite", channel.reference_not_finite},
                       {"candidate_not_finite", channel.candidate_not_finite},
                       {"first_difference", nullptr}};
    if (channel.r_squared) out["r_squared"] = *channel.r_squared;
    if (channel.first) {
        out["first_difference"] = {{"time", channel.first->time},
                                   {"reference", channel.first->reference},
                                   {"candidate", channel.first->candidate}};
    }
    return out;
}

}  // namespace

std::vector<std::string> remarks(const Comparison& comparison) {
    std::vector<std::string> out = comparison.faults;
    out.insert(out.end(), comparison.notes.begin(), comparison.notes.end());
    if (!comparison.missing.empty())
        out.push_back("Only in the reference: " + commaSeparated(comparison.missing) + ".");
    if (!comparison.extra.empty()) out.push_back("Only in the candidate: " + fewOf(comparison.extra) + ".");
    return out;
}

std::string text(const Comparison& comparison, std::size_t worst) {
    std::string out = answer(comparison) + "\n";
    for (const std::string& remark : remarks(comparison)) out += remark + "\n";

    const auto order = worstFirst(comparison);
    const std::size_t rows = std::min(worst, order.size());
    if (rows == 0) return out;
    int width = static_cast<int>(std::string_view("channel").size());
    for (std::size_t i = 0; i < rows; ++i) width = std::max(width, static_cast<int>(order[i]->channel.size()));
    out += fmt::format("\n{:<{}}  {:<9}  {:>10}  {:>10}  {:>10}  {:>8}  {:>10}  {:>10}  unit\n", "channel", width,
                       "verdict", "largest", "allowed", "rms", "R2", "at [s]", "first [s]");
    for (std::size_t i = 0; i < rows; ++i) out += row(*order[i], width);
    if (rows < order.size()) out += fmt::format("and {} more\n", order.size() - rows);
    const auto fails = [](const ChannelComparison* channel) { return channel->no_fit; };
    if (std::any_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(rows), fails))
        out += fmt::format("{}.\n", kNoFit);
    return out;
}

// Numbers that are not finite become null.
nlohmann::json json(const Comparison& comparison) {
    nlohmann::json channels = nlohmann::json::array();
    for (const ChannelComparison& channel : comparison.channels) channels.push_back(jsonOf(channel));
    return {{"same", comparison.same},
            {"answer", answer(comparison)},
            {"from", comparison.from},
            {"to", comparison.to},
            {"time_shift", comparison.time_shift},
            {"differing", comparison.differing()},
            {"missing", comparison.missing},
            {"extra", comparison.extra},
            {"faults", comparison.faults},
            {"notes", comparison.notes},
            {"channels", channels}};
}

}  // namespace tread
