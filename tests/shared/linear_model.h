// Parts of normal equations as a test asks for them.
#pragma once

#include <vector>

#include "diagnose/select/posterior.h"
#include "inference/laplace.h"
#include "inference/normal_equations.h"

namespace tread::linear_model {

// The log diagnose::select::posterior of some of the columns about zero; `residual` is the column that they are to
// explain.
inline inference::QuadraticModel quadraticOf(const inference::NormalEquations& equations, inference::Index residual,
                                             const std::vector<inference::Index>& free) {
    return {.information = equations.products(free, free),
            .gradient = equations.products(free, residual),
            .at = Eigen::VectorXd::Zero(std::ssize(free)),
            .squared_residual = equations.products(residual, residual),
            .log_determinant = equations.log_determinant};
}

// Evidence of the model that has these columns free, without bounds.
inline double logEvidence(const inference::NormalEquations& equations, inference::Index residual,
                          const std::vector<inference::Index>& free) {
    const inference::QuadraticModel model = quadraticOf(equations, residual, free);
    return inference::logEvidence(model, inference::bestStep(model));
}

}  // namespace tread::linear_model
