// Rows of the drives at a point of the parameter space, and their sensitivity to each parameter by finite differences.
#pragma once

#include <functional>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Steps of the differences, in units: small against the curvature of the response, large against its jumps. The step of
// effects is smaller because their typical sizes are large.
inline constexpr double kNuisanceStep = 0.6, kEffectStep = 0.3;

struct Sensitivities {
    Deviation at;
    Rows rows;
    std::vector<Eigen::MatrixXd> columns;  // per drive: rows x parameters; zero for parameters not asked for
};

// Parameters whose columns are computed, and the drives in which each is worth computing (empty: all drives). Other
// columns are taken from `elsewhere`, or are zero.
struct Wanted {
    std::vector<Eigen::Index> parameters;
    double step = kNuisanceStep;
    std::vector<std::vector<bool>> worth = {};  // per parameter asked for, per drive
    const Sensitivities* elsewhere = nullptr;
    const Rows* rows = nullptr;  // of the model at the point, where they are known
};

// `worth` with the same drives for each of this many parameters.
std::vector<std::vector<bool>> onlyIn(const std::vector<bool>& drives, std::size_t parameters);

// Columns are differences between coarse replays, or between usual ones in drives where a coarse one fails.
// Those about the nominal car are kept in the cache of the replays.
Sensitivities sensitivities(
    const Replays& replays, Drives drives, const Deviation& at, const Wanted& wanted,
    const std::function<void(double)>& progress = [](double) {});

// The columns of these parameters alone, in this order, per drive.
std::vector<Eigen::MatrixXd> columnsAt(const Replays& replays, Drives drives, const Deviation& at,
                                       const std::vector<Eigen::Index>& parameters, double step);

// m/s: standard deviation of the start speed, which is estimated by a line through the first speeds, and step of the
// finite difference for its sensitivity. It decides no verdict: half and double change none of the development cases.
inline constexpr double kStartSpeedStep = 0.1;

// A replay of a drive by a subject, from which differences are taken.
struct Base {
    Subject subject;
    std::optional<Log> motion = {};  // nothing when the simulation fails
    Eigen::VectorXd rows = {};
    bool coarse = true;  // whether replays that are compared with it are coarse
};
Base baseOf(const Replays& replays, const RecordedDrive& drive, Subject subject);

// Change of the rows of a drive per m/s of start speed.
Eigen::VectorXd startSpeedColumn(const Replays& replays, const RecordedDrive& drive, const Base& base);

}  // namespace tread::diagnose::model
