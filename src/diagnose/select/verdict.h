// From probabilities to a verdict.
#pragma once

#include "diagnose/select/posterior.h"
#include "diagnose/select/unknown_cause.h"

namespace tread::diagnose::select {

// Fills verdict, causes, alternatives, effects, probabilities, expected evidence, credible set and constancy.
void judge(answer::Diagnosis& diagnosis, const Calibration& car, const std::vector<double>& expected_evidence,
           const Search& found, const UnknownCause& unknown);

}  // namespace tread::diagnose::select
