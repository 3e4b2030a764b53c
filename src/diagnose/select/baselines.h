// What simpler methods would have answered to the same question, so that a score can show what the rest of a diagnosis
// is good for.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Dense>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// An effect as a linear model of so many numbers sees it: scalar products of its columns and then the residual.
struct LinearEffect {
    std::string name;
    Eigen::MatrixXd products;
    Eigen::VectorXd lowest, highest;  // of its numbers
};

// Twice the misfit that the best numbers within their bounds take away.
double reduction(const LinearEffect& effect);

// The effect that takes away most; "none" when that is not more than the count of its numbers.
std::string largestReduction(const std::vector<LinearEffect>& effects);

// The effect of the least Bayesian information criterion (G. Schwarz, Annals of Statistics 6, 1978) for so many rows,
// or "none" (D53).
std::string leastBic(const std::vector<LinearEffect>& effects, double rows);

// Of the nominal car's gap with nothing else free; and of the gap of the car with its tolerances free. The rows are
// taken as if nothing disturbed the drives: what is slow in their residuals counts row by row.
answer::Baselines baselines(const Calibration& car);

}  // namespace tread::diagnose::select
