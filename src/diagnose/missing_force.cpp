#include "diagnose/missing_force.h"

#include <fmt/format.h>

#include <numeric>

namespace tread {
namespace {

constexpr double kReading = 15;  // times the usual size: with these the force is read off

// Steering is no force: what it would explain shows as lateral force and yaw moment of the front axle.
std::array<double, kDisturbances> readingSizes(const Uncertainty& uncertainty) {
    std::array<double, kDisturbances> sizes = uncertainty.sizes;
    for (double& size : sizes) size *= kReading;
    sizes[static_cast<std::size_t>(Disturbed::steering)] = 0;
    return sizes;
}

// How far the fitted parameters go back when disturbances of these sizes may explain what they were stretched for.
Eigen::VectorXd givenBack(const Study& study, const Fit& fit, const std::array<double, kDisturbances>& sizes) {
    const Gram gram = total(fit.grams, study.uncertainty, sizes);
    const auto n = static_cast<Eigen::Index>(fit.free.size());
    const Eigen::MatrixXd hessian = Eigen::MatrixXd::Identity(n, n) + gram.products.topLeftCorner(n, n);
    return hessian.llt().solve(gram.products.topRightCorner(n, 1) - fit.at(fit.free));
}

// The force of a drive, as heights of hats in usual sizes, and the mean squares that chance alone would show.
struct Reading {
    Eigen::VectorXd force, by_chance;
};

Reading reading(const Study& study, std::size_t drive, const Eigen::VectorXd& left,
                const std::array<double, kDisturbances>& sizes) {
    const Uncertainty& uncertainty = study.uncertainty;
    const Disturbances& disturbing = uncertainty.disturbing[drive];
    const Eigen::MatrixXd& directions = uncertainty.directions[drive];
    const Eigen::VectorXd large = uncertainty.sizesOf(drive, sizes);
    const Eigen::VectorXd usual = uncertainty.sizesOf(drive, uncertainty.sizes);
    const Eigen::Index n = directions.cols(), impulses = n - 1;  // without the speed at the start
    const Eigen::MatrixXd scaled = directions * large.asDiagonal();
    const Eigen::MatrixXd together = scaled.transpose() * scaled;
    const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(n, n) + together);
    const auto heights = [&](const Eigen::VectorXd& solved) {
        return disturbing.hats(large.cwiseProduct(solved).head(impulses));
    };
    Reading result{heights(factor.solve(scaled.transpose() * left)), Eigen::VectorXd::Zero(impulses)};
    // Chance is white noise, whose products with the directions vary as these do with each other, and usual pushes.
    const Eigen::MatrixXd pushed = scaled.transpose() * directions * usual.asDiagonal();
    const Eigen::MatrixXd spread = factor.solve(factor.solve(together + pushed * pushed.transpose()).transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(spread);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double variance = std::max(0.0, axes.eigenvalues()(i));
        result.by_chance += variance * heights(axes.eigenvectors().col(i)).cwiseAbs2();
    }
    return result;
}

}  // namespace

MissingForce missingForce(const Study& study, const Fit& fit) {
    const std::array<double, kDisturbances> sizes = readingSizes(study.uncertainty);
    const Eigen::VectorXd back = givenBack(study, fit, sizes);
    std::array<double, kDisturbances> energy{};
    double most = -kInfinity;
    MissingForce result;
    for (std::size_t d = 0; d < fit.rows.size(); ++d) {
        const Disturbances& disturbing = study.uncertainty.disturbing[d];
        const Reading here =
            reading(study, d, residual(study.bench, study.uncertainty, fit.rows, d) - fit.columns[d] * back, sizes);
        const Eigen::VectorXd more = here.force.cwiseAbs2() - here.by_chance;
        for (std::size_t i = 0; i < disturbing.kinds.size(); ++i) {
            const double one = more(static_cast<Eigen::Index>(i));
            energy[static_cast<std::size_t>(disturbing.kinds[i])] += one;
            if (one <= most) continue;
            most = one;
            result.when = fmt::format("{}, about {:.1f} s", study.bench.drives[d].name, disturbing.times[i]);
        }
    }
    for (double& one : energy) one = std::max(0.0, one);
    energy[static_cast<std::size_t>(Disturbed::steering)] = 0;
    const double sum = std::accumulate(energy.begin(), energy.end(), 0.0);
    for (std::size_t kind = 0; kind < kDisturbances; ++kind) {
        if (static_cast<Disturbed>(kind) == Disturbed::steering) continue;
        result.shares[std::string(kDisturbedNames[kind])] = sum > 0 ? energy[kind] / sum : 0.25;
    }
    return result;
}

}  // namespace tread
