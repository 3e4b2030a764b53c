// A recording made ready to be repeated by the model: what was measured, as block means, and what the driver did.
#pragma once

#include <Eigen/Dense>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "log/log.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::recording {

// One channel of a drive. Its rows are means over blocks of 50 ms: that keeps what a car does, and takes out vibration.
struct ObservedChannel {
    std::string name;
    std::vector<double> measured;  // every sample
    double noise = 0;              // standard deviation of a block's mean
    Eigen::Index first_row = 0;
    std::vector<double> times;  // s, of its blocks: those in which something was measured

    Eigen::Index rows() const { return std::ssize(times); }
};

// Where an input of the driver is missing for so long that the drive cannot be repeated from there on.
struct InputGap {
    std::string channel;
    double from = 0, to = 0;  // s
};

struct RecordedDrive {
    std::string name;
    const Recording* recording = nullptr;
    Log log;
    Log inputs;                // of the driver, without noise
    std::vector<double> time;  // s, of the samples
    std::vector<ObservedChannel> channels;
    Eigen::VectorXd measured;            // all rows
    double speed = 0;                    // m/s, at the start, as measured
    std::optional<InputGap> gap = {};    // the first
    double until = kInfinity;            // s: what comes later says nothing about the car
    double until_reference = kInfinity;  // s: the same, of its reference; `until` is not later
    int runs = 1;  // of a car, whose noise and disturbances the rows hold: 2 when a reference is taken off

    Eigen::Index rows() const { return measured.size(); }
    double duration() const { return time.back(); }
    bool compared() const { return runs > 1; }
};
using Drives = std::span<const RecordedDrive>;

// Whether every drive has a reference.
bool compared(Drives drives);

// The first drive of which this is a repeat: the model answers to both alike.
std::size_t firstLike(Drives drives, std::size_t drive);

inline constexpr double kBlock = 0.05;  // s

// Whether a file that names its channels names this one.
bool wanted(const DiagnosisFile& file, const std::string& channel);

// Channels that a diagnosis can use, of those that the log has.
RecordedDrive recordedDrive(const Recording& recording, const Log& log, const DiagnosisFile& file);

// Readings over the samples of a drive -> rows of one channel (D1).
Eigen::VectorXd blockMeans(const ObservedChannel& channel, const std::vector<double>& time,
                           const std::vector<double>& readings);

}  // namespace tread::recording
