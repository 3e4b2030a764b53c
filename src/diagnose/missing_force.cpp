#include "diagnose/missing_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tread {
namespace {

constexpr double kReading = 15;       // times the usual size: with these the force is read off
constexpr double kClear = 4;          // times the mean square by chance: two standard deviations
constexpr double kUninformed = 0.05;  // squares of usual sizes: a drive that says less says nothing

// Steering is no force: what it would explain shows as lateral force and yaw moment of the front axle.
std::array<double, kDisturbances> readingSizes(const Uncertainty& uncertainty) {
    std::array<double, kDisturbances> sizes = uncertainty.sizes;
    for (double& size : sizes) size *= kReading;
    sizes[static_cast<std::size_t>(Disturbed::steering)] = 0;
    return sizes;
}

// The side force that a lateral force and a yaw moment, as heights of hats in usual sizes, amount to at one end of the
// car.
struct AxleArm {
    double force, moment;  // N of the axle per usual size

    static AxleArm front(const VehicleParams& car) { return of(car, car.wheelbase - car.front_axle_distance, 1); }
    static AxleArm rear(const VehicleParams& car) { return of(car, car.front_axle_distance, -1); }
    static AxleArm of(const VehicleParams& car, double arm, double sign) {
        return {usualSize(Disturbed::lateral, car) * arm / car.wheelbase,
                sign * usualSize(Disturbed::yaw, car) / car.wheelbase};
    }

    Eigen::VectorXd squares(const Eigen::VectorXd& heights) const {
        const Eigen::Index each = heights.size() / static_cast<Eigen::Index>(kDisturbances);
        const auto kind = [&](Disturbed one) { return heights.segment(static_cast<Eigen::Index>(one) * each, each); };
        return (force * kind(Disturbed::lateral) + moment * kind(Disturbed::yaw)).cwiseAbs2();
    }
};

// Per hat: the force of a drive in usual sizes, the squares of side force at the axles, N2; and what chance alone would
// show of these in the mean.
struct Reading {
    Eigen::VectorXd force, by_chance;
    struct AtAxle {
        Eigen::VectorXd squares, by_chance;
    } front, rear;
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
    const AxleArm front = AxleArm::front(study.bench.nominal.vehicle),
                  rear = AxleArm::rear(study.bench.nominal.vehicle);
    const Eigen::VectorXd left = residual(study.bench, uncertainty, study.nominal, drive);
    Reading result;
    result.force = heights(factor.solve(scaled.transpose() * left));
    result.by_chance = Eigen::VectorXd::Zero(impulses);
    result.front.squares = front.squares(result.force), result.rear.squares = rear.squares(result.force);
    result.front.by_chance = result.rear.by_chance = Eigen::VectorXd::Zero(result.front.squares.size());
    // Chance is white noise, whose products with the directions vary as these do with each other, usual pushes, and
    // what tolerances do.
    const Eigen::MatrixXd pushed = scaled.transpose() * directions * usual.asDiagonal();
    const Eigen::MatrixXd tolerated = scaled.transpose() * study.calibrated.columns[drive];
    const Eigen::MatrixXd spread = factor.solve(
        factor.solve(together + pushed * pushed.transpose() + tolerated * tolerated.transpose()).transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(spread);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double variance = std::max(0.0, axes.eigenvalues()(i));
        const Eigen::VectorXd one = heights(axes.eigenvectors().col(i));
        result.by_chance += variance * one.cwiseAbs2();
        result.front.by_chance += variance * front.squares(one);
        result.rear.by_chance += variance * rear.squares(one);
    }
    return result;
}

// Squares of the side force at both axles, as long as one of them is more than chance.
void addClear(const Reading& reading, double& front, double& rear) {
    for (Eigen::Index i = 0; i < reading.front.squares.size(); ++i) {
        const auto clear = [&](const Reading::AtAxle& axle) { return axle.squares(i) > kClear * axle.by_chance(i); };
        if (!clear(reading.front) && !clear(reading.rear)) continue;
        front += reading.front.squares(i), rear += reading.rear.squares(i);
    }
}

}  // namespace

MissingForce missingForce(const Study& study) {
    const std::array<double, kDisturbances> sizes = readingSizes(study.uncertainty);
    std::array<double, kDisturbances> shown{};
    double most = -kInfinity;
    double front = 0, rear = 0;
    MissingForce result;
    for (std::size_t d = 0; d < study.bench.drives.size(); ++d) {
        const Disturbances& disturbing = study.uncertainty.disturbing[d];
        const Reading here = reading(study, d, sizes);
        addClear(here, front, rear);
        const bool followed = study.bench.drives[d].recording->speed == SpeedReplay::followed;
        for (std::size_t i = 0; i < disturbing.kinds.size(); ++i) {
            // A driver who follows the measured speed makes what is missing along the car his own.
            if (followed && disturbing.kinds[i] == Disturbed::longitudinal) continue;
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
    result.axles = {{"front", front + rear > 0 ? front / (front + rear) : 0.5},
                    {"rear", front + rear > 0 ? rear / (front + rear) : 0.5}};
    return result;
}

}  // namespace tread
