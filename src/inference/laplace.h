// Evidence of a model whose parameters have the prior N(0, I), by Laplace's method. Exact for a linear model without
// bounds (D. J. C. MacKay, Information Theory, Inference, and Learning Algorithms, 2003, ch. 27 and 28).
#pragma once

#include <Eigen/Dense>

#include "inference/normal_equations.h"

namespace tread::inference {

// Cholesky factor of I + information, the Hessian of the negative log posterior.
Factor factorOfPriorAnd(const Eigen::MatrixXd& information);

double logDeterminant(const Factor& factor);

// Quadratic model of the log posterior about a point.
struct QuadraticModel {
    Eigen::MatrixXd information;  // J'J in the metric of noise and disturbances
    Eigen::VectorXd gradient;     // J'r in that metric
    Eigen::VectorXd at;           // the point, in standard deviations of the prior
    double squared_residual = 0;  // r'r in that metric
    double log_determinant = 0;   // of the covariance of noise and disturbances, the inverse of that metric
};

// The same of normal equations whose last column is the residual.
QuadraticModel quadraticModel(const NormalEquations& equations, Eigen::VectorXd at);

// Change of the log posterior by a step from the point, gradient of the prior included (D22).
double gainOf(const QuadraticModel& model, const Eigen::VectorXd& step);

// Step to the maximum of the posterior, without bounds.
Eigen::VectorXd bestStep(const QuadraticModel& model);

// Logarithm of the evidence, without the constant -rows/2 log(2 pi), if the posterior is largest at the point plus
// `step`. Bounds may shorten the step (D23), (D25).
double logEvidence(const QuadraticModel& model, const Eigen::VectorXd& step);

}  // namespace tread::inference
