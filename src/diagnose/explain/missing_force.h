// Estimate of the force that the nominal car lacks, from the measured motion.
#pragma once

#include <map>
#include <string>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::explain {

using select::Calibration;

struct MissingForce {
    std::map<std::string, double> shares;  // by kind, sum 1: how often and how clearly it acts
    std::map<std::string, double> axles;   // by axle: shares of the squared side force that has the same effect
    answer::Moment when;                   // moment at which it acts most
};

// Uses the posterior of disturbances that are taken to be so large that they, and not the parameters, explain the gap
// of the nominal car. Values that noise, usual disturbances and tolerances could produce by chance do not count.
MissingForce missingForce(const Calibration& car);

}  // namespace tread::diagnose::explain
