// A car whose yaw rate is a sum of waves, each times one of its numbers: linear in all of them, so that fits have
// closed forms.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "diagnose/model/problem.h"
#include "shared/simple_car.h"

namespace tread::linear_car {

using Wave = double (*)(double);
inline double ofWheelbase(double t) {
    return 0.02 * std::sin(2 * t + 1.2);
}
inline double ofRatio(double t) {
    return 0.004 * std::sin(2 * t);
}
inline double ofDrag(double t) {
    return 0.1 * std::cos(3 * t);
}
// Of the speed at the start, times `steering.play`.
inline double ofSpeed(double t) {
    return 0.01 * std::exp(-t);
}

// The same car, of which a roll moment changes the yaw rate at once. Its yaw rate remains linear in all of its numbers.
inline void drivePushed(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder,
                        const Pushing& pushing) {
    constexpr double kYielding = 2e-5;  // rad/s per N m
    const std::vector<Column> columns = recordedColumns(scenario.log.channels);
    recorder.begin(columns);
    const Phase& phase = scenario.phases.back();
    const auto rows = static_cast<int>(*phase.until.duration / scenario.step) + 1;
    for (int k = 0; k <= rows; ++k) {
        const double t = k * scenario.step, speed = scenario.start.speed;
        const double pushed = pushing ? kYielding * pushing(t, {}, {}).moment.x() : 0;
        const double rate = car.wheelbase * ofWheelbase(t) + car.steering.ratio * ofRatio(t) +
                            car.aero.drag_area * ofDrag(t) + car.steering.play * speed * ofSpeed(t) + pushed;
        const std::map<std::string, double> shown{{"time", t},
                                                  {"driver.steering_wheel_angle", valueAt(phase.steering, 0, t)},
                                                  {"chassis.vx", speed},
                                                  {"chassis.yaw_rate", rate}};
        std::vector<double> row(columns.size(), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (const auto found = shown.find(columns[i].name); found != shown.end()) row[i] = found->second;
        recorder.row(row);
    }
}
inline void drive(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing&) {
    drivePushed(car, scenario, recorder, {});
}

inline VehicleParams nominal() {
    return simple_car::Case{}.nominal.vehicle;
}

// Drives of a true car at these speeds, m/s, of which the yaw rate alone is compared. Of its numbers only the wheelbase
// is uncertain.
inline simple_car::Case recorded(const VehicleParams& truth, std::uint64_t seed,
                                 const recording::Simulate& simulate = drive,
                                 const std::vector<double>& speeds = {15, 22}) {
    std::vector<Scenario> drives;
    for (const double speed : speeds) drives.push_back(simple_car::slalom(speed));
    simple_car::Case made = simple_car::recorded(truth, drives, seed, simulate);
    made.nominal.vehicle.steering.play = truth.steering.play;
    made.file.channels = {{.channel = "chassis.yaw_rate"}};
    made.file.step = 0.0025;  // samples of the logs fall on steps of the replays, coarse ones too
    made.file.tolerances = {{.path = "*"}, {.path = "wheelbase", .relative = 0.02}};
    return made;
}

inline diagnose::Options options() {
    diagnose::Options options = simple_car::options(1);
    options.simulate = drive;
    return options;
}

// Rows of a wave in a drive over its noise, smoothed by hand.
inline Eigen::VectorXd weighted(const recording::RecordedDrive& drive, const diagnose::model::RowNoise& noise,
                                const Eigen::VectorXd& rows) {
    const Eigen::VectorXd scaled = rows.cwiseQuotient(noise.deviation);
    Eigen::VectorXd smooth(rows.size());
    const Eigen::Index last = drive.channels.front().rows() - 1;
    for (Eigen::Index i = 0; i <= last; ++i)
        smooth(i) =
            0.25 * scaled(std::max<Eigen::Index>(i - 1, 0)) + 0.5 * scaled(i) + 0.25 * scaled(std::min(i + 1, last));
    return smooth;
}
// Covariance of the weighted rows of a drive by drift of the gyro, of the usual size: values 1 s apart, on a line
// between them, correlated over 2 s.
inline Eigen::MatrixXd drift(const recording::RecordedDrive& drive, const diagnose::model::RowNoise& noise) {
    const std::vector<double>& times = drive.channels.front().times;
    const auto knots = static_cast<Eigen::Index>(std::ceil(drive.time.back())) + 1;
    Eigen::MatrixXd correlation(knots, knots), between(std::ssize(times), knots);
    for (Eigen::Index i = 0; i < knots; ++i) {
        for (Eigen::Index j = 0; j < knots; ++j)
            correlation(i, j) = std::exp(-0.5 * static_cast<double>(std::abs(i - j)));
        Eigen::VectorXd tent(std::ssize(times));
        for (Eigen::Index row = 0; row < tent.size(); ++row)
            tent(row) = std::max(0.0, 1 - std::abs(times[row] - static_cast<double>(i)));
        between.col(i) = weighted(drive, noise, 5e-5 * tent);
    }
    return between * correlation * between.transpose();
}
// Covariances of the weighted rows of a drive by errors of the gyro, of the usual sizes: its drift, readings that are
// too large by a thousandth, and that come a millisecond late. `rows`: its readings.
using diagnose::model::Disturbed;
constexpr std::array kMisread{Disturbed::rate_reading, Disturbed::rate_scale, Disturbed::rate_timing};
inline std::array<Eigen::MatrixXd, kMisread.size()> misread(const recording::RecordedDrive& drive,
                                                            const diagnose::model::RowNoise& noise,
                                                            const Eigen::VectorXd& rows) {
    const std::vector<double>& times = drive.channels.front().times;
    Eigen::VectorXd rates(rows.size());
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0), after = std::min(i + 1, rows.size() - 1);
        rates(i) = (rows(after) - rows(before)) / (times[after] - times[before]);
    }
    const Eigen::VectorXd scale = weighted(drive, noise, 0.001 * rows), timing = weighted(drive, noise, -0.001 * rates);
    return {drift(drive, noise), scale * scale.transpose(), timing * timing.transpose()};
}
inline Eigen::VectorXd rowsOf(const recording::RecordedDrive& drive, Wave wave) {
    std::vector<double> values;
    for (const double t : drive.time) values.push_back(wave(t));
    return recording::blockMeans(drive.channels.front(), drive.time, values);
}
// What the nominal car does.
inline Eigen::VectorXd nominalRows(const recording::RecordedDrive& drive, const VehicleParams& car) {
    return car.wheelbase * rowsOf(drive, ofWheelbase) + car.steering.ratio * rowsOf(drive, ofRatio) +
           car.aero.drag_area * rowsOf(drive, ofDrag) + car.steering.play * drive.speed * rowsOf(drive, ofSpeed);
}

}  // namespace tread::linear_car
