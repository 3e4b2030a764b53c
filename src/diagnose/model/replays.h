// The model's replays: the recorded drives, repeated by the car at any point of the space of parameters.
#pragma once

#include <Eigen/Dense>
#include <atomic>
#include <filesystem>
#include <optional>
#include <vector>

#include "diagnose/model/parameter.h"
#include "recording/replay.h"

namespace tread::diagnose::model {

using recording::Drives;
using recording::RecordedDrive;

using Deviation = Eigen::VectorXd;          // from the nominal car: one value per parameter, in its units
using Rows = std::vector<Eigen::VectorXd>;  // of each drive

// Counts from several threads; a copy goes on from where it was made.
class Count {
public:
    Count() = default;
    Count(const Count& other) : value_(other.value_.load()) {}
    Count& operator=(const Count& other) {
        value_ = other.value_.load();
        return *this;
    }
    void add(int more = 1) const { value_ += more; }
    int value() const { return value_; }

private:
    mutable std::atomic<int> value_{0};  // no part of what a model is
};

struct Replays {
    recording::Replayer replayer;
    std::vector<Parameter> parameters;
    int threads = 0;              // 0: one per core
    std::filesystem::path cache;  // of the sensitivities of the nominal car; empty: none
    Count simulations;

    const Subject& nominal() const { return replayer.nominal; }
    Deviation origin() const { return Deviation::Zero(std::ssize(parameters)); }
    Subject subjectAt(const Deviation& point) const;
};

// How a drive is repeated otherwise than it was driven.
struct Variation {
    double faster = 0;     // m/s, at the start
    Pushing pushing = {};  // over the time of the drive
};

// What the subject does in a drive; nothing when the simulation breaks down.
std::optional<Log> motionAt(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                            const Variation& variation = {});

// All rows of each drive; nothing when one of them cannot be driven.
std::optional<Rows> rowsAt(const Replays& replays, Drives drives, const Deviation& point);

}  // namespace tread::diagnose::model
