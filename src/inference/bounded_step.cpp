#include "inference/bounded_step.h"

#include <cmath>
#include <vector>

namespace tread::inference {
namespace {

using Eigen::Index;

constexpr Index kMostChanges = 5;  // changes of the active set, per parameter: a limit against cycling
constexpr double kNoPull = 1e-9;   // gradient at a bound, below which a parameter is not released

// Indices of the parameters that are not held at a bound.
std::vector<Index> openOf(const std::vector<bool>& held) {
    std::vector<Index> open;
    for (Index i = 0; i < std::ssize(held); ++i)
        if (!held[i]) open.push_back(i);
    return open;
}

// The first bound that a further step meets, and the share of the step up to it. Parameter -1: the step meets none.
struct Meeting {
    Index parameter = -1;
    double share = 1;
};
Meeting firstMeeting(const std::vector<Index>& open, const Eigen::VectorXd& further, const Eigen::VectorXd& step,
                     const Eigen::VectorXd& down, const Eigen::VectorXd& up) {
    Meeting first;
    for (Index k = 0; k < std::ssize(open); ++k) {
        const Index i = open[k];
        const double by = further(k), room = by > 0 ? up(i) - step(i) : down(i) - step(i);
        if (by != 0 && std::abs(by) * first.share > std::abs(room)) first = {i, room / by};
    }
    return first;
}

// The held parameter with the largest gradient away from its bound; -1: none.
Index mostHindered(const std::vector<bool>& held, const Eigen::VectorXd& pull, const Eigen::VectorXd& step,
                   const Eigen::VectorXd& up) {
    double most = kNoPull;
    Index found = -1;
    for (Index i = 0; i < step.size(); ++i) {
        const double inward = step(i) == up(i) ? -pull(i) : pull(i);
        if (held[i] && inward > most) most = inward, found = i;
    }
    return found;
}

}  // namespace

Eigen::VectorXd boundedStep(const QuadraticModel& model, double damping, const Bounds& bounds) {
    const Index n = model.at.size();
    const Eigen::MatrixXd hessian = (1 + damping) * Eigen::MatrixXd::Identity(n, n) + model.information;
    const Eigen::VectorXd slope = model.gradient - model.at, down = bounds.lowest - model.at,
                          up = bounds.highest - model.at;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
    std::vector<bool> held(n, false);
    for (Index change = 0; change < kMostChanges * n; ++change) {
        const std::vector<Index> open = openOf(held);
        const Eigen::VectorXd left = slope - hessian * step;
        const Eigen::VectorXd further = Factor(hessian(open, open)).solve(left(open));
        const Meeting met = firstMeeting(open, further, step, down, up);
        step(open) += met.share * further;
        if (const Index i = met.parameter; i >= 0) {
            step(i) = step(i) - down(i) < up(i) - step(i) ? down(i) : up(i);
            held[i] = true;
            continue;
        }
        const Index released = mostHindered(held, slope - hessian * step, step, up);
        if (released < 0) break;
        held[released] = false;
    }
    return step;
}

}  // namespace tread::inference
