#include "diagnose/select/doubt.h"

#include <algorithm>
#include <cmath>

namespace tread::diagnose::select {
namespace {

// Largest share of what is explained that one drive may hold, for the others to test it.
constexpr double kOneDrive = 0.9;

// Places of some knobs among the free parameters of a fit.
std::vector<Eigen::Index> placesInFit(const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    std::vector<Eigen::Index> places;
    for (Eigen::Index i = 0; i < std::ssize(fit.free); ++i) {
        if (std::find(knobs.begin(), knobs.end(), fit.free[i]) != knobs.end()) places.push_back(i);
    }
    return places;
}

}  // namespace

std::vector<double> explainedIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    const Eigen::Index all = std::ssize(fit.free), n = std::ssize(knobs);
    std::vector<Eigen::Index> order = placesInFit(fit, knobs);  // then the others
    for (Eigen::Index i = 0; i < all; ++i)
        if (std::find(order.begin(), order.begin() + n, i) == order.begin() + n) order.push_back(i);
    std::vector<Eigen::MatrixXd> each;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(all, all);
    for (const model::NormalEquations& one :
         model::equationsOfEach(car.uncertainty, fit.products, fit.sizes, car.problem.replays.threads)) {
        each.emplace_back(one.products(order, order));
        sum += each.back();
    }
    Eigen::VectorXd own = fit.at(fit.free)(order);
    own.tail(all - n) = -inference::factorOfPriorAnd(sum.bottomRightCorner(all - n, all - n))
                             .solve(sum.bottomLeftCorner(all - n, n) * own.head(n));
    std::vector<double> explained;
    for (const Eigen::MatrixXd& one : each) explained.push_back(own.dot(one * own));
    return explained;
}

bool toldByOneDrive(const std::vector<double>& explained) {
    const double sum = std::accumulate(explained.begin(), explained.end(), 0.0);
    return *std::max_element(explained.begin(), explained.end()) >= kOneDrive * sum;
}

double doubt(const Calibration& car, const model::ChannelSquares& squares, const Fit& fit, const Rows& rival) {
    const std::vector<Eigen::Index> places = placesInFit(fit, fit.knobs);
    if (places.empty()) return 1;
    const Eigen::VectorXd sizes = fit.at(fit.free)(places);
    double differing = 0, aligned = 0;
    for (std::size_t d = 0; d < rival.size(); ++d) {
        const std::vector<double> changed = squares.in(d, fit.columns[d](Eigen::all, places) * sizes);
        const std::vector<double> between = squares.in(d, car.uncertainty.noise[d].over(rival[d] - fit.rows[d]));
        double along = 0;
        for (std::size_t c = 0; c < changed.size(); ++c) {
            const double off = std::max(0.0, between[c]);
            differing += off, along += std::sqrt(off * std::max(0.0, changed[c]));
        }
        aligned += along * along;
    }
    return differing > 0 ? 1 + car.structure_error * car.structure_error * aligned / differing : 1;
}

}  // namespace tread::diagnose::select
