// Groups of numbers that are drawn together.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_file.h"

namespace tread::campaign {

struct JointNormal {
    std::vector<std::string> paths;
    std::vector<double> mean;  // none: nominal values
    std::vector<std::vector<double>> covariance;
};

// The numbers of a group, read from identify.json when it names one. Throws LoadError.
JointNormal jointNormal(const Correlated& group);

// The symmetric square root of a covariance. Nothing, and what is wrong in `fault`, when the matrix is no covariance.
std::vector<std::vector<double>> rootOf(const std::vector<std::vector<double>>& covariance, std::string& fault);

}  // namespace tread::campaign
