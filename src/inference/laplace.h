// Evidence of a model whose parameters have the prior N(0, I), by Laplace's method: exact where the model is linear
// (D. J. C. MacKay, Information Theory, Inference, and Learning Algorithms, 2003, ch. 27 and 28).
#pragma once

#include <Eigen/Dense>

namespace tread::inference {

using Factor = Eigen::LLT<Eigen::MatrixXd>;

// Cholesky factor of I + information: of the posterior's Hessian.
Factor factorOfPriorAnd(const Eigen::MatrixXd& information);

double logDeterminant(const Factor& factor);

// The quadratic model of the log posterior about a point.
struct QuadraticModel {
    Eigen::MatrixXd information;  // J'J in the metric of noise and disturbances
    Eigen::VectorXd gradient;     // J'r
    Eigen::VectorXd at;           // the point, in standard deviations of the prior
    double squared_residual = 0;  // r'r in that metric
    double log_determinant = 0;   // of that metric
};

// What a step from the point adds to the log posterior; the gradient of the prior is included (D22).
double gainOf(const QuadraticModel& model, const Eigen::VectorXd& step);

// The step to the largest posterior, without bounds.
Eigen::VectorXd bestStep(const QuadraticModel& model);

// Logarithm of the evidence, without the constant -rows/2 log(2 pi), when the posterior is largest at the point plus
// `step`; bounds may hold that step short (D23), (D25).
double logEvidence(const QuadraticModel& model, const Eigen::VectorXd& step);

}  // namespace tread::inference
