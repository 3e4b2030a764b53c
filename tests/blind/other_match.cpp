#include "blind/other_match.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "blind/other_measure.h"

namespace other_car {
namespace {

constexpr std::size_t kMean = 5;  // rows
constexpr int kRounds = 2;
constexpr double kStep = 0.1;  // of the differences, in standard deviations of the prior

// What may move, and how far: a fraction of itself, or so much.
struct Free {
    double* value;
    double by;
};

std::vector<Free> freeNumbers(Truth& truth) {
    Params& p = truth.car;
    std::vector<Free> free;
    const auto relative = [&](double& value) { free.push_back({&value, 0.1 * std::abs(value)}); };
    for (double* value : {&p.yaw_inertia, &p.roll_inertia, &p.pitch_inertia, &p.drag_area, &p.brake_torque,
                          &p.engine_inertia, &p.drive_scale, &p.drag_scale})
        relative(*value);
    for (Axle* axle : {&p.front, &p.rear}) {
        Tyre& tyre = axle->tyre;
        for (double* value : {&axle->damping, &axle->anti_roll_bar, &tyre.stiffness, &tyre.stiffness_load,
                              &tyre.friction, &tyre.friction_by_load, &tyre.slip_stiffness,
                              &tyre.slip_stiffness_by_load, &tyre.camber_stiffness, &tyre.trail, &tyre.curvature,
                              &tyre.carcass, &tyre.rolling_resistance, &tyre.loaded_radius, &tyre.rolling_radius})
            relative(*value);
        free.push_back({&axle->compliance_steer, 1e-6});
        free.push_back({&axle->toe_by_travel, 0.02});
        free.push_back({&axle->roll_axis, 0.02});
        free.push_back({&axle->brake_support, 0.04});
    }
    return free;
}

// All readings of the drives from which one learns, over their noise.
template <class Measure>
Eigen::VectorXd readings(const Measure& measured) {
    std::vector<double> all;
    for (const tread::Drive& drive : tread::blindDrives()) {
        if (drive.hold_out) continue;
        const tread::Log log = measured(drive);
        for (const tread::Gauge& gauge : tread::gauges()) {
            if (gauge.channel.starts_with("driver.")) continue;
            for (const double mean : means(log, gauge.channel)) all.push_back(mean / noiseOfMeans(gauge));
        }
    }
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::VectorXd readingsOf(const Truth& truth) {
    return readings([&](const tread::Drive& drive) { return measure(truth, drive, 1, tread::kIdeal); });
}

}  // namespace

tread::Log drivenByTread(const tread::VehicleParams& vehicle, const tread::Drive& drive) {
    tread::Truth car;
    car.car.vehicle = vehicle;
    std::vector<double>& ratios = car.car.vehicle.driveline.gearbox.ratios;
    ratios = {ratios.back()};
    return tread::measure(car, drive, 1, tread::kIdeal);
}

std::vector<double> means(const tread::Log& log, std::string_view channel) {
    const std::vector<double>& values = log.find(channel)->values;
    std::vector<double> result;
    for (std::size_t i = 0; i + kMean <= values.size(); i += kMean) {
        double sum = 0;
        for (std::size_t k = i; k < i + kMean; ++k) sum += values[k];
        result.push_back(sum / kMean);
    }
    return result;
}

double noiseOfMeans(const tread::Gauge& gauge) {
    return gauge.noise / std::sqrt(static_cast<double>(kMean));
}

Truth matched(const Truth& begin, const tread::VehicleParams& vehicle) {
    const Eigen::VectorXd wanted = readings([&](const auto& drive) { return drivenByTread(vehicle, drive); });
    Truth truth = begin;
    const std::vector<Free> free = freeNumbers(truth);
    const auto n = static_cast<Eigen::Index>(free.size());
    Eigen::VectorXd at = Eigen::VectorXd::Zero(n);
    for (int round = 0; round < kRounds; ++round) {
        const Eigen::VectorXd here = readingsOf(truth);
        Eigen::MatrixXd columns(here.size(), n);
        tread::inParallel(free.size(), 0, [&](std::size_t i) {
            Truth moved = truth;
            const Free one = freeNumbers(moved)[i];
            *one.value += kStep * free[i].by;
            columns.col(static_cast<Eigen::Index>(i)) = (readingsOf(moved) - here) / kStep;
        });
        const Eigen::MatrixXd information = columns.transpose() * columns + Eigen::MatrixXd::Identity(n, n);
        const Eigen::VectorXd step = information.llt().solve(columns.transpose() * (wanted - here) - at);
        at += step;
        for (Eigen::Index i = 0; i < n; ++i) {
            const Free& one = free[static_cast<std::size_t>(i)];
            *one.value += step(i) * one.by;
        }
    }
    return truth;
}

}  // namespace other_car
