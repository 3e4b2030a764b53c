// Answers of simpler methods to the same question, for comparison with the full diagnosis.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Dense>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {

// An effect in a linear model: scalar products of its columns, then the residual.
struct LinearEffect {
    std::string name;
    Eigen::MatrixXd products;
    inference::Bounds bounds;  // of its parameters, relative to the point of the linearisation
};

// Reduction of the squared residual by the best parameters, cut at their bounds.
double reduction(const LinearEffect& effect);

// The effect with the largest reduction; "none" when that is not larger than its number of parameters.
std::string largestReduction(const std::vector<LinearEffect>& effects);

// The effect with the least Bayesian information criterion (G. Schwarz, Annals of Statistics 6, 1978) for this number
// of rows, or "none" (D53).
std::string leastBic(const std::vector<LinearEffect>& effects, double rows);

// The largest reduction is that of the nominal car's gap with nothing else free. The criterion is that of the
// calibrated car's gap with the tolerances free. Both ignore disturbances, so slow residuals count as if their rows
// were independent.
answer::Baselines baselines(const Calibration& car);

}  // namespace tread::diagnose::select
