#include "diagnose/select/doubt.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tread::diagnose::select {
namespace {

// Largest share of what is explained that one drive may hold, for the others to test it.
constexpr double kOneDrive = 0.9;

// Steps of the correlation between the errors of channels.
constexpr int kCorrelations = 20;

// Places of the free parameters of a fit: first those of some knobs, then the others.
std::vector<Eigen::Index> knobsFirst(const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    std::vector<Eigen::Index> places(fit.free.size());
    std::iota(places.begin(), places.end(), 0);
    std::stable_partition(places.begin(), places.end(), [&](Eigen::Index i) {
        return std::find(knobs.begin(), knobs.end(), fit.free[i]) != knobs.end();
    });
    return places;
}

// Difference of two models in a channel of a drive, squared, and the variance of the error of a signature there.
struct ChannelError {
    double square, error;
};

// Squared difference in a drive that is left over errors which have the same correlation in all pairs of channels.
double believedWith(double correlation, const std::vector<ChannelError>& channels) {
    double alone = 0, along = 0, common = 0;
    for (const ChannelError& one : channels) {
        const double variance = 1 + (1 - correlation) * one.error;
        alone += one.square / variance;
        along += std::sqrt(correlation * one.error * one.square) / variance;
        common += correlation * one.error / variance;
    }
    return alone - along * along / (1 + common);
}

// The same with the correlation that leaves the least.
double leastBelieved(const std::vector<ChannelError>& channels) {
    double least = believedWith(0, channels);
    for (int i = 1; i <= kCorrelations; ++i)
        least = std::min(least, believedWith(static_cast<double>(i) / kCorrelations, channels));
    return least;
}

}  // namespace

std::vector<double> explainedIn(const Calibration& car, const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    const std::vector<Eigen::Index> order = knobsFirst(fit, knobs);
    const Eigen::Index all = std::ssize(order), n = std::ssize(knobs);
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

std::vector<Eigen::VectorXd> changedByEffects(const Fit& fit) {
    const Eigen::VectorXd sizes = fit.at(fit.knobs);
    std::vector<Eigen::VectorXd> changed;
    for (const Eigen::MatrixXd& columns : fit.columns) changed.emplace_back(columns.rightCols(sizes.size()) * sizes);
    return changed;
}

double doubtAlong(const Calibration& car, const model::ChannelSquares& squares, const Fit& fit,
                  const std::vector<Eigen::VectorXd>& off) {
    if (fit.knobs.empty()) return 1;
    const std::vector<Eigen::VectorXd> by_effects = changedByEffects(fit);
    double differing = 0, believed = 0;
    for (std::size_t d = 0; d < off.size(); ++d) {
        const std::vector<double> changed = squares.in(d, by_effects[d]);
        const std::vector<double> between = squares.in(d, off[d]);
        std::vector<ChannelError> channels;
        for (std::size_t c = 0; c < changed.size(); ++c) {
            const double error = car.structure_error * car.structure_error * std::max(0.0, changed[c]);
            channels.push_back({std::max(0.0, between[c]), error});
            differing += channels.back().square;
        }
        believed += leastBelieved(channels);
    }
    return believed > 0 ? differing / believed : 1;
}

double doubt(const Calibration& car, const model::ChannelSquares& squares, const Fit& fit, const Rows& rival) {
    std::vector<Eigen::VectorXd> off;
    for (std::size_t d = 0; d < rival.size(); ++d)
        off.emplace_back(car.uncertainty.noise[d].over(rival[d] - fit.rows[d]));
    return doubtAlong(car, squares, fit, off);
}

}  // namespace tread::diagnose::select
