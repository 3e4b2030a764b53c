// What is observed in the drives about a point, and how it changes with each parameter: by finite differences.
#pragma once

#include <functional>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Steps of the differences, in units: small against what bends the response, large against what jumps. Effects take
// smaller ones, for their typical sizes are large.
inline constexpr double kNuisanceStep = 0.6, kEffectStep = 0.3;

struct Sensitivities {
    Deviation at;
    Rows rows;
    std::vector<Eigen::MatrixXd> columns;  // per drive: rows x parameters; zero where a parameter was not asked for
};

// Which columns are asked for, and in which drives they are worth driving (empty: in all); the others stay those of
// `elsewhere`, or zero.
struct Wanted {
    std::vector<Eigen::Index> parameters;
    double step = kNuisanceStep;
    std::vector<std::vector<bool>> worth = {};  // per parameter asked for, per drive
    const Sensitivities* elsewhere = nullptr;
};

// Those of the nominal car are kept in the cache of the replays.
Sensitivities sensitivities(
    const Replays& replays, Drives drives, const Deviation& at, const Wanted& wanted,
    const std::function<void(double)>& progress = [](double) {});

// How the rows of a drive of the subject change with the speed at its start, s.
Eigen::VectorXd startSpeedColumn(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                                 const Eigen::VectorXd& rows);

}  // namespace tread::diagnose::model
