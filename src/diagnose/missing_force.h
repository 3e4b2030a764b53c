// The force that a model lacks, read off the measured motion.
#pragma once

#include <map>
#include <string>

#include "diagnose/study.h"

namespace tread {

struct MissingForce {
    std::map<std::string, double> shares;  // of each kind, in squares of its usual size; sum 1
    std::string when;                      // it acts most
};

// By the posterior of disturbances so large that they, rather than the parameters, explain what a fit leaves: the
// nuisances give back what they took over in the force's place. What noise and usual disturbances alone would show does
// not count.
MissingForce missingForce(const Study& study, const Fit& fit);

}  // namespace tread
