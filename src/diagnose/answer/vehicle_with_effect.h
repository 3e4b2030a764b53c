// The nominal car with the numbers that a diagnosis found, ready to run.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"
#include "recording/subject.h"

namespace tread::diagnose::answer {

// The subject with the fitted parameters of the causes; without a cause the nominal one.
recording::Subject withCauses(recording::Subject nominal, const Diagnosis& diagnosis);

// vehicle_with_effect.yaml: the car, headed by what was changed and by what is not the car's (road, wind, instruments).
std::string vehicleWithEffectYaml(const recording::Subject& nominal, const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
