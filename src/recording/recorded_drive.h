// A recording prepared for replay: block means of the measured channels, and the driver's inputs.
#pragma once

#include <Eigen/Dense>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "log/log.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::recording {

// One channel of a drive. Its rows are means over blocks of 50 ms, which keep the motion of the car and suppress
// vibration.
struct ObservedChannel {
    std::string name;
    std::vector<double> measured;  // at every sample
    double noise = 0;              // standard deviation of a block's mean, in the unit of the channel
    Eigen::Index first_row = 0;
    std::vector<double> times;  // s, middle of each block that contains a measured value

    Eigen::Index rows() const { return std::ssize(times); }
};

// A gap in an input of the driver, too long to repeat the drive beyond it.
struct InputGap {
    std::string channel;
    double from = 0, to = 0;  // s
};

struct Reference;

struct RecordedDrive {
    std::string name;
    const Recording* recording = nullptr;
    Log log;
    Log inputs;                // of the driver, with the noise removed
    std::vector<double> time;  // s, of the samples
    std::vector<ObservedChannel> channels;
    Eigen::VectorXd measured;                         // all rows
    double speed = 0;                                 // m/s, measured speed at the start
    std::optional<InputGap> gap = {};                 // the first one
    double until = kInfinity;                         // s; later rows carry no information about the car
    double until_reference = kInfinity;               // s; the same for its reference. `until` is not later.
    std::shared_ptr<const Reference> reference = {};  // whose gap is subtracted from `measured`; null without one
    int runs = 1;  // number of runs whose noise and disturbances the rows contain: 2 when a reference is subtracted

    Eigen::Index rows() const { return measured.size(); }
    double duration() const { return time.back(); }
    bool compared() const { return runs > 1; }
};
using Drives = std::span<const RecordedDrive>;

// True when every drive has a reference.
bool compared(Drives drives);

// Index of the first drive that this one repeats, so that the model's sensitivities are the same; its own index if
// none.
std::size_t firstLike(Drives drives, std::size_t drive);

inline constexpr double kBlock = 0.05;  // s, length of a block

// True when the file names this channel, or names no channels at all.
bool wanted(const DiagnosisFile& file, const std::string& channel);

// The log without the readings that the diagnosis does not use: those of channels that are not wanted. The speed that
// is followed stays.
Log withUsedChannels(const Log& log, const DiagnosisFile& file);

// Prepares a recording with all channels of the log that a diagnosis can use. The drive refers to `recording`. Throws
// std::invalid_argument when there are fewer than two samples, no start speed or no such channel.
RecordedDrive recordedDrive(const Recording& recording, const Log& log, const DiagnosisFile& file);
RecordedDrive recordedDrive(Recording&&, const Log&, const DiagnosisFile&) = delete;

// Block means of one channel from readings at the samples of a drive (D1).
Eigen::VectorXd blockMeans(const ObservedChannel& channel, const std::vector<double>& time,
                           const std::vector<double>& readings);

}  // namespace tread::recording
