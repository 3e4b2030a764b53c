#include "identify/bounded_step.h"

#include <cmath>
#include <vector>

namespace tread {
namespace {

constexpr Eigen::Index kMostChanges = 5;  // of the set of bounds that are met, per parameter
constexpr double kNoPull = 1e-9;

}  // namespace

Eigen::VectorXd boundedStep(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient,
                            const Eigen::VectorXd& x, double damping, const Eigen::VectorXd& lowest,
                            const Eigen::VectorXd& highest) {
    const Eigen::Index n = x.size();
    const Eigen::MatrixXd hessian = (1 + damping) * Eigen::MatrixXd::Identity(n, n) + information;
    const Eigen::VectorXd slope = gradient - x, down = lowest - x, up = highest - x;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
    std::vector<bool> held(static_cast<std::size_t>(n), false);
    for (Eigen::Index change = 0; change < kMostChanges * n; ++change) {
        std::vector<Eigen::Index> open;
        for (Eigen::Index i = 0; i < n; ++i)
            if (!held[static_cast<std::size_t>(i)]) open.push_back(i);
        const Eigen::VectorXd left = slope - hessian * step;
        const Eigen::VectorXd more = hessian(open, open).llt().solve(left(open));
        // As far as the first bound.
        double share = 1;
        Eigen::Index met = -1;
        for (std::size_t k = 0; k < open.size(); ++k) {
            const Eigen::Index i = open[k];
            const double by = more(static_cast<Eigen::Index>(k)), room = by > 0 ? up(i) - step(i) : down(i) - step(i);
            if (by != 0 && std::abs(by) * share > std::abs(room)) share = room / by, met = i;
        }
        step(open) += share * more;
        if (met >= 0) {
            step(met) = step(met) - down(met) < up(met) - step(met) ? down(met) : up(met);
            held[static_cast<std::size_t>(met)] = true;
            continue;
        }
        // Off the bound that hinders most.
        const Eigen::VectorXd pull = slope - hessian * step;
        double most = kNoPull;
        Eigen::Index released = -1;
        for (Eigen::Index i = 0; i < n; ++i) {
            const double inward = step(i) == up(i) ? -pull(i) : pull(i);
            if (held[static_cast<std::size_t>(i)] && inward > most) most = inward, released = i;
        }
        if (released < 0) break;
        held[static_cast<std::size_t>(released)] = false;
    }
    return step;
}

}  // namespace tread
