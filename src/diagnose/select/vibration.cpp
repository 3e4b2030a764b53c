#include "diagnose/select/vibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/math/median.h"
#include "diagnose/select/what_remains.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr double kWindow = 1;          // s, half overlapping: it resolves frequencies 1 Hz apart
constexpr int kLowest = 3;             // Hz: drivers and manoeuvres are slower
constexpr int kHighest = 20;           // Hz: above it, a body is no longer rigid
constexpr double kShown = 0.4;         // highest frequency that samples show, in their rate
constexpr std::size_t kFewest = 3;     // windows of a drive
constexpr Eigen::Index kFewestAt = 6;  // frequencies: of three others, the median is the level of a channel

constexpr std::array<std::string_view, 6> kMotions{"chassis.ax",       "chassis.ay",        "chassis.az",
                                                   "chassis.yaw_rate", "chassis.roll_rate", "chassis.pitch_rate"};

// Of the first instrument: a further one would count the same vibration again.
bool isMotion(const Channel& channel) {
    return std::find(kMotions.begin(), kMotions.end(), channel.name) != kMotions.end();
}

// Logarithm of the power of a channel at each frequency: medians over windows, so that neither a bump nor an abrupt
// manoeuvre counts.
struct Spectrum {
    Eigen::ArrayXd log_power;
    std::size_t windows = 0;
};

// Power of one window at each frequency, less the slow motion, which is a cubic.
Eigen::ArrayXd powerOf(const Eigen::ArrayXd& time, const Eigen::VectorXd& values, Eigen::Index frequencies) {
    const Eigen::ArrayXd place = 2 * (time - time(0)) / kWindow - 1;  // -1 to 1
    Eigen::MatrixX4d slow(time.size(), 4);
    slow << Eigen::ArrayXd::Ones(time.size()), place, place.square(), place.cube();
    const Eigen::Vector4d cubic = (slow.transpose() * slow).ldlt().solve(slow.transpose() * values);
    const Eigen::ArrayXd hann = 0.5 + 0.5 * (std::numbers::pi * place).cos();
    const Eigen::ArrayXd rest = (values - slow * cubic).array() * hann;
    Eigen::ArrayXd power(frequencies);
    for (Eigen::Index i = 0; i < frequencies; ++i) {
        const Eigen::ArrayXd phase = 2 * std::numbers::pi * static_cast<double>(kLowest + i) * (time - time(0));
        power(i) = std::pow((rest * phase.cos()).mean(), 2) + std::pow((rest * phase.sin()).mean(), 2);
    }
    return power;
}

Spectrum spectrumOf(const std::vector<double>& time, const std::vector<double>& values, Eigen::Index frequencies) {
    std::vector<std::vector<double>> powers(frequencies);
    std::size_t windows = 0;
    for (double from = time.front(); from + kWindow <= time.back(); from += 0.5 * kWindow) {
        const auto first = std::lower_bound(time.begin(), time.end(), from) - time.begin();
        const auto last = std::lower_bound(time.begin(), time.end(), from + kWindow) - time.begin();
        const Eigen::Map<const Eigen::ArrayXd> times(time.data() + first, last - first);
        const Eigen::Map<const Eigen::VectorXd> read(values.data() + first, last - first);
        const bool full = static_cast<double>(last - first) * kShown >= static_cast<double>(kLowest + frequencies - 1);
        if (!full || !read.allFinite()) continue;
        const Eigen::ArrayXd power = powerOf(times, read, frequencies);
        for (Eigen::Index i = 0; i < frequencies; ++i) powers[i].push_back(power(i));
        ++windows;
    }
    Spectrum spectrum{Eigen::ArrayXd(frequencies), windows};
    for (Eigen::Index i = 0; i < frequencies; ++i) spectrum.log_power(i) = std::log(median(std::move(powers[i])));
    return spectrum;
}

// Growth of a channel at each frequency: of the logarithm of its power, with the variance of that by noise alone.
struct Growth {
    Eigen::ArrayXd at;
    double by_noise = 0;
};

// How a channel differs from that of the references.
struct Difference {
    std::vector<Eigen::ArrayXd> log_power;  // of each drive
    double variance = 0;                    // sum over the drives

