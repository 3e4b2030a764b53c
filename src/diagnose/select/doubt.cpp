#include "diagnose/select/doubt.h"

#include <algorithm>
#include <numeric>

namespace tread::diagnose::select {
namespace {

// Largest share of what is explained that one drive may hold, for the others to test it.
constexpr double kOneDrive = 0.9;

// Squared signature of some knobs in a drive: the whole, and the part that no other parameter can imitate.
struct Signature {
    double whole = 0, own = 0;
};

std::vector<Signature> signaturesIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs) {
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
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(all);
    whole.head(n) = fit.at(fit.free)(order).head(n);
    Eigen::VectorXd own = whole;  // less what the others imitate of it
    own.tail(all - n) = -inference::factorOfPriorAnd(sum.bottomRightCorner(all - n, all - n))
                             .solve(sum.bottomLeftCorner(all - n, n) * whole.head(n));
    std::vector<Signature> signatures;
    for (const Eigen::MatrixXd& one : each) signatures.push_back({whole.dot(one * whole), own.dot(one * own)});
    return signatures;
}

}  // namespace

std::vector<double> explainedIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    std::vector<double> explained;
    for (const Signature& one : signaturesIn(car, fit, knobs)) explained.push_back(one.own);
    return explained;
}

bool toldByOneDrive(const std::vector<double>& explained) {
    const double sum = std::accumulate(explained.begin(), explained.end(), 0.0);
    return *std::max_element(explained.begin(), explained.end()) >= kOneDrive * sum;
}

double doubt(const Calibration& car, const Fit& fit) {
    if (fit.knobs.empty()) return 1;
    double own = 0, weighted = 0;
    for (const Signature& one : signaturesIn(car, fit, fit.knobs)) own += one.own, weighted += one.own * one.whole;
    return own > 0 ? 1 + car.structure_error * car.structure_error * weighted / own : 1;
}

}  // namespace tread::diagnose::select
