#include "diagnose/missing_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tread {
namespace {

constexpr double kReading = 15;       // times the usual size: with these the force is read off
constexpr double kUninformed = 0.05;  // squares of usual sizes: a drive that says less says nothing

// Steering is no force: what it would explain shows as lateral force and yaw moment of the front axle.
std::array<double, kDisturbances> readingSizes(const Uncertainty& uncertainty) {
    std::array<double, kDisturbances> sizes = uncertainty.sizes;
    for (double& size : sizes) size *= kReading;
    sizes[static_cast<std::size_t>(Disturbed::steering)] = 0;
    return sizes;
}

// The force of a drive, as heights of hats in usual sizes, and the mean squares that chance alone would show.
struct Reading {
    Eigen::VectorXd force, by_chance;
};

Reading reading(const Study& study, std::size_t drive, const std::array<double, kDisturbances>& sizes) {
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
    const Eigen::VectorXd left = residual(study.bench, uncertainty, study.nominal, drive);
    Reading result{heights(factor.solve(scaled.transpose() * left)), Eigen::VectorXd::Zero(impulses)};
    // Chance is white noise, whose products with the directions vary as these do with each other, usual pushes, and
    // what tolerances do.
    const Eigen::MatrixXd pushed = scaled.transpose() * directions * usual.asDiagonal();
    const Eigen::MatrixXd tolerated = scaled.transpose() * study.calibrated.columns[drive];
    const Eigen::MatrixXd spread = factor.solve(
        factor.solve(together + pushed * pushed.transpose() + tolerated * tolerated.transpose()).transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(spread);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double variance = std::max(0.0, axes.eigenvalues()(i));
        result.by_chance += variance * heights(axes.eigenvectors().col(i)).cwiseAbs2();
    }
    return result;
}

}  // namespace

MissingForce missingForce(const Study& study) {
    const std::array<double, kDisturbances> sizes = readingSizes(study.uncertainty);
    std::array<double, kDisturbances> shown{};
    double most = -kInfinity;
    MissingForce result;
    for (std::size_t d = 0; d < study.bench.drives.size(); ++d) {
        const Disturbances& disturbing = study.uncertainty.disturbing[d];
        const Reading here = reading(study, d, sizes);
        for (std::size_t i = 0; i < disturbing.kinds.size(); ++i) {
            const auto hat = static_cast<Eigen::Index>(i);
            const double square = here.force(hat) * here.force(hat), chance = here.by_chance(hat) + kUninformed;
            shown[static_cast<std::size_t>(disturbing.kinds[i])] += std::max(0.0, std::log(square / chance));
            if (square - chance <= most) continue;
            most = square - chance;
            result.when = fmt::format("{}, about {:.1f} s", study.bench.drives[d].name, disturbing.times[i]);
        }
    }
    const double sum = std::accumulate(shown.begin(), shown.end(), 0.0);
    for (std::size_t kind = 0; kind < kDisturbances; ++kind) {
        if (static_cast<Disturbed>(kind) == Disturbed::steering) continue;
        result.shares[std::string(kDisturbedNames[kind])] = sum > 0 ? shown[kind] / sum : 0.25;
    }
    return result;
}

}  // namespace tread
