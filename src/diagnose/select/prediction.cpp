#include "diagnose/select/prediction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/select/doubt.h"

namespace tread::diagnose::select {
namespace {

// Largest share of the information about the effects that one drive may hold, for the others to test them.
constexpr double kOneDrive = 0.9;

double logEvidenceOf(const Fit& fit, const model::NormalEquations& sum) {
    const Eigen::Index n = std::ssize(fit.free);
    const inference::QuadraticModel model{.information = sum.products.topLeftCorner(n, n),
                                          .gradient = sum.products.topRightCorner(n, 1),
                                          .at = fit.at(fit.free),
                                          .squared_residual = sum.products(n, n),
                                          .log_determinant = sum.log_determinant};
    return inference::logEvidence(model, inference::bestStep(model));
}

// Share of the drive that tells most about the effects.
double largestShare(const Calibration& car, const Fit& fit) {
    const std::vector<double> explained = explainedIn(car, fit);
    const double sum = std::accumulate(explained.begin(), explained.end(), 0.0);
    return sum > 0 ? *std::max_element(explained.begin(), explained.end()) / sum : 1;
}

}  // namespace

std::vector<double> predictiveDensities(const Calibration& car, const Fit& fit) {
    std::vector<model::NormalEquations> each;
    model::NormalEquations all;
    for (std::size_t d = 0; d < fit.products.size(); ++d) {
        each.push_back(model::normalEquations(car.uncertainty, d, fit.products[d], fit.sizes));
        all = std::move(all) + each.back();
    }
    const double together = logEvidenceOf(fit, all);
    std::vector<double> densities;
    for (const model::NormalEquations& one : each) {
        model::NormalEquations others = all;
        others.products -= one.products;
        others.log_determinant -= one.log_determinant;
        densities.push_back(together - logEvidenceOf(fit, others));
    }
    return densities;
}

Prediction predicted(const Calibration& car, const Fit& with, const Fit& without) {
    std::vector<double> gains = predictiveDensities(car, with);
    const std::vector<double> before = predictiveDensities(car, without);
    for (std::size_t d = 0; d < gains.size(); ++d) gains[d] -= before[d];
    const auto n = static_cast<double>(gains.size());
    Prediction result{.gain = std::accumulate(gains.begin(), gains.end(), 0.0)};
    double squares = 0;
    for (const double gain : gains) squares += std::pow(gain - result.gain / n, 2);
    result.tested = gains.size() > 1 && largestShare(car, with) < kOneDrive;
    result.sd = n > 1 ? std::sqrt(n / (n - 1) * squares) : 0;
    return result;
}

}  // namespace tread::diagnose::select