    // The power of a window is exponentially distributed, and a median of n has the relative variance 1/(n ln2^2).
    void add(const Spectrum& after, const Spectrum& before) {
        const Eigen::ArrayXd more = after.log_power - before.log_power;
        if (after.windows < kFewest || before.windows < kFewest || !more.allFinite()) return;
        log_power.push_back(more);
        variance += (1 / static_cast<double>(after.windows) + 1 / static_cast<double>(before.windows)) /
                    std::pow(std::numbers::ln2, 2);
    }

    // Median over the drives.
    Growth growth() const {
        Eigen::ArrayXd all(log_power.front().size());
        for (Eigen::Index i = 0; i < all.size(); ++i) {
            std::vector<double> drives;
            for (const Eigen::ArrayXd& drive : log_power) drives.push_back(drive(i));
            all(i) = median(std::move(drives));
        }
        return {std::move(all), 0.5 * std::numbers::pi * variance / std::pow(static_cast<double>(log_power.size()), 2)};
    }
};

// Growth of each channel at one frequency, beyond that at the others: what a rougher road or a higher speed changes.
// The neighbours are not among the others, because a vibration shows in them as well.
struct Peak {
    std::map<std::string, double> height;  // of each channel
    double between_days = 0;               // variance of a height, as the others tell it
};

Peak peakAt(Eigen::Index frequency, const std::map<std::string, Growth>& channels) {
    const auto frequencies = static_cast<double>(channels.begin()->second.at.size());
    // The expected value counts like one more channel.
    double squares = frequencies * std::pow(kSettings.vibration_between_days, 2), count = frequencies;
    Peak peak;
    for (const auto& [name, growth] : channels) {
        std::vector<double> others;
        for (Eigen::Index i = 0; i < growth.at.size(); ++i)
            if (std::abs(i - frequency) > 1) others.push_back(growth.at(i));
        const double level = median(others);
        for (const double other : others) squares += std::pow(other - level, 2) - growth.by_noise, ++count;
        peak.height[name] = growth.at(frequency) - level;
    }
    peak.between_days = std::max(0.0, squares) / count;
    return peak;
}

// Frequencies that the samples of all drives show, from the lowest.
Eigen::Index frequenciesShown(const recording::Recorded& recorded) {
    double highest = kHighest;
    for (const std::vector<Log>* logs : {&recorded.logs, &recorded.references})
        for (const Log& log : *logs)
            if (log.samples() > 1) highest = std::min(highest, kShown / medianStep(log.channels.front().values));
    return static_cast<Eigen::Index>(highest) - kLowest + 1;
}

std::map<std::string, Difference> differences(const recording::Recorded& recorded, Eigen::Index frequencies) {
    std::map<std::string, Difference> all;
    for (std::size_t i = 0; i < recorded.references.size(); ++i) {
        const Log &after = recorded.logs[i], &before = recorded.references[i];
        for (const Channel& channel : before.channels) {
            const Channel* changed = isMotion(channel) ? after.find(channel.name) : nullptr;
            if (!changed) continue;
            all[channel.name].add(spectrumOf(after.channels.front().values, changed->values, frequencies),
                                  spectrumOf(before.channels.front().values, channel.values, frequencies));
        }
    }
    std::erase_if(all, [](const auto& channel) { return channel.second.log_power.empty(); });
    return all;
}

}  // namespace

answer::Vibration vibrationOf(const recording::Recorded& recorded) {
    const Eigen::Index frequencies = frequenciesShown(recorded);
    if (frequencies < kFewestAt) return {};
    std::map<std::string, Growth> channels;
    for (const auto& [name, difference] : differences(recorded, frequencies)) channels[name] = difference.growth();
    if (channels.empty()) return {};
    answer::Vibration vibration;
    for (Eigen::Index i = 0; i < frequencies; ++i) {
        const Peak peak = peakAt(i, channels);
        answer::Vibration here{.frequency = static_cast<double>(kLowest + i),
                               .gain = -std::log(static_cast<double>(frequencies))};
        for (const auto& [name, height] : peak.height) {
            const double deviation = std::sqrt(peak.between_days + channels.at(name).by_noise);
            const double nats = natsOfTail(std::max(0.0, height) / deviation);
            if (nats > 0) here.growth[name] = std::exp(0.5 * height);
            here.gain += nats;
        }
        if (here.gain > vibration.gain) vibration = std::move(here);
    }
    return vibration;
}

}  // namespace tread::diagnose::select
