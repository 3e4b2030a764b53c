#include "import/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/math/median.h"
#include "base/text/number_text.h"
#include "import/spikes.h"
#include "import/time_base.h"
#include "import/vehicle_reach.h"
#include "log/resample.h"

namespace tread {
namespace {

constexpr double kAverageBelow = 1 / 1.5;  // of the file's rate: a lower rate of the log is had by averaging

std::size_t runsIn(const std::vector<std::size_t>& samples) {
    std::size_t runs = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) runs += i == 0 || samples[i] != samples[i - 1] + 1;
    return runs;
}

std::string criterionText(double fastest, const std::string& unit) {
    if (!std::isfinite(fastest)) return "away and back within three samples, far above the noise";
    const std::string rate = unit.ends_with("/s")    ? unit + "2"
                             : unit.ends_with("/s2") ? unit.substr(0, unit.size() - 1) + "3"
                                                     : unit + "/s";
    return fmt::format(
        "a jump within one sample faster than the {:.6g} {} that a car can do and back, or away and back "
        "within 50 ms far above the noise",
        fastest, rate);
}

}  // namespace

std::vector<double> shifted(std::vector<double> time, double by) {
    for (double& t : time) t += by;
    return time;
}

void repair(const WholeChannel& channel, const ImportRepairs& repairs, const std::vector<double>& time,
            std::vector<double>& values, std::vector<Change>& changes) {
    const ImportChannel& how = *channel.how;
    const auto note = [&](std::string kind, std::size_t count, std::string text) {
        changes.push_back({std::move(kind), how.channel, count, std::move(text)});
    };
    if (repairs.spikes && how.spikes) {
        const std::vector<double> before = values;
        const double fastest = fastestChange(how.channel);
        const auto replaced =
            replaceSpikes(time, values, {repairs.spike_limit, fastest, repairs.max_jump, largestValue(how.channel)});
        if (!replaced.empty()) {
            const std::size_t first = replaced.front();
            const std::string instead =
                std::isfinite(values[first]) ? fmt::format("about {:.4g} {}", values[first], channel.unit) : "nan";
            note("spikes", replaced.size(),
                 fmt::format("{} in {} replaced (the first at {:.6g} s: {:.4g} instead of {}): {}",
                             counted(replaced.size(), "sample"), counted(runsIn(replaced), "spike"), time[first],
                             before[first], instead, criterionText(fastest, channel.unit)));
        }
    }
    const std::size_t filled = repairs.fill_gaps ? fillHoles(time, values, repairs.max_jump) : 0;
    if (filled > 0) note("filled", filled, fmt::format("{} missing values interpolated", filled));
    const auto left = static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }));
    if (left > 0) note("missing", left, fmt::format("{} missing values left as nan", left));
    if (how.delay != 0) {
        values = resample(time, values, shifted(time, how.delay));
        note("delay", values.size(),
             fmt::format("{:.4g} s {} removed", std::abs(how.delay), how.delay > 0 ? "delay" : "lead"));
    }
}

void zeroAndOffset(const WholeChannel& channel, const std::vector<double>& time, std::vector<double>& values,
                   std::vector<Change>& changes) {
    const ImportChannel& how = *channel.how;
    double add = how.offset;
    if (how.zero_over > 0) {
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < time.size() && time[i] - time.front() <= how.zero_over; ++i) {
            if (!std::isfinite(values[i])) continue;
            sum += values[i];
            count += 1;
        }
        const double mean = count > 0 ? sum / count : 0;
        add -= mean;
        changes.push_back(
            {"zero", how.channel, values.size(),
             fmt::format("{:.4g} {} subtracted, the mean of the first {:.4g} s", mean, channel.unit, how.zero_over)});
    }
    if (how.offset != 0) {
        changes.push_back(
            {"offset", how.channel, values.size(), fmt::format("{:+.6g} {} added", how.offset, channel.unit)});
    }
    for (double& value : values) value += add;
}

void resampleLog(Log& log, double rate, std::vector<Change>& changes) {
    const std::vector<double> time = log.channels.front().values;
    const bool average = rate * medianStep(time) < kAverageBelow;
    std::vector<double> at;
    for (std::size_t i = 0; static_cast<double>(i) <= time.back() * rate * (1 + 1e-12); ++i) {
        at.push_back(static_cast<double>(i) / rate);
    }
    for (std::size_t c = 1; c < log.channels.size(); ++c) {
        std::vector<double>& values = log.channels[c].values;
        std::vector<double> out = resample(time, values, at);
        std::size_t first = 0;
        for (std::size_t i = 0; average && i < at.size(); ++i) {
            double sum = 0, count = 0;
            while (first < time.size() && time[first] < at[i] - 0.5 / rate) ++first;
            for (std::size_t k = first; k < time.size() && time[k] < at[i] + 0.5 / rate; ++k) {
                sum += values[k];
                count += 1;
            }
            if (count > 0) out[i] = sum / count;
        }
        values = std::move(out);
    }
    log.channels.front().values = at;
    changes.push_back({"rate", "", at.size(),
                       fmt::format("resampled from {:.6g} to {:.6g} Hz, {}", 1 / medianStep(time), rate,
                                   average ? "each sample the mean over its step" : "linearly")});
}

}  // namespace tread
