// Checks of each channel by itself, and of the time base.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recording/checks/log_checks.h"
#include "recording/short_spikes.h"

namespace tread::recording::checks {
namespace {

constexpr double kSlowest = 20;        // samples per second: rows of a diagnosis are 20 Hz
constexpr double kUneven = 0.5;        // deviation of a step in time, relative to the median step
constexpr double kSpikeLimit = 12;     // robust standard deviations, the limit of tread import
constexpr double kManySpikes = 0.01;   // share of samples
constexpr double kSaturated = 0.15;    // s at exactly the largest or smallest value
constexpr double kStuckShare = 0.3;    // share of the recording during which a channel may keep one value
constexpr double kBeyondShare = 0.01;  // share of samples; fewer beyond the plausible range are spikes
// Share of samples that repeat the previous one, above which the channel is a slower source that was held.
constexpr double kHeldShare = 0.6;

bool isMeasured(const Channel& channel) {
    const auto begins = [&](std::string_view beginning) { return channel.name.starts_with(beginning); };
    return begins("chassis.") || begins("wheel.") || begins("driver.");
}

// Inputs may stay constant: a pedal rests at its end and a gear does not change.
bool mayRest(const Channel& channel) {
    return channel.name.starts_with("driver.");
}

void checkGaps(const LogChecks& checks, const Channel& channel) {
    const auto missing =
        std::count_if(channel.values.begin(), channel.values.end(), [](double value) { return !std::isfinite(value); });
    if (missing == 0) return;
    const std::size_t first = static_cast<std::size_t>(
        std::find_if(channel.values.begin(), channel.values.end(), [](double v) { return !std::isfinite(v); }) -
        channel.values.begin());
    checks.warn(channel.name,
                fmt::format("{} of {} values are missing, the first at {:.2f} s", missing, channel.values.size(),
                            checks.time()[first]),
                mayRest(channel) ? "An unknown input cannot be replayed" : "Missing values carry no information",
                "Choose a window (from, to) without the gap, or let tread import fill it");
}

struct Runs {
    std::size_t longest = 0, begin = 0;  // of equal values
    std::size_t repeated = 0;            // samples equal to the one before
};
Runs runsOf(const std::vector<double>& values) {
    Runs runs;
    std::size_t start = 0;
    for (std::size_t i = 1; i <= values.size(); ++i) {
        if (i < values.size() && values[i] == values[i - 1]) {
            ++runs.repeated;
            continue;
        }
        if (i - start > runs.longest) runs = {i - start, start, runs.repeated};
        start = i;
    }
    return runs;
}

void checkRuns(const LogChecks& checks, const Channel& channel) {
    const auto& values = channel.values;
    const Runs runs = runsOf(values);
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    const double seconds = static_cast<double>(runs.longest) / checks.rate();
    const double at = checks.time()[runs.begin];
    if (mayRest(channel)) return;
    if (*lowest == *highest) {
        checks.warn(channel.name, fmt::format("is constant at {:.4g} {}", *lowest, channel.unit),
                    "A stuck or disconnected sensor is mistaken for a car that does not move",
                    "Leave the channel out (channels), or repair the recording");
    } else if (seconds > kStuckShare * checks.time().back() && seconds > 0.5) {
        checks.warn(channel.name,
                    fmt::format("stays at {:.4g} {} for {:.2f} s, starting at {:.2f} s", values[runs.begin],
                                channel.unit, seconds, at),
                    "A sensor that is temporarily stuck is mistaken for a car that does not move",
                    "Choose a window without this period, or leave the channel out");
    } else if (const double value = values[runs.begin];
               value != 0 && (value == *lowest || value == *highest) && seconds > kSaturated) {
        checks.warn(channel.name,
                    fmt::format("stays at its extreme value, {:.4g} {}, for {:.2f} s, starting at {:.2f} s", value,
                                channel.unit, seconds, at),
                    "A saturated sensor clips the peak, and the difference would be attributed to the model",
                    "Choose a window without this period, or use a sensor with a larger range");
    } else if (static_cast<double>(runs.repeated) > kHeldShare * static_cast<double>(values.size())) {
        const double hold = static_cast<double>(values.size()) / static_cast<double>(values.size() - runs.repeated);
        checks.warn(channel.name,
                    fmt::format("changes only at about {:.3g} Hz: a slower signal, held between its samples",
                                checks.rate() / hold),
                    fmt::format("Its mean delay is about {:.0f} ms, which looks like a delay of the car",
                                500 * hold / checks.rate()),
                    "Specify its delay (instruments), or import it with its own time base");
    }
}

void warnOfSpikes(const LogChecks& checks, const Channel& channel, const std::vector<std::size_t>& spikes,
                  const char* consequence, const char* advice) {
    checks.warn(
        channel.name,
        fmt::format("{} {}, the first at {:.2f} s", spikes.size(),
                    spikes.size() == 1 ? "value is a spike" : "values are spikes", checks.time()[spikes.front()]),
        consequence, advice);
}

// Short spikes are interpolated. Where there are many, the instrument is at fault.
void checkSpikes(const LogChecks& checks, const Channel& channel) {
    std::vector<double> values = channel.values, without_short = channel.values;
    const auto spikes = replaceSpikes(checks.time(), values, kSpikeLimit);
    if (spikes.empty()) return;
    replaceShortSpikes(checks.time(), without_short);
    if (const auto left = replaceSpikes(checks.time(), without_short, kSpikeLimit); !left.empty())
        warnOfSpikes(checks, channel, left, "One outlier weighs as much as seconds of driving",
                     "Remove the spikes with tread import");
    else if (static_cast<double>(spikes.size()) > kManySpikes * static_cast<double>(values.size()))
        warnOfSpikes(checks, channel, spikes, "The diagnosis interpolates them, and cannot see the motion there",
                     "Check the instrument and its wiring");
}

// Largest plausible value, and the unit that a larger one suggests.
struct Largest {
    std::string_view channel;
    double value;
    const char* like;
};
constexpr Largest kLargest[] = {{"driver.throttle", 1.1, "per cent"},
                                {"driver.brake", 1.1, "per cent, or a pressure"},
                                {"driver.clutch", 1.1, "per cent"},
                                {"driver.steering_wheel_angle", 20, "degrees"},
                                {"chassis.yaw_rate", 5, "degrees per second"},
                                {"chassis.roll_rate", 5, "degrees per second"},
                                {"chassis.roll", 1, "degrees"},
                                {"chassis.sideslip", 3.2, "degrees"}};

void checkSize(const LogChecks& checks, const Channel& channel) {
    const auto known = std::find_if(std::begin(kLargest), std::end(kLargest),
                                    [&](const Largest& one) { return one.channel == channel.name; });
    if (known == std::end(kLargest)) return;
    double most = 0, beyond = 0;
    for (const double value : channel.values) {
        if (!(std::abs(value) > known->value)) continue;
        most = std::max(most, std::abs(value));
        ++beyond;
    }
    if (beyond < kBeyondShare * static_cast<double>(channel.values.size()) || beyond == 0) return;
    checks.warn(channel.name,
                fmt::format("reaches {:.3g}, more than {:.3g}{}, as if it were in {}", most, known->value,
                            channel.unit == "-" ? "" : " " + channel.unit, known->like),
                "A wrong unit or scale factor is mistaken for a difference between car and model",
                "Check the unit of the channel (channels, import)");
}

void checkTime(const LogChecks& checks) {
    const auto& time = checks.time();
    const double usual = 1 / checks.rate();
    double largest = 0, at = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double off = std::abs(time[i] - time[i - 1] - usual);
        if (off > largest) {
            largest = off;
            at = time[i - 1];
        }
    }
    if (largest > kUneven * usual) {
        checks.warn("time", fmt::format("step of {:.3g} s at {:.2f} s, {:.3g} s elsewhere", usual + largest, at, usual),
                    "A gap or jump in time shifts everything after it relative to the inputs",
                    "Choose a window on one side of it, or import the log with repairs.rate");
    }
    if (checks.rate() < kSlowest) {
        checks.warn("time", fmt::format("{:.3g} samples per second", checks.rate()),
                    "Delays, tyre relaxation and damping act within less than one sample interval",
                    fmt::format("Record at {:.0f} Hz or more; 100 Hz is usual", kSlowest));
    }
}

}  // namespace

const std::vector<double>* LogChecks::values(const std::string& channel) const {
    const Channel* found_channel = log.find(channel);
    return found_channel ? &found_channel->values : nullptr;
}

double LogChecks::rate() const {
    const auto& times = time();
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    return 1 / steps[steps.size() / 2];
}

void LogChecks::warn(const std::string& channel, std::string what, std::string why, std::string advice) const {
    found.push_back(
        {recording.name + (channel.empty() ? "" : ", " + channel), std::move(what), std::move(why), std::move(advice)});
}

void checkChannels(const LogChecks& checks) {
    checkTime(checks);
    for (const Channel& channel : checks.log.channels) {
        if (!isMeasured(channel)) continue;
        checkGaps(checks, channel);
        checkRuns(checks, channel);
        checkSpikes(checks, channel);
        checkSize(checks, channel);
    }
}

}  // namespace tread::recording::checks
