// The force that the nominal car lacks, read off the measured motion.
#pragma once

#include <map>
#include <string>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::explain {

using select::Calibration;

struct MissingForce {
    std::map<std::string, double> shares;  // of each kind, sum 1; by how often and how clearly it acts
    std::map<std::string, double> axles;   // of the squared side force at `front` and `rear` that would do the same
    answer::Moment when;                   // it acts most
};

// By the posterior of disturbances so large that they, and not the parameters, explain what the nominal car does not.
// What noise, usual disturbances and tolerances would show by chance does not count.
MissingForce missingForce(const Calibration& car);

}  // namespace tread::diagnose::explain
