#include "recording/recorded_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "log/log_columns.h"
#include "recording/driver_inputs.h"
#include "recording/observation.h"
#include "recording/position.h"
#include "recording/short_spikes.h"

namespace tread::recording {
namespace {

constexpr double kStartFit = 0.5;       // s at the start, over which a line is fitted to the speed
constexpr double kTimeRounding = 1e-9;  // s, tolerance for times that should fall on the boundary of a block
constexpr double kAlikeSpeed = 0.03;    // relative difference in start speed up to which two drives count as repeats

// Value at t = 0 of a line through the first half second.
double atStart(const std::vector<double>& time, const std::vector<double>& values) {
    double n = 0, t = 0, v = 0, tt = 0, tv = 0;
    for (std::size_t i = 0; i < time.size() && time[i] <= kStartFit; ++i) {
        if (!std::isfinite(values[i])) continue;
        n += 1, t += time[i], v += values[i], tt += time[i] * time[i], tv += time[i] * values[i];
    }
    const double spread = n * tt - t * t;
    return spread > 0 ? (v * tt - t * tv) / spread : n > 0 ? v / n : kRequired;
}

double startSpeed(const Log& log, const std::vector<double>& time, const std::string& name) {
    const Channel* speed = measuredAs(log, "chassis.vx");
    const double value = speed ? atStart(time, speed->values) : kRequired;
    if (std::isfinite(value)) return std::max(0.0, value);
    throw std::invalid_argument(fmt::format(
        "recording {}: found no speed in the first half second, expected values of chassis.vx, the start speed of the "
        "replay; record it or start the window later (from)",
        name));
}

// True when the channel follows from this measured position.
bool isOfPosition(std::string_view position, std::string_view channel) {
    const std::string_view source = sourceOf(position);
    return position.starts_with("position.") && sourceOf(channel) == (source.empty() ? kPositionSource : source);
}

// Standard deviation of a block's mean from the noise that the file states; 0: not stated.
double toldNoise(const DiagnosisFile& file, const std::string& channel, double sample_interval) {
    for (const MeasuredChannel& told : file.channels) {
        if (told.channel == channel) return told.noise / std::sqrt(std::max(1.0, kBlock / sample_interval));
        // The mean of a block is the displacement over it, the difference of two positions (or headings).
        const bool heading = quantityOf(told.channel) == "position.heading";
        if (isOfPosition(told.channel, channel) && heading == (quantityOf(channel) == "chassis.yaw_rate"))
            return told.noise / kBlock;
    }
    return 0;
}

// The log with short spikes of the motion and of the inputs interpolated.
Log withoutSpikes(Log log) {
    const std::vector<double> time = log.channels.front().values;
    for (Channel& channel : log.channels)
        if (observedQuantity(channel.name) || isInput(channel.name)) replaceShortSpikes(time, channel.values);
    return log;
}

// The channels of a log that a diagnosis can use, by quantity; of each quantity the first instrument comes first.
std::vector<const Channel*> observedChannels(const Log& log) {
    std::vector<const Channel*> channels;
    for (const ObservedQuantity& quantity : observedQuantities()) {
        if (const Channel* first = log.find(quantity.channel)) channels.push_back(first);
        for (const Channel& channel : log.channels) {
            if (channel.name != quantity.channel && quantityOf(channel.name) == quantity.channel)
                channels.push_back(&channel);
        }
    }
    return channels;
}

// The measured values that show motion within the drive: a delayed instrument shows first what was before it.
std::vector<double> ofTheDrive(const Channel& measured, const std::vector<double>& time, double delay) {
    std::vector<double> values = measured.values;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] - delay < -kTimeRounding || time[i] - delay > time.back() + kTimeRounding) values[i] = kRequired;
    }
    return values;
}

// Time from which a channel is compared, s. While the speed is followed, speed and longitudinal acceleration are those
// of the recording whatever the car.
double comparedFrom(const Recording& recording, const std::string& channel) {
    const std::string_view quantity = quantityOf(channel);
    if (quantity != "chassis.vx" && quantity != "chassis.ax") return 0;
    return recording.followedUntil();
}

double blockOf(double time) {
    return std::floor((time + kTimeRounding) / kBlock);
}

// A channel with its blocks, as far as it is compared. A block counts with at least half of the samples of a full one:
// the noise of all rows is taken to be the same, and that of fewer samples is larger. (A log that ends with a block's
// beginning has one sample in its last block.)
ObservedChannel observed(const Channel& measured, const std::vector<double>& time, double delay, double compared_from) {
    ObservedChannel channel{.name = measured.name, .measured = ofTheDrive(measured, time, delay), .times = {}};
    std::map<double, int> samples;  // of each block
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < compared_from) channel.measured[i] = std::nan("");
        if (std::isfinite(channel.measured[i])) ++samples[blockOf(time[i])];
    }
    int full = 0;
    for (const auto& [block, count] : samples) full = std::max(full, count);
    std::erase_if(samples, [&](const auto& one) { return 2 * one.second < full; });
    for (std::size_t i = 0; i < time.size(); ++i)
        if (!samples.contains(blockOf(time[i]))) channel.measured[i] = std::nan("");
    for (const auto& [block, count] : samples) channel.times.push_back((block + 0.5) * kBlock);
    return channel;
}

