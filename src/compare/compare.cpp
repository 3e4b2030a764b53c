#include "compare/compare.h"

#include "base/text/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "compare/time_shift.h"
#include "log/direction.h"
#include "log/resample.h"

namespace tread {
namespace {

// A heading that is logged between -pi and pi jumps by a whole turn; no real angle moves by half a turn in one sample.
bool wraps(const Channel& channel) {
    if (channel.unit != "rad") return false;
    for (std::size_t i = 1; i < channel.values.size(); ++i) {
        if (std::abs(channel.values[i] - channel.values[i - 1]) > std::numbers::pi) return true;
    }
    return false;
}

struct CommonTime {
    std::span<const double> reference;  // samples of the reference within the common time
    std::size_t first;                  // their index in the reference
    std::vector<double> candidate;      // the same instants on the candidate's clock
};

CommonTime commonTime(const Log& reference, const Log& candidate, double shift) {
    const std::span<const double> time = reference.channels.front().values;
    const std::vector<double>& other = candidate.channels.front().values;
    CommonTime common{{}, 0, {}};
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double there = time[i] + shift;
        if (there < other.front() || there > other.back()) continue;
        if (common.candidate.empty()) common.first = i;
        common.candidate.push_back(there);
    }
    common.reference = time.subspan(common.first, common.candidate.size());
    return common;
}

double peakOf(std::span<const double> values) {
    double peak = 0;
    for (double value : values) {
        if (std::isfinite(value)) peak = std::max(peak, std::abs(value));
    }
    return peak;
}

ChannelComparison compareChannel(const Channel& reference, const Channel& candidate,
                                 const std::vector<double>& candidate_time, const CommonTime& common,
                                 const AllowedDifference& allowed) {
    ChannelComparison result;
    result.channel = reference.name;
    result.unit = reference.unit;
    result.samples = common.reference.size();
    result.peak = peakOf(reference.values);
    result.allowed = allowed.absolute + allowed.relative * result.peak;

    const bool wrapped = wraps(reference) || wraps(candidate);
    const std::vector<double> others =
        resample(candidate_time, wrapped ? continuous(candidate.values) : candidate.values, common.candidate);
    double squares = 0, sum = 0, sum_squared = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
        const double here = reference.values[common.first + i], there = others[i];
        double difference = there - here;
        if (wrapped) difference = std::remainder(difference, 2 * std::numbers::pi);
        if (!std::isfinite(here) || !std::isfinite(there)) {
            result.reference_not_finite += !std::isfinite(here);
            result.candidate_not_finite += !std::isfinite(there);
            const bool alike = here == there || (std::isnan(here) && std::isnan(there));
            difference = alike ? 0 : std::numeric_limits<double>::infinity();
        } else {
            squares += difference * difference;
            const double moved = here - reference.values[common.first];  // so that a large mean takes no digits
            sum += moved;
            sum_squared += moved * moved;
        }
        if (std::abs(difference) > result.largest) {
            result.largest = std::abs(difference);
            result.largest_time = common.reference[i];
        }
        if (!result.first && std::abs(difference) > result.allowed) result.first = {common.reference[i], here, there};
    }
    const auto samples = static_cast<double>(others.size());
    if (!others.empty()) result.rms = std::sqrt(squares / samples);
    const double variance = sum_squared - sum * sum / samples;
    if (variance > 1e-12 * sum_squared && std::isfinite(squares) && !wrapped) {
        result.no_fit = squares > variance;
        if (!result.no_fit) result.r_squared = 1 - squares / variance;
    }
    result.same = !result.first;
    return result;
}

void findTimeShift(Comparison& result, const Log& reference, const Log& candidate, const Tolerances& tolerances) {
    if (tolerances.time_shift_max <= 0) return;
    const auto shift =
        estimateTimeShift(reference, candidate, tolerances.time_shift_channel, tolerances.time_shift_max);
    if (shift) {
        result.time_shift = *shift;
        result.notes.push_back(
            fmt::format("The candidate is {:.3g} s {} ({}); the shift was removed before the comparison.",
                        std::abs(*shift), *shift < 0 ? "early" : "late", tolerances.time_shift_channel));
    } else {
        result.notes.push_back(fmt::format("No time shift within {:.4g} s could be found from {}.",
                                           tolerances.time_shift_max, tolerances.time_shift_channel));
    }
}

