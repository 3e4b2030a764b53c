#include "diagnose/explain/missing_force.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/parallel.h"
#include "inference/products.h"

namespace tread::diagnose::explain {
namespace {

using model::Disturbed;
using model::Sizes;
using model::Uncertainty;

constexpr double kReading = 15;  // assumed size of the disturbances from which the force is estimated, in usual sizes
constexpr double kClear = 4;     // times the mean square by chance: two standard deviations
// Squared usual sizes, added to the variance by chance so that a drive without information does not count.
constexpr double kUninformed = 0.05;

// Steering is excluded because it is not a force on the car: its effect appears as lateral force and yaw moment of the
// front axle.
Sizes readingSizes(const Uncertainty& uncertainty) {
    Sizes sizes = uncertainty.sizes;
    for (double& size : sizes) size *= kReading;
    sizes[model::placeOf(Disturbed::steering)] = 0;
    return sizes;
}

// Side force at one axle that is equivalent, together with one at the other axle, to a lateral force and a yaw moment.
struct AxleArm {
    double force, moment;  // N at the axle per usual size of lateral force and yaw moment

    static AxleArm front(const VehicleParams& car) { return of(car, car.wheelbase - car.front_axle_distance, 1); }
    static AxleArm rear(const VehicleParams& car) { return of(car, car.front_axle_distance, -1); }
    static AxleArm of(const VehicleParams& car, double arm, double sign) {
        return {model::usualSize(Disturbed::lateral, car) * arm / car.wheelbase,
                sign * model::usualSize(Disturbed::yaw, car) / car.wheelbase};
    }

    // Of the side force at the hats of lateral force and yaw moment, which are the same.
    Eigen::VectorXd squares(const model::Disturbances& disturbing, const Eigen::VectorXd& heights) const {
        const auto kind = [&](Disturbed one) {
            return heights.segment(disturbing.of(one).first, disturbing.of(one).count());
        };
        return (force * kind(Disturbed::lateral) + moment * kind(Disturbed::yaw)).cwiseAbs2();
    }
};

// Estimate for one drive, per hat: the force in usual sizes, the squared side force at the axles, N2, and the mean
// square that chance alone gives to each.
struct Reading {
    Eigen::VectorXd force, by_chance;
    struct AtAxle {
        Eigen::VectorXd squares, by_chance;
    } front, rear;
};

// Heights of the hats for a solution in the directions of a drive, without the start speed.
Eigen::VectorXd heightsOf(const model::Disturbances& disturbing, const Eigen::VectorXd& sizes,
                          const Eigen::VectorXd& solved) {
    return disturbing.heights(sizes.cwiseProduct(solved).head(solved.size() - 1));
}

// Posterior mean of disturbances of the given sizes (D47), and its variance by chance (D48).
Reading reading(const Calibration& car, std::size_t drive, const Sizes& sizes) {
    const Uncertainty& uncertainty = car.uncertainty;
    const model::Disturbances& disturbing = uncertainty.disturbing[drive];
    const Eigen::MatrixXd& directions = uncertainty.directions[drive];
    const Eigen::VectorXd large = uncertainty.sizesOf(drive, sizes);
    const Eigen::VectorXd usual = uncertainty.sizesOf(drive, uncertainty.sizes);
    const Eigen::MatrixXd products = inference::squareOf(directions);
    const Eigen::MatrixXd together = large.asDiagonal() * products * large.asDiagonal();
    const inference::Factor factor = inference::factorOfPriorAnd(together);
    const VehicleParams& vehicle = car.problem.replays.nominal().vehicle;
    const AxleArm front = AxleArm::front(vehicle), rear = AxleArm::rear(vehicle);
    const Eigen::VectorXd left = model::residual(car.drives(), uncertainty, car.nominal, drive);
    Reading result;
    result.force = heightsOf(disturbing, large, factor.solve(large.cwiseProduct(directions.transpose() * left)));
    result.by_chance = Eigen::VectorXd::Zero(result.force.size());
    result.front.squares = front.squares(disturbing, result.force);
    result.rear.squares = rear.squares(disturbing, result.force);
    result.front.by_chance = result.rear.by_chance = Eigen::VectorXd::Zero(result.front.squares.size());
    // Covariance of the projections by chance: white noise gives D'D in the metric of the directions; usual
    // disturbances and tolerances add their own.
    const Eigen::MatrixXd pushed = usual.asDiagonal() * products * large.asDiagonal();
    const Eigen::MatrixXd tolerated =
        inference::transposedTimes(car.about.columns[drive].leftCols(std::ssize(car.about.nuisances)), directions) *
        large.asDiagonal();
    const Eigen::MatrixXd spread =
        factor.solve(factor.solve(together + inference::squareOf(pushed) + inference::squareOf(tolerated)).transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(spread);
    for (Eigen::Index i = 0; i < directions.cols(); ++i) {
        const double variance = std::max(0.0, axes.eigenvalues()(i));
        const Eigen::VectorXd one = heightsOf(disturbing, large, axes.eigenvectors().col(i));
        result.by_chance += variance * one.cwiseAbs2();
        result.front.by_chance += variance * front.squares(disturbing, one);
        result.rear.by_chance += variance * rear.squares(disturbing, one);
    }
    return result;
}

// Squared side force at both axles, over all hats at which either is clearly more than chance.
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

// Clarity of each kind of force over all drives, and the moment at which one is largest.
struct Clarity {
    Sizes shown{};
    double most = -kInfinity;
    answer::Moment when;

    void add(const Reading& reading, const recording::RecordedDrive& drive, const model::Disturbances& disturbing) {
        for (Eigen::Index i = 0; i < reading.force.size(); ++i) {
            const Disturbed kind = disturbing.kinds[i];
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
    std::vector<Reading> readings(car.drives().size());
    inParallel(readings.size(), car.problem.replays.threads,
               [&](std::size_t d) { readings[d] = reading(car, d, sizes); });
    for (std::size_t d = 0; d < readings.size(); ++d) {
        axles.addClear(readings[d]);
        clarity.add(readings[d], car.drives()[d], car.uncertainty.disturbing[d]);
    }
    return {clarity.shares(), axles.shares(), clarity.when};
}

}  // namespace tread::diagnose::explain
