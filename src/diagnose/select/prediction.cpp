#include "diagnose/select/prediction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/select/doubt.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

using inference::factorOfPriorAnd;
using inference::logDeterminant;

// What drives tell of the effects of a fit: information about a step from its point, that of the prior included, and
// gradient. The nuisances are marginalised.
struct Learnt {
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
};

Learnt learnt(const Fit& fit, const Eigen::MatrixXd& products) {
    const Eigen::Index n = fit.nuisances(), k = std::ssize(fit.knobs);
    const Eigen::VectorXd at = fit.at(fit.free), gradient = products.col(n + k).head(n + k) - at;
    const Eigen::MatrixXd mixed = products.block(0, n, n, k);
    const Eigen::MatrixXd imitated = factorOfPriorAnd(products.topLeftCorner(n, n)).solve(mixed);
    return {Eigen::MatrixXd::Identity(k, k) + products.block(n, n, k, k) - mixed.transpose() * imitated,
            gradient.tail(k) - imitated.transpose() * gradient.head(n)};
}

// Logarithm of the density of a drive whose nuisances are as uncertain as before and whose effects are those that other
// drives tell.
double logDensity(const Fit& fit, const model::NormalEquations& drive, const Learnt& effects) {
    const Eigen::Index n = fit.nuisances(), k = std::ssize(fit.knobs);
    const Eigen::VectorXd nuisances = fit.at(fit.free).head(n);
    Eigen::MatrixXd information = drive.products.topLeftCorner(n + k, n + k);
    information.topLeftCorner(n, n).diagonal().array() += 1;
    information.bottomRightCorner(k, k) += effects.information;
    Eigen::VectorXd gradient = drive.products.col(n + k).head(n + k);
    gradient.head(n) -= nuisances, gradient.tail(k) += effects.gradient;
    const inference::Factor factor(information), told(effects.information);
    return 0.5 * (gradient.dot(factor.solve(gradient)) - effects.gradient.dot(told.solve(effects.gradient)) +
                  logDeterminant(told) - logDeterminant(factor) - nuisances.squaredNorm() -
                  drive.products(n + k, n + k) - drive.log_determinant);
}

std::vector<model::NormalEquations> ofEachDrive(const Calibration& car, const Fit& fit) {
    return model::equationsOfEach(car.uncertainty, fit.products, fit.sizes, car.problem.replays.threads);
}

// Logarithm of the density of all drives but one if their effects are those that this one tells.
double densityOfOthers(const Calibration& car, const Fit& fit, std::size_t teller) {
    const std::vector<model::NormalEquations> each = ofEachDrive(car, fit);
    model::NormalEquations others;
    for (std::size_t d = 0; d < each.size(); ++d)
        if (d != teller) others = std::move(others) + each[d];
    return logDensity(fit, others, learnt(fit, each[teller].products));
}

}  // namespace

std::vector<double> predictiveDensities(const Calibration& car, const Fit& fit) {
    const std::vector<model::NormalEquations> each = ofEachDrive(car, fit);
    const model::NormalEquations all = inference::sumOf(each);
    std::vector<double> densities;
    for (const model::NormalEquations& one : each)
        densities.push_back(logDensity(fit, one, learnt(fit, all.products - one.products)));
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
    if (gains.size() < 2) return result;
    const std::vector<double> explained = explainedIn(car, with, with.knobs);
    const auto most = std::max_element(explained.begin(), explained.end());
    const std::size_t teller = most - explained.begin();
    result.tested = !toldByOneDrive(explained);
    result.others = densityOfOthers(car, with, teller) - densityOfOthers(car, without, teller);
    result.sd = std::sqrt(n / (n - 1) * squares);
    return result;
}

bool Prediction::contradicts() const {
    return others < std::log(kSettings.false_alarm);
}

}  // namespace tread::diagnose::select