// Throws std::invalid_argument where a drive cannot be replayed by a command, or shows nothing of its effect.
void expectCommand(const RecordedDrive& drive) {
    if (drive.recording->speed != SpeedReplay::command) return;
    const std::string command = commandOf(drive.log);
    if (command.empty())
        throw std::invalid_argument(fmt::format(
            "recording {}: found neither command.force nor command.acceleration, expected one of them for speed: "
            "command; name its column (import, channels) or set speed: followed",
            drive.name));
    const auto answers = [](const ObservedChannel& channel) {
        const std::string_view quantity = quantityOf(channel.name);
        return quantity == "chassis.vx" || quantity == "chassis.ax";
    };
    if (std::none_of(drive.channels.begin(), drive.channels.end(), answers))
        throw std::invalid_argument(fmt::format(
            "recording {}: found {} but no measured speed or longitudinal acceleration to compare with, expected "
            "chassis.vx or chassis.ax among the channels; measure one of them or set speed: followed",
            drive.name, command));
}

}  // namespace

bool compared(Drives drives) {
    return !drives.empty() &&
           std::all_of(drives.begin(), drives.end(), [](const RecordedDrive& drive) { return drive.compared(); });
}

std::size_t firstLike(Drives drives, std::size_t drive) {
    const RecordedDrive& here = drives[drive];
    const std::string& group = here.recording->repeat_group;
    const auto sameRows = [](const ObservedChannel& a, const ObservedChannel& b) {
        return a.name == b.name && a.times == b.times;
    };
    for (std::size_t other = 0; other < drive && !group.empty(); ++other) {
        const RecordedDrive& there = drives[other];
        if (there.recording->repeat_group == group && std::abs(there.speed - here.speed) < kAlikeSpeed * here.speed &&
            std::equal(here.channels.begin(), here.channels.end(), there.channels.begin(), there.channels.end(),
                       sameRows))
            return other;
    }
    return drive;
}

bool wanted(const DiagnosisFile& file, const std::string& channel) {
    if (file.channels.empty()) return true;
    return std::any_of(file.channels.begin(), file.channels.end(), [&](const MeasuredChannel& told) {
        return told.channel == channel || isOfPosition(told.channel, channel);
    });
}

Log withUsedChannels(const Log& log, const DiagnosisFile& file) {
    const Channel* speed = measuredAs(log, "chassis.vx");
    const std::string followed = speed ? speed->name : "";
    Log used = log;
    std::erase_if(used.channels, [&](const Channel& channel) {
        return observedQuantity(channel.name) && !wanted(file, channel.name) && channel.name != followed;
    });
    return used;
}

Eigen::VectorXd blockMeans(const ObservedChannel& channel, const std::vector<double>& time,
                           const std::vector<double>& readings) {
    Eigen::VectorXd means(channel.rows());
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < time.size();) {
        const double block = blockOf(time[i]);
        double sum = 0, count = 0;
        for (; i < time.size() && blockOf(time[i]) == block; ++i) {
            if (std::isfinite(channel.measured[i])) sum += readings[i], count += 1;
        }
        if (count > 0) means(row++) = sum / count;
    }
    return means;
}

RecordedDrive recordedDrive(const Recording& recording, const Log& recorded, const DiagnosisFile& file) {
    const std::string& name = recording.name.empty() ? recording.log : recording.name;
    if (recorded.samples() < 2)
        throw std::invalid_argument(fmt::format(
            "recording {}: found fewer than two samples, expected a whole drive; check its log and its window", name));
    RecordedDrive drive{.name = name,
                        .recording = &recording,
                        .log = withoutSpikes(recorded),
                        .inputs = {},
                        .time = {},
                        .channels = {},
                        .measured = {}};
    const Log& log = drive.log;
    drive.inputs = quietInputs(log);
    drive.time = log.channels.front().values;
    drive.speed = startSpeed(log, drive.time, drive.name);
    drive.gap = firstGap(drive);
    if (drive.gap) drive.until = drive.gap->from;
    Eigen::Index rows = 0;
    for (const Channel* measured : observedChannels(log)) {
        if (!wanted(file, measured->name)) continue;
        const double delay = instrumentOf(file.instruments, measured->name).delay + file.instruments.latency;
        ObservedChannel channel = observed(*measured, drive.time, delay, comparedFrom(recording, measured->name));
        if (channel.times.empty()) continue;
        channel.noise = toldNoise(file, channel.name, drive.duration() / static_cast<double>(drive.time.size() - 1));
        channel.first_row = rows;
        rows += channel.rows();
        drive.channels.push_back(std::move(channel));
    }
    if (drive.channels.empty()) {
        throw std::invalid_argument(fmt::format(
            "recording {}: found no channel that a diagnosis can use, expected at least one of {}; check the names in "
            "the log and under channels",
            drive.name, observedQuantitiesListed()));
    }
    expectCommand(drive);
    drive.measured.resize(rows);
    for (const ObservedChannel& channel : drive.channels)
        drive.measured.segment(channel.first_row, channel.rows()) = blockMeans(channel, drive.time, channel.measured);
    return drive;
}

}  // namespace tread::recording
