#include "inference/laplace.h"

#include <utility>

namespace tread::inference {

Factor factorOfPriorAnd(const Eigen::MatrixXd& information) {
    return Factor(Eigen::MatrixXd::Identity(information.rows(), information.cols()) + information);
}

double logDeterminant(const Factor& factor) {
    return 2 * factor.lower().diagonal().array().log().sum();
}

QuadraticModel quadraticModel(const NormalEquations& equations, Eigen::VectorXd at) {
    const Index n = at.size();
    return {.information = equations.products.topLeftCorner(n, n),
            .gradient = equations.products.topRightCorner(n, 1),
            .at = std::move(at),
            .squared_residual = equations.products(n, n),
            .log_determinant = equations.log_determinant};
}

double gainOf(const QuadraticModel& model, const Eigen::VectorXd& step) {
    return step.dot(model.gradient - model.at) - 0.5 * (step.squaredNorm() + step.dot(model.information * step));
}

Eigen::VectorXd bestStep(const QuadraticModel& model) {
    return factorOfPriorAnd(model.information).solve(model.gradient - model.at);
}

double logEvidence(const QuadraticModel& model, const Eigen::VectorXd& step) {
    const double misfit = 0.5 * (model.squared_residual + model.at.squaredNorm()) - gainOf(model, step);
    return -misfit - 0.5 * (model.log_determinant + logDeterminant(factorOfPriorAnd(model.information)));
}

}  // namespace tread::inference
