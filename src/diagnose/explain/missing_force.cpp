#include "diagnose/explain/missing_force.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tread::diagnose::explain {
namespace {

using model::Disturbed;
using model::Sizes;
using model::Uncertainty;

constexpr double kReading = 15;       // times the usual size: with these the force is read off
constexpr double kClear = 4;          // times the mean square by chance: two standard deviations
constexpr double kUninformed = 0.05;  // squares of usual sizes: a drive that says less says nothing

// Steering is no force: what it would explain shows as lateral force and yaw moment of the front axle.
Sizes readingSizes(const Uncertainty& uncertainty) {
    Sizes sizes = uncertainty.sizes;
    for (double& size : sizes) size *= kReading;
    sizes[model::placeOf(Disturbed::steering)] = 0;
    return sizes;
}

// The side force that a lateral force and a yaw moment, as heights of hats in usual sizes, amount to at one end of the
// car.
struct AxleArm {
    double force, moment;  // N of the axle per usual size

    static AxleArm front(const VehicleParams& car) { return of(car, car.wheelbase - car.front_axle_distance, 1); }
    static AxleArm rear(const VehicleParams& car) { return of(car, car.front_axle_distance, -1); }
    static AxleArm of(const VehicleParams& car, double arm, double sign) {
        return {model::usualSize(Disturbed::lateral, car) * arm / car.wheelbase,
                sign * model::usualSize(Disturbed::yaw, car) / car.wheelbase};
    }

    Eigen::VectorXd squares(const Eigen::VectorXd& heights) const {
        const Eigen::Index each = heights.size() / std::ssize(model::kDisturbedKinds);
        const auto kind = [&](Disturbed one) { return heights.segment(model::placeOf(one) * each, each); };
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

// Heights of the hats that solved directions of a drive amount to, the speed at the start left out.
Eigen::VectorXd heightsOf(const model::Disturbances& disturbing, const Eigen::VectorXd& sizes,
                          const Eigen::VectorXd& solved) {
    return disturbing.heights(sizes.cwiseProduct(solved).head(solved.size() - 1));
}

// The posterior mean of disturbances of the given sizes (D47), and its variance by chance (D48).
Reading reading(const Calibration& car, std::size_t drive, const Sizes& sizes) {
    const Uncertainty& uncertainty = car.uncertainty;
    const model::Disturbances& disturbing = uncertainty.disturbing[drive];
    const Eigen::MatrixXd& directions = uncertainty.directions[drive];
    const Eigen::VectorXd large = uncertainty.sizesOf(drive, sizes);
    const Eigen::VectorXd usual = uncertainty.sizesOf(drive, uncertainty.sizes);
    const Eigen::MatrixXd scaled = directions * large.asDiagonal();
    const Eigen::MatrixXd together = scaled.transpose() * scaled;
    const inference::Factor factor = inference::factorOfPriorAnd(together);
    const VehicleParams& vehicle = car.problem.replays.nominal().vehicle;
    const AxleArm front = AxleArm::front(vehicle), rear = AxleArm::rear(vehicle);
    const Eigen::VectorXd left = model::residual(car.drives(), uncertainty, car.nominal, drive);
    Reading result;
    result.force = heightsOf(disturbing, large, factor.solve(scaled.transpose() * left));
    result.by_chance = Eigen::VectorXd::Zero(result.force.size());
    result.front.squares = front.squares(result.force), result.rear.squares = rear.squares(result.force);
    result.front.by_chance = result.rear.by_chance = Eigen::VectorXd::Zero(result.front.squares.size());
    // Chance is white noise, whose products with the directions vary as these do with each other, usual pushes, and
    // what tolerances do.
    const Eigen::MatrixXd pushed = scaled.transpose() * directions * usual.asDiagonal();
    const Eigen::MatrixXd tolerated = scaled.transpose() * car.about.columns[drive];
    const Eigen::MatrixXd spread = factor.solve(
        factor.solve(together + pushed * pushed.transpose() + tolerated * tolerated.transpose()).transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(spread);
    for (Eigen::Index i = 0; i < directions.cols(); ++i) {
        const double variance = std::max(0.0, axes.eigenvalues()(i));
        const Eigen::VectorXd one = heightsOf(disturbing, large, axes.eigenvectors().col(i));
        result.by_chance += variance * one.cwiseAbs2();
        result.front.by_chance += variance * front.squares(one);
        result.rear.by_chance += variance * rear.squares(one);
    }
    return result;
}

// Squares of the side force at both axles, as long as one of them is more than chance.
struct AxleSquares {
    double front = 0, rear = 0;

    void addClear(const Reading& reading) {
        for (Eigen::Index i = 0; i < reading.front.squares.size(); ++i) {
            const auto clear = [&](const Reading::AtAxle& axle) {
                return axle.squares(i) > kClear * axle.by_chance(i);
            };
            if (!clear(reading.front) && !clear(reading.rear)) continue;
            front += reading.front.squares(i), rear += reading.rear.squares(i);
        }
    }

    std::map<std::string, double> shares() const {
        const double both = front + rear;
        return {{"front", both > 0 ? front / both : 0.5}, {"rear", both > 0 ? rear / both : 0.5}};
    }
};

// The kinds of force by how clearly they act, and the moment that shows most.
struct Clarity {
    Sizes shown{};
    double most = -kInfinity;
    answer::Moment when;

    void add(const Reading& reading, const recording::RecordedDrive& drive, const model::Disturbances& disturbing) {
        const bool followed = drive.recording->speed == recording::SpeedReplay::followed;
        for (Eigen::Index i = 0; i < reading.force.size(); ++i) {
            const Disturbed kind = disturbing.kinds[i];
            // A driver who follows the measured speed makes what is missing along the car his own.
            if (followed && kind == Disturbed::longitudinal) continue;
            const double square = reading.force(i) * reading.force(i), chance = reading.by_chance(i) + kUninformed;
            shown[model::placeOf(kind)] += std::max(0.0, std::log(square / chance));
            if (square - chance <= most) continue;
            most = square - chance;
            when = {drive.name, disturbing.times[i]};
        }
    }

    std::map<std::string, double> shares() const {
        const double sum = std::accumulate(shown.begin(), shown.end(), 0.0);
        std::map<std::string, double> all;
        for (const Disturbed kind : model::kDisturbedKinds) {
            if (kind == Disturbed::steering) continue;
            all[std::string(model::nameOf(kind))] = sum > 0 ? shown[model::placeOf(kind)] / sum : 0.25;
        }
        return all;
    }
};

}  // namespace

MissingForce missingForce(const Calibration& car) {
    const Sizes sizes = readingSizes(car.uncertainty);
    AxleSquares axles;
    Clarity clarity;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const Reading here = reading(car, d, sizes);
        axles.addClear(here);
        clarity.add(here, car.drives()[d], car.uncertainty.disturbing[d]);
    }
    return {clarity.shares(), axles.shares(), clarity.when};
}

}  // namespace tread::diagnose::explain
