// Where the model is driven: all recordings, with the car at any point of the space of parameters.
#pragma once

#include <Eigen/Dense>
#include <atomic>
#include <filesystem>
#include <optional>
#include <vector>

#include "diagnose/diagnosis.h"
#include "diagnose/drive.h"
#include "diagnose/parameter.h"

namespace tread {

using Deviation = Eigen::VectorXd;  // from the nominal car: one value per parameter, in its units

struct Bench {
    Subject nominal;
    double step = 0.002;  // s
    std::vector<RecordedDrive> drives;
    std::vector<Parameter> parameters;
    Simulate simulate;
    int threads = 0;
    std::filesystem::path cache;  // of the sensitivities of the nominal car; empty: none
    std::atomic<int> simulations{0};

    Deviation origin() const { return Deviation::Zero(static_cast<Eigen::Index>(parameters.size())); }
    Subject subjectAt(const Deviation& point) const;
    // Whether every drive has a reference.
    bool compared() const;
    // The first drive of which this is a repeat: their sensitivities are the same.
    std::size_t firstLike(std::size_t drive) const;
};

// What the car does in a drive, perhaps a little otherwise than it was driven; nothing when the simulation breaks down.
struct Otherwise {
    double faster = 0;     // m/s, at the start
    Pushing pushing = {};  // over the time of the drive
};
std::optional<Log> motionAt(Bench& bench, std::size_t drive, const Subject& subject, const Otherwise& otherwise = {});

// All rows of each drive; nothing when one of them cannot be driven.
using Rows = std::vector<Eigen::VectorXd>;
std::optional<Rows> rowsAt(Bench& bench, const Deviation& point);

// The drives about a point: what is observed there, and how it changes with one unit of each parameter. Columns of
// parameters that were not asked for are zero.
struct Linearised {
    Deviation at;
    Rows rows;
    std::vector<Eigen::MatrixXd> columns;  // per drive: rows x parameters
};
// Which columns are asked for, and in which drives they are worth driving (empty: in all); the others stay those of
// `elsewhere`, or zero.
struct Wanted {
    std::vector<Eigen::Index> parameters;
    double step = 0.6;  // of the differences, in units: small against what bends the response, large against what jumps
    std::vector<std::vector<bool>> worth = {};  // per parameter asked for, per drive
    const Linearised* elsewhere = nullptr;
};
Linearised linearised(
    Bench& bench, const Deviation& at, const Wanted& wanted,
    const std::function<void(double)>& progress = [](double) {});

// How the rows of a drive of the subject change with the speed at its start, s.
Eigen::VectorXd startSpeedColumn(Bench& bench, std::size_t drive, const Subject& subject, const Eigen::VectorXd& rows);

}  // namespace tread
