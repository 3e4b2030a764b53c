#include "diagnose/select/doubt.h"

namespace tread::diagnose::select {

std::vector<double> explainedIn(const Calibration& car, const Fit& fit) {
    const Eigen::Index nuisances = fit.nuisances(), all = std::ssize(fit.free);
    std::vector<Eigen::MatrixXd> each;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(all, all);
    for (std::size_t d = 0; d < fit.products.size(); ++d) {
        each.push_back(model::normalEquations(car.uncertainty, d, fit.products[d], fit.sizes).products);
        sum += each.back().topLeftCorner(all, all);
    }
    Eigen::VectorXd signature(all);  // of the effects, less what the nuisances imitate of it
    signature.tail(all - nuisances) = fit.at(fit.knobs);
    signature.head(nuisances) = -inference::factorOfPriorAnd(sum.topLeftCorner(nuisances, nuisances))
                                     .solve(sum.topRightCorner(nuisances, all - nuisances) * fit.at(fit.knobs));
    std::vector<double> explained;
    for (const Eigen::MatrixXd& one : each) explained.push_back(signature.dot(one.topLeftCorner(all, all) * signature));
    return explained;
}

double doubt(const Calibration& car, const Fit& fit) {
    if (fit.knobs.empty()) return 1;
    double sum = 0, squares = 0;
    for (const double explained : explainedIn(car, fit)) sum += explained, squares += explained * explained;
    return sum > 0 ? 1 + car.structure_error * car.structure_error * squares / sum : 1;
}

}  // namespace tread::diagnose::select
