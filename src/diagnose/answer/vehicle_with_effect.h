// The nominal car with the parameters that a diagnosis found, ready to run.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"
#include "recording/subject.h"

namespace tread::diagnose::answer {

// The subject with the fitted parameters of the causes, beside those of the car before the change if that was fitted to
// its drives: the effects were found about this car. Unchanged when there is neither.
recording::Subject withCauses(recording::Subject nominal, const Diagnosis& diagnosis);

// Text of vehicle_with_effect.yaml: the car, below a comment that lists the changed numbers and those that do not
// belong to the car (road, wind, instruments).
std::string vehicleWithEffectYaml(const recording::Subject& nominal, const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
