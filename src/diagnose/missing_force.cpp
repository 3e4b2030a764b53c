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

// Squares of the side force at the front and at the rear that a lateral force and a yaw moment amount to; what chance
// shows of these is taken as if it knew nothing of the other.
struct AxleSquares {
    double front = 0, rear = 0;
};

AxleSquares axleSquares(const VehicleParams& car, const Reading& reading) {
    const Eigen::Index each = reading.force.size() / static_cast<Eigen::Index>(kDisturbances);
    const auto of = [&](const Eigen::VectorXd& values, Disturbed kind) -> Eigen::ArrayXd {
        return values.segment(static_cast<Eigen::Index>(kind) * each, each).array();
    };
    const double l = car.wheelbase, a = car.front_axle_distance, b = l - a;
    const double newton = usualSize(Disturbed::lateral, car), newton_metre = usualSize(Disturbed::yaw, car);
    const auto squares = [&](double arm, double sign) {
        const double force = newton * arm / l, moment = sign * newton_metre / l;
        const Eigen::ArrayXd both =
            force * of(reading.force, Disturbed::lateral) + moment * of(reading.force, Disturbed::yaw);
        const Eigen::ArrayXd chance = force * force * of(reading.by_chance, Disturbed::lateral) +
                                      moment * moment * of(reading.by_chance, Disturbed::yaw);
        return (both.square() - chance).sum();
    };
    return {squares(b, 1), squares(a, -1)};
}

}  // namespace

MissingForce missingForce(const Study& study) {
    const std::array<double, kDisturbances> sizes = readingSizes(study.uncertainty);
    std::array<double, kDisturbances> shown{};
    double most = -kInfinity;
    AxleSquares axles;
    MissingForce result;
    for (std::size_t d = 0; d < study.bench.drives.size(); ++d) {
        const Disturbances& disturbing = study.uncertainty.disturbing[d];
        const Reading here = reading(study, d, sizes);
        const AxleSquares of_drive = axleSquares(study.bench.nominal.vehicle, here);
        axles.front += of_drive.front, axles.rear += of_drive.rear;
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
    const double front = std::max(0.0, axles.front), rear = std::max(0.0, axles.rear);
    result.axles = {{"front", front + rear > 0 ? front / (front + rear) : 0.5},
                    {"rear", front + rear > 0 ? rear / (front + rear) : 0.5}};
    return result;
}

}  // namespace tread
