// Replays of the recorded drives by the model, at any point of the parameter space.
#pragma once

#include <Eigen/Dense>
#include <atomic>
#include <filesystem>
#include <optional>
#include <vector>

#include "diagnose/model/parameter.h"
#include "recording/replay.h"

namespace tread::diagnose::model {

using Deviation = Eigen::VectorXd;          // from the nominal car: one value per parameter, in its units
using Rows = std::vector<Eigen::VectorXd>;  // one vector per drive

// Counter that several threads may increase. A copy starts from the value at the time of copying.
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
    mutable std::atomic<int> value_{0};  // mutable: counting simulations does not change the model
};

struct Replays {
    recording::Replayer replayer;
    std::vector<Parameter> parameters;
    int threads = 0;              // 0: one per core
    std::filesystem::path cache;  // folder for the sensitivities of the nominal car; empty: none
    Count simulations;

    const Subject& nominal() const { return replayer.nominal; }
    Deviation origin() const { return Deviation::Zero(std::ssize(parameters)); }
    Subject subjectAt(const Deviation& point, const RecordedDrive& drive) const;
};

// How a replay differs from the recorded drive.
struct Variation {
    double faster = 0;     // m/s, added to the start speed (recording::Replayer::faster)
    Pushing pushing = {};  // external forces over the time of the drive
    bool coarse = false;   // with twice the time step, at most 0.01 s: for differences, in which its error cancels
};

// Motion of the subject in a drive; nothing when the simulation fails.
std::optional<Log> motionAt(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                            const Variation& variation = {});

// Change of the rows that a drive's reference contributes when numbers of both cars move to this point. Empty when none
// moves or the drive has no reference; nothing when the reference cannot be driven (D45c).
std::optional<Eigen::VectorXd> changeByReference(const Replays& replays, const RecordedDrive& drive,
                                                 const Deviation& point);

// Rows of a drive; nothing when it cannot be driven.
std::optional<Eigen::VectorXd> rowsOf(const Replays& replays, const RecordedDrive& drive, const Deviation& point);

// All rows of each drive; nothing when one of them cannot be driven.
std::optional<Rows> rowsAt(const Replays& replays, Drives drives, const Deviation& point);
// The same at several points at once.
std::vector<std::optional<Rows>> rowsAt(const Replays& replays, Drives drives, const std::vector<Deviation>& points);

}  // namespace tread::diagnose::model
