#include "blind/detectability/noise_and_pushes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "blind/drives/measure.h"
#include "blind/world/disturbance.h"
#include "blind/world/instruments.h"
#include "log/resample.h"

namespace tread::blind::detectability {
namespace {

using drives::kEngineSpeed;
using drives::kSpeedScatter;
using world::assumedNoise;
using world::autocovariance;
using world::blockCovariance;
using world::Disturbance;
using world::enginePhase;
using world::instrumentSheets;
using world::kSourceSpeed;
using world::measuresDriver;
using world::PushSource;
using world::ReadingNoise;
using world::Truth;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLeastShare = 1e-3;  // of a process's variance; principal components with less are dropped

// A random process of unit size that pushes in one direction.
struct Process {
    Push push;
    bool by_speed, by_distance;  // as in PushSource
    std::function<double(double apart)> autocovariance;
};

std::vector<Process> processesOf(const Truth& truth) {
    std::vector<Process> processes;
    if (truth.own) {
        for (const PushSource& source : truth.own->surroundings)
            processes.push_back({source.push, source.by_speed, source.by_distance,
                                 [&source](double apart) { return autocovariance(source, apart); }});
        return processes;
    }
    const Disturbance usual;
    const auto fades = [=](double apart) { return std::exp(-std::abs(apart) / usual.correlation_time); };
    for (const Push& push : {Push{.force = {usual.fx, 0, 0}}, Push{.force = {0, usual.fy, 0}},
                             Push{.moment = {usual.roll_moment, 0, 0}}, Push{.moment = {0, 0, usual.yaw_moment}}})
        processes.push_back({push, false, false, fades});
    return processes;
}

// Covariance of the heights of the hats by which a process is interpolated: that of its values at their peaks. With
// kHatSpacing of 0.1 s this keeps what varies below 5 Hz; a car hardly follows anything faster.
MatrixXd covarianceOfHats(const Process& process, const ExaminedDrive& drive, Index hats) {
    std::vector<double> way(drive.times.size());
    for (std::size_t i = 1; i < way.size(); ++i)
        way[i] = way[i - 1] + (drive.times[i] - drive.times[i - 1]) * drive.speed[i];
    VectorXd place(hats), size(hats);
    for (Index i = 0; i < hats; ++i) {
        const double time = std::min(static_cast<double>(i) * kHatSpacing, drive.times.back());
        place(i) = process.by_distance ? valueAt(drive.times, way, time) : time;
        size(i) = process.by_speed ? valueAt(drive.times, drive.speed, time) / kSourceSpeed : 1;
    }
    MatrixXd covariance(hats, hats);
    for (Index i = 0; i < hats; ++i) {
        for (Index j = 0; j <= i; ++j)
            covariance(i, j) = covariance(j, i) = size(i) * size(j) * process.autocovariance(place(i) - place(j));
    }
    return covariance;
}

// Columns of unit standard deviation: the principal components of a process.
MatrixXd columnsOf(const Process& process, const ExaminedDrive& drive) {
    const Vector3 &force = process.push.force / kUnitPush, &moment = process.push.moment / kUnitPush;
    const MatrixXd response = force.x() * drive.by_hat[0] + force.y() * drive.by_hat[1] + moment.x() * drive.by_hat[2] +
                              moment.z() * drive.by_hat[3];
    const Eigen::SelfAdjointEigenSolver<MatrixXd> components(covarianceOfHats(process, drive, response.cols()));
    const VectorXd& variances = components.eigenvalues();  // ascending
    Index kept = 0;
    while (kept < variances.size() && variances(variances.size() - 1 - kept) > kLeastShare * variances.sum()) ++kept;
    return response * (components.eigenvectors().rightCols(kept) * variances.tail(kept).cwiseSqrt().asDiagonal());
}

MatrixXd sideBySide(const std::vector<MatrixXd>& parts) {
    Index columns = 0;
    for (const MatrixXd& part : parts) columns += part.cols();
    MatrixXd all(parts.front().rows(), columns);
    Index first = 0;
    for (const MatrixXd& part : parts) all.middleCols(first, part.cols()) = part, first += part.cols();
    return all;
}

MatrixXd pushesOf(const Truth& truth, const ExaminedDrive& drive) {
    std::vector<MatrixXd> parts;
    for (const Process& process : processesOf(truth)) parts.push_back(columnsOf(process, drive));
    if (truth.own) parts.push_back(drive.differences);
    parts.push_back(kSpeedScatter * drive.drive.scenario.start.speed * drive.by_start_speed);
    return sideBySide(parts);
}

std::vector<MatrixXd> noiseOf(const Truth& truth, const Log& readings) {
    const std::vector<ReadingNoise> noises = truth.own ? truth.own->noise : assumedNoise();
    const std::vector<double>& times = readings.channels.front().values;
    const std::vector<double> phase = enginePhase(times, readings.find(kEngineSpeed)->values);
    std::vector<MatrixXd> covariances;
    for (std::size_t i = 0; i < noises.size(); ++i) {
        if (measuresDriver(instrumentSheets()[i])) continue;
        covariances.push_back(
            blockCovariance(noises[i], times, readings.find(instrumentSheets()[i].channel)->values, phase));
    }
    return covariances;
}

}  // namespace

DriveColumns noiseAndPushes(const ExaminedDrive& drive, const Truth& truth, const Log& readings) {
    return {.noise = noiseOf(truth, readings),
            .pushes = pushesOf(truth, drive),
            .tolerances = {},
            .rivals = {},
            .changes = {},
            .times = static_cast<double>(drive.drive.repeats)};
}

}  // namespace tread::blind::detectability
