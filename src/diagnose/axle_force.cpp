#include "diagnose/axle_force.h"

namespace tread {
namespace {

constexpr double kReading = 15;  // times the usual size: with these the missing force is read off

}  // namespace

std::array<double, kDisturbances> readingSizes(const Study& study) {
    std::array<double, kDisturbances> sizes = study.uncertainty.sizes;
    for (double& size : sizes) size *= kReading;
    sizes[static_cast<std::size_t>(Disturbed::steering)] = 0;
    return sizes;
}

Eigen::VectorXd missingHats(const Study& study, const Fit& fit, std::size_t drive) {
    const Eigen::VectorXd sizes = study.uncertainty.sizesOf(drive, readingSizes(study));
    const Eigen::MatrixXd scaled = study.uncertainty.directions[drive] * sizes.asDiagonal();
    const Eigen::Index n = scaled.cols();
    const Eigen::VectorXd impulses =
        (Eigen::MatrixXd::Identity(n, n) + scaled.transpose() * scaled)
            .llt()
            .solve(scaled.transpose() * residual(study.bench, study.uncertainty, fit.rows, drive));
    return study.uncertainty.disturbing[drive].hats(impulses.head(n - 1));  // without the speed at the start
}

Shares axleForce(const Study& study, const Fit& fit) {
    const VehicleParams car = study.bench.subjectAt(fit.at).vehicle;
    const double l = car.wheelbase, a = car.front_axle_distance, b = l - a;
    const std::array<double, kDisturbances> sizes = readingSizes(study);
    double front = 0, rear = 0;
    for (std::size_t d = 0; d < fit.rows.size(); ++d) {
        const Eigen::VectorXd hats = missingHats(study, fit, d);
        const Eigen::Index each = hats.size() / static_cast<Eigen::Index>(kDisturbances);
        const auto of = [&](Disturbed kind) -> Eigen::ArrayXd {
            const auto index = static_cast<std::size_t>(kind);
            return sizes[index] * usualSize(kind, car) *
                   hats.segment(static_cast<Eigen::Index>(index) * each, each).array();
        };
        const Eigen::ArrayXd force = of(Disturbed::lateral), moment = of(Disturbed::yaw);
        front += ((force * b + moment) / l).square().sum();
        rear += ((force * a - moment) / l).square().sum();
    }
    const double sum = front + rear;
    return {{"front", sum > 0 ? front / sum : 0.5}, {"rear", sum > 0 ? rear / sum : 0.5}};
}

}  // namespace tread
