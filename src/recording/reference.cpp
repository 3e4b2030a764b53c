#include "recording/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "log/resample.h"
#include "recording/observation.h"
#include "recording/replay.h"
#include "recording/sliding.h"
#include "run/together.h"

namespace tread::recording {
namespace {

// Root mean square of the difference of an input, relative to that of the input, above which a reference is a different
// drive.
constexpr double kAnotherDrive = 0.25;
constexpr double kStill = 0.05;        // rad or share of a pedal, always allowed: small corrections by the driver
constexpr double kOtherZero = 0.2;     // rad by which the zeros of two steering angles may differ
constexpr double kShorter = 0.2;       // s by which a reference may be shorter
constexpr double kAnotherSpeed = 0.1;  // relative difference in start speed; allows for a speedometer that was changed

double rms(std::span<const double> values) {
    double sum = 0, count = 0;
    for (const double value : values)
        if (std::isfinite(value)) sum += value * value, count += 1;
    return count > 0 ? std::sqrt(sum / count) : 0;
}

// Difference of an input in two drives, less what another zero of the steering angle or another level of a pedal
// explains. Either may come from the change that is sought: a car that drags needs more throttle.
std::vector<double> differences(const std::string& name, std::vector<double> here, const std::vector<double>& there) {
    double level = 0, count = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
        here[i] -= there[i];
        if (std::isfinite(here[i])) level += here[i], count += 1;
    }
    if (count > 0) level /= count;
    if (name == "driver.steering_wheel_angle") level = std::clamp(level, -kOtherZero, kOtherZero);
    for (double& one : here) one -= level;
    return here;
}

// Throws std::invalid_argument unless the driver does the same in both.
void expectSameDrive(const RecordedDrive& drive, const RecordedDrive& reference) {
    const auto another = [&](const std::string& found) {
        throw std::invalid_argument(fmt::format(
            "recording {}: {}, expected a reference of the same drive with the same time base; align the two logs or "
            "remove the reference",
            drive.name, found));
    };
    if (std::abs(drive.speed - reference.speed) > kAnotherSpeed * std::max(drive.speed, 1.0))
        another(fmt::format("starts at {:.2f} m/s, its reference at {:.2f} m/s", drive.speed, reference.speed));
    if (reference.duration() < drive.duration() - kShorter)
        another(fmt::format("lasts {:.2f} s, its reference {:.2f} s", drive.duration(), reference.duration()));
    std::vector<std::string> replayed{"driver.steering_wheel_angle"};
    if (drive.recording->speed == SpeedReplay::pedals)
        replayed.insert(replayed.end(), {"driver.throttle", "driver.brake"});
    for (const std::string& name : replayed) {
        const Channel *here = drive.inputs.find(name), *there = reference.inputs.find(name);
        if (!here || !there) continue;
        const std::vector<double> then = resample(reference.time, there->values, drive.time);
        const double size = rms(here->values), differs = rms(differences(name, here->values, then));
        if (differs > kAnotherDrive * size + kStill)
            another(fmt::format("{} differs by {:.3g} rms (its own rms is {:.3g}) from that of its reference", name,
                                differs, size));
    }
}

// Subtracts from the drive's rows the gap of the nominal car in its reference (D45).
void lessReference(RecordedDrive& drive, const std::shared_ptr<Reference>& of_drive, const Replayer& replayer) {
    const RecordedDrive& reference = of_drive->drive;
    expectSameDrive(drive, reference);
    Eigen::VectorXd model;
    try {
        model = readings(reference, replayed(reference, replayer.nominal, replayer), replayer.nominal.instruments);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError& error) {
        throw std::invalid_argument(
            fmt::format("recording {}: the simulation of the nominal car in its reference drive fails: {}", drive.name,
                        error.what()));
    }
    drive.until_reference = std::min(reference.until, slideApart(reference, model));
    if (reference.until < drive.until) drive.gap = reference.gap;
    drive.until = std::min(drive.until, drive.until_reference);
    drive.measured -= atRowsOf(drive, reference, reference.measured - model);
    of_drive->nominal = std::move(model);
    drive.reference = of_drive;
    drive.runs += reference.runs;
}

}  // namespace

Recording referenceOf(const Recording& recording) {
    Recording reference = recording;
    reference.name = fmt::format("reference of {} ({})", recording.name, recording.reference);
    reference.log = recording.reference;
    reference.from += recording.reference_later;
    reference.to += recording.reference_later;
    reference.reference_later = 0;
    reference.reference.clear();
    return reference;
}

bool beforeTheChange(DiagnosisFile& file, Recorded& recorded) {
    std::vector<Recording> recordings;
    std::vector<Log> logs;
    for (std::size_t i = 0; i < file.recordings.size(); ++i) {
        if (file.recordings[i].reference.empty()) continue;
        recordings.push_back(referenceOf(file.recordings[i]));
        recordings.back().name = file.recordings[i].name;
        logs.push_back(recorded.references[i]);
    }
    recordings.insert(recordings.end(), file.before.begin(), file.before.end());
    logs.insert(logs.end(), recorded.before.begin(), recorded.before.end());
    if (recordings.empty()) return false;
    file.recordings = std::move(recordings);
    file.before.clear();
    recorded.logs = std::move(logs);
    recorded.references.clear();
    recorded.before.clear();
    return true;
}

Eigen::VectorXd atRowsOf(const RecordedDrive& drive, const RecordedDrive& reference, const Eigen::VectorXd& rows) {
    Eigen::VectorXd result(drive.rows());
    for (const ObservedChannel& channel : drive.channels) {
        const auto known = std::find_if(reference.channels.begin(), reference.channels.end(),
                                        [&](const ObservedChannel& one) { return one.name == channel.name; });
        const std::span<const double> of_channel(rows.data() + known->first_row, known->times.size());
        std::vector<double> times = channel.times;
        for (double& t : times) t = std::clamp(t, known->times.front(), known->times.back());
        const std::vector<double> then = resample(known->times, of_channel, times);
        result.segment(channel.first_row, channel.rows()) =
            Eigen::Map<const Eigen::VectorXd>(then.data(), channel.rows());
    }
    return result;
}

Log withChannelsOf(const Log& log, const Log& reference) {
    Log common = log;
    std::erase_if(common.channels, [&](const Channel& channel) {
        return observedQuantity(channel.name) && !reference.find(channel.name);
    });
    return common;
}

std::vector<RecordedDrive> recordedDrives(const DiagnosisFile& file, const Recorded& recorded, bool held_out,
                                          const Replayer& replayer, int threads) {
    std::vector<RecordedDrive> drives;
    std::vector<std::shared_ptr<Reference>> references;
    for (std::size_t i = 0; i < file.recordings.size(); ++i) {
        const Recording& recording = file.recordings[i];
        if (recording.hold_out != held_out) continue;
        const bool compared = !recording.reference.empty();
        drives.push_back(recordedDrive(
            recording, compared ? withChannelsOf(recorded.logs[i], recorded.references[i]) : recorded.logs[i], file));
        references.push_back(nullptr);
        if (!compared) continue;
        references.back() = std::make_shared<Reference>(Reference{referenceOf(recording), {}, {}});
        references.back()->drive = recordedDrive(references.back()->recording, recorded.references[i], file);
    }
    drivenTogether(drives.size(), threads, [&](std::size_t i) {
        if (references[i] && references[i]->drive.rows() > 0) lessReference(drives[i], references[i], replayer);
    });
    return drives;
}

}  // namespace tread::recording