void checkTimeSpan(Comparison& result, std::span<const double> reference, std::span<const double> candidate,
                   double allowed) {
    const double begins = candidate.front() - result.time_shift - reference.front();
    const double ends = candidate.back() - result.time_shift - reference.back();
    if (std::abs(begins) > allowed) {
        result.faults.push_back(fmt::format("The candidate begins {:.4g} s {} (at {:.4g} s).", std::abs(begins),
                                            begins > 0 ? "late" : "early", candidate.front()));
    }
    if (std::abs(ends) > allowed) {
        result.faults.push_back(fmt::format("The candidate ends {:.4g} s {} (at {:.4g} s).", std::abs(ends),
                                            ends > 0 ? "late" : "early", candidate.back()));
    }
}

void listChannelsOfOneLogOnly(Comparison& result, const Log& reference, const Log& candidate,
                              const Tolerances& tolerances) {
    for (const Channel& channel : reference.channels) {
        if (!candidate.find(channel.name) && !allowedDifference(tolerances, channel).ignore) {
            result.missing.push_back(channel.name);
        }
    }
    for (const Channel& channel : candidate.channels) {
        if (!reference.find(channel.name)) result.extra.push_back(channel.name);
    }
    for (const ChannelTolerance& own : tolerances.channels) {
        const auto fits = [&](const Channel& channel) { return matches(own.channel, channel.name); };
        if (std::none_of(reference.channels.begin(), reference.channels.end(), fits)) {
            result.notes.push_back(fmt::format("The tolerance for '{}' matches no channel.", own.channel));
        }
    }
}

std::string whyNothing(const Log& reference, const Log& candidate, const Tolerances& tolerances) {
    if (reference.channels.size() < 2 || candidate.channels.size() < 2) {
        return fmt::format("found no channel but time in the {}, expected at least one to compare",
                           reference.channels.size() < 2 ? "reference" : "candidate");
    }
    const auto in_common = std::count_if(reference.channels.begin() + 1, reference.channels.end(),
                                         [&](const Channel& channel) { return candidate.find(channel.name); });
    if (in_common == 0) {
        return fmt::format(
            "found no channel in common (the reference has {}, the candidate {}), expected at least one; rename the "
            "columns of one log",
            reference.channels[1].name, candidate.channels[1].name);
    }
    const auto ignored =
        std::count_if(reference.channels.begin() + 1, reference.channels.end(), [&](const auto& channel) {
            return candidate.find(channel.name) && allowedDifference(tolerances, channel).ignore;
        });
    if (ignored < in_common) return {};  // others differ in their unit
    return fmt::format("found that the tolerances ignore all channels in common ({}), expected at least one to compare",
                       in_common);
}

}  // namespace

double ChannelComparison::severity() const {
    if (largest <= 0) return 0;
    return allowed > 0 ? largest / allowed : std::numeric_limits<double>::infinity();
}

std::size_t Comparison::differing() const {
    const auto differs = [](const ChannelComparison& channel) { return !channel.same; };
    return static_cast<std::size_t>(std::count_if(channels.begin(), channels.end(), differs));
}

Comparison compare(const Log& reference, const Log& candidate, const Tolerances& tolerances) {
    Comparison result;
    if (reference.samples() == 0 || candidate.samples() == 0) {
        result.same = false;
        result.faults.push_back(reference.samples() == 0 ? "The reference is empty." : "The candidate is empty.");
        return result;
    }
    findTimeShift(result, reference, candidate, tolerances);
    checkTimeSpan(result, reference.channels.front().values, candidate.channels.front().values, tolerances.time_span);
    listChannelsOfOneLogOnly(result, reference, candidate, tolerances);

    const CommonTime common = commonTime(reference, candidate, result.time_shift);
    if (common.reference.empty()) {
        result.faults.push_back("The logs have no time in common.");
    } else {
        result.from = common.reference.front();
        result.to = common.reference.back();
        for (std::size_t i = 1; i < reference.channels.size(); ++i) {
            const Channel& here = reference.channels[i];
            const Channel* there = candidate.find(here.name);
            const AllowedDifference allowed = allowedDifference(tolerances, here);
            if (!there || allowed.ignore) continue;
            if (here.unit != there->unit) {
                result.faults.push_back(fmt::format("{} is in {} in the reference, but in {} in the candidate.",
                                                    here.name, here.unit, there->unit));
                continue;
            }
            result.channels.push_back(compareChannel(here, *there, candidate.channels.front().values, common, allowed));
        }
        if (result.channels.empty()) result.nothing = whyNothing(reference, candidate, tolerances);
    }
    result.same = result.nothing.empty() && result.faults.empty() && result.missing.empty() && result.differing() == 0;
    return result;
}

}  // namespace tread
