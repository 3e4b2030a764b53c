#include "diagnose/select/doubt.h"

#include <algorithm>
#include <numeric>

namespace tread::diagnose::select {
namespace {

// Largest share of what is explained that one drive may hold, for the others to test it.
constexpr double kOneDrive = 0.9;

}  // namespace

std::vector<double> explainedIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    const Eigen::Index all = std::ssize(fit.free), n = std::ssize(knobs);
    std::vector<Eigen::Index> order(all);  // places in `free`: first those of the knobs
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(), [&](Eigen::Index i) {
        return std::find(knobs.begin(), knobs.end(), fit.free[i]) != knobs.end();
    });
    std::vector<Eigen::MatrixXd> each;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(all, all);
    for (const model::NormalEquations& one :
         model::equationsOfEach(car.uncertainty, fit.products, fit.sizes, car.problem.replays.threads)) {
        each.emplace_back(one.products(order, order));
        sum += each.back();
    }
    Eigen::VectorXd signature(all);  // of the knobs, less what the others imitate of it
    signature.head(n) = fit.at(fit.free)(order).head(n);
    signature.tail(all - n) = -inference::factorOfPriorAnd(sum.bottomRightCorner(all - n, all - n))
                                   .solve(sum.bottomLeftCorner(all - n, n) * signature.head(n));
    std::vector<double> explained;
    for (const Eigen::MatrixXd& one : each) explained.push_back(signature.dot(one * signature));
    return explained;
}

bool toldByOneDrive(const std::vector<double>& explained) {
    const double sum = std::accumulate(explained.begin(), explained.end(), 0.0);
    return *std::max_element(explained.begin(), explained.end()) >= kOneDrive * sum;
}

double doubt(const Calibration& car, const Fit& fit) {
    if (fit.knobs.empty()) return 1;
    double sum = 0, squares = 0;
    for (const double explained : explainedIn(car, fit, fit.knobs)) sum += explained, squares += explained * explained;
    return sum > 0 ? 1 + car.structure_error * car.structure_error * squares / sum : 1;
}

}  // namespace tread::diagnose::select
