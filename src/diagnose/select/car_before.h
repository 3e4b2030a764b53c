// The car before it was changed: the nominal car fitted to the references. Effects are sought about this car.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/model/problem.h"

namespace tread::diagnose::select {

struct CarBefore {
    model::Subject car;
    std::map<std::string, answer::NuisanceEstimate> moved;  // numbers of the nominal car that the fit moved
    answer::GapLevels gap;                                  // in the drives of the car before: nominal, and fitted
    double structure_error = 0;  // share of its motion that its other drives do not predict (D45b)
    // How well its numbers are known (D45d); in drives from which no reference is subtracted, as the fit leaves them,
    // and as a car differs from itself on another day (D45a).
    std::vector<recording::KnownWithin> tolerances;
    // Numbers of the tyres that its drives do not determine: what they are shows when the changed car slides.
    std::vector<recording::KnownWithin> left_open = {};
};

// Tolerances of the file, and others in their place for the fitted numbers. A number that the fit moved beyond its
// uncertainty stands for something that the model lacks: its tolerance is this distance (D45d). In drives from which
// nothing is subtracted: what the fit leaves open, and the share of the tolerance that changes from day to day (D45a).
std::vector<recording::KnownWithin> tolerancesAfter(const model::Subject& nominal, const recording::DiagnosisFile& file,
                                                    const std::map<std::string, answer::NuisanceEstimate>& moved);

// Frees all uncertain numbers. Those that no data sheet tells are as uncertain as the catalogue says: the typical sizes
// of the effects that move them. Nothing when the file has neither references nor other drives of the car before.
std::optional<CarBefore> carBefore(const model::Subject& nominal, const recording::DiagnosisFile& file,
                                   const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                                   const Options& options, const Progress& progress);

}  // namespace tread::diagnose::select
