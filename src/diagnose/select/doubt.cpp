#include "diagnose/select/doubt.h"

#include "diagnose/settings.h"

namespace tread::diagnose::select {

double doubt(const Calibration& car, const Fit& fit) {
    if (fit.knobs.empty()) return 1;
    const Eigen::Index first = fit.nuisances(), knobs = std::ssize(fit.knobs);
    const Eigen::VectorXd value = fit.at(fit.knobs);
    double sum = 0, squares = 0;
    for (std::size_t d = 0; d < fit.products.size(); ++d) {
        const Eigen::MatrixXd one = model::normalEquations(car.uncertainty, d, fit.products[d], fit.sizes).products;
        const double explained = value.dot(one.block(first, first, knobs, knobs) * value);
        sum += explained, squares += explained * explained;
    }
    const double error = kSettings.signature_error;
    return sum > 0 ? 1 + error * error * squares / sum : 1;
}

}  // namespace tread::diagnose::select
