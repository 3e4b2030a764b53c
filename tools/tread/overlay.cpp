#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "log/resample.h"

namespace tread::program {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// True for a heading logged between -pi and pi that jumps by a whole turn.
bool wraps(const Channel& channel) {
    const auto jumps = [](double before, double after) { return std::abs(after - before) > std::numbers::pi; };
    return channel.unit == "rad" &&
           std::adjacent_find(channel.values.begin(), channel.values.end(), jumps) != channel.values.end();
}

// A heading without jumps, so that it can be drawn and interpolated.
std::vector<double> unwrapped(std::vector<double> angles) {
    double turns = 0;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const double jump = angles[i] + turns - angles[i - 1];
        if (std::isfinite(jump)) turns -= kTurn * std::round(jump / kTurn);
        angles[i] += turns;
    }
    return angles;
}

// Shifts the candidate by whole turns, so that it is nearest to the reference at the first sample where both have a
// value.
void bringNear(std::vector<double>& candidate, const std::vector<double>& reference) {
    for (std::size_t i = 0; i < candidate.size(); ++i) {
        const double turns = kTurn * std::round((candidate[i] - reference[i]) / kTurn);
        if (!std::isfinite(turns)) continue;
        if (turns != 0) {
            for (double& value : candidate) value -= turns;
        }
        return;
    }
}

// The channel of a further run at the times of the overlay; empty when the run has none in that unit.
std::vector<double> drawnBeside(const Log& log, const ChannelComparison& channel, bool wrapped,
                                const ChannelOverlay& overlay) {
    const Channel* found = log.find(channel.channel);
    if (!found || found->unit != channel.unit) return {};
    const std::vector<double> values = wrapped ? unwrapped(found->values) : found->values;
    std::vector<double> out = resample(log.channels.front().values, values, overlay.time);
    if (wrapped) bringNear(out, overlay.reference);
    return out;
}

}  // namespace

std::vector<ChannelOverlay> overlays(const Log& reference, const Log& candidate, const std::vector<const Log*>& others,
                                     const Comparison& comparison) {
    const std::vector<double>& clock = reference.channels.front().values;
    const auto first = std::lower_bound(clock.begin(), clock.end(), comparison.from) - clock.begin();
    const auto last = std::upper_bound(clock.begin(), clock.end(), comparison.to) - clock.begin();
    const std::vector<double> time(clock.begin() + first, clock.begin() + last);
    std::vector<double> shifted = time;
    for (double& t : shifted) t += comparison.time_shift;

    std::vector<ChannelOverlay> result;
    for (const ChannelComparison& channel : comparison.channels) {
        const Channel& here = *reference.find(channel.channel);
        const Channel& there = *candidate.find(channel.channel);
        const bool wrapped = wraps(here) || wraps(there);
        const std::vector<double> values = wrapped ? unwrapped(here.values) : here.values;
        const std::vector<double> theirs = wrapped ? unwrapped(there.values) : there.values;
        ChannelOverlay overlay{.name = channel.channel,
                               .unit = channel.unit,
                               .time = time,
                               .reference = {values.begin() + first, values.begin() + last},
                               .candidate = resample(candidate.channels.front().values, theirs, shifted),
                               .tolerance = channel.allowed,
                               .largest = channel.largest,
                               .rms = channel.rms,
                               .r_squared = channel.r_squared,
                               .no_fit = channel.no_fit,
                               .first_time_out = {},
                               .ok = channel.same};
        if (wrapped) bringNear(overlay.candidate, overlay.reference);
        for (const Log* other : others) overlay.others.push_back(drawnBeside(*other, channel, wrapped, overlay));
        if (channel.first) overlay.first_time_out = channel.first->time;
        result.push_back(std::move(overlay));
    }
    return result;
}

std::string comparisonReport(const std::vector<ComparedLog>& logs, const Comparison& comparison,
                             const std::string& answer) {
    const ComparedLog &reference = logs[0], &candidate = logs[1];
    std::vector<const Log*> others;
    std::vector<std::string> names;
    for (std::size_t i = 2; i < logs.size(); ++i) others.push_back(&logs[i].log), names.push_back(logs[i].name);
    OverlayReport report{.title = "Comparison of " + candidate.name + " with " + reference.name,
                         .answer = answer,
                         .reference_name = reference.name,
                         .candidate_name = candidate.name,
                         .other_names = names,
                         .version = TREAD_VERSION,
                         .ok = comparison.same,
                         .channels = overlays(reference.log, candidate.log, others, comparison),
                         .warnings = remarks(comparison),
                         .reference_file = reference.file,
                         .candidate_file = candidate.file};
    for (std::size_t i = 0; i < logs.size(); ++i) {
        const RunRecord* const record = logs[i].record;
        report.cars.push_back(
            {logs[i].name, logs[i].log, record ? carShape(record->vehicle) : typicalCarShape(), overlayColour(i)});
    }
    if (reference.record) report.scene = sceneOf(reference.record->scenario);
    return overlayReport(report);
}

}  // namespace tread::program
