#include "diagnose/bench.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "diagnose/column_cache.h"
#include "diagnose/replay.h"
#include "identify/parallel.h"

namespace tread {
namespace {

constexpr double kSpeedStep = 0.1;  // m/s

constexpr double kAlikeSpeed = 0.03;  // by which repeats of a drive may differ, as a share

struct Piece {
    std::size_t drive;
    Eigen::Index parameter;
    double by;  // units
};

// Upwards, unless the parameter's limits leave room only below.
double stepOf(const Parameter& parameter, double at, double step) {
    if (at + step <= parameter.highest) return step;
    return at - step >= parameter.lowest ? -step : parameter.highest - at;
}

// One column of one drive, by a difference; to the other side where this one cannot be driven.
std::optional<Eigen::VectorXd> difference(Bench& bench, const Piece& one, const Subject& subject, const Log& motion,
                                          const Eigen::VectorXd& here) {
    const Parameter& parameter = bench.parameters[static_cast<std::size_t>(one.parameter)];
    const RecordedDrive& drive = bench.drives[one.drive];
    for (const double by : {one.by, -one.by}) {
        if (by == 0) break;
        Subject there = subject;
        move(there, parameter, by);
        const std::optional<Log> driven =
            parameter.instruments_only ? std::optional(motion) : motionAt(bench, one.drive, there);
        if (!driven) continue;
        const Eigen::VectorXd column = (readings(drive, *driven, there.instruments) - here) / by;
        if (column.allFinite()) return column;
    }
    return std::nullopt;
}

}  // namespace

bool Bench::compared() const {
    const auto one = [](const RecordedDrive& drive) { return drive.compared(); };
    return !drives.empty() && std::all_of(drives.begin(), drives.end(), one);
}

std::size_t Bench::firstLike(std::size_t drive) const {
    const RecordedDrive& here = drives[drive];
    for (std::size_t other = 0; other < drive && !here.recording->repeat_group.empty(); ++other) {
        const RecordedDrive& there = drives[other];
        const bool alike = there.recording->repeat_group == here.recording->repeat_group &&
                           std::abs(there.speed - here.speed) < kAlikeSpeed * here.speed &&
                           std::equal(here.channels.begin(), here.channels.end(), there.channels.begin(),
                                      there.channels.end(), [](const ObservedChannel& a, const ObservedChannel& b) {
                                          return a.name == b.name && a.times == b.times;
                                      });
        if (alike) return other;
    }
    return drive;
}

Subject Bench::subjectAt(const Deviation& point) const {
    Subject subject = nominal;
    for (Eigen::Index i = 0; i < point.size(); ++i) move(subject, parameters[static_cast<std::size_t>(i)], point(i));
    return subject;
}

std::optional<Log> motionAt(Bench& bench, std::size_t index, const Subject& subject, const Otherwise& otherwise) {
    ++bench.simulations;
    try {
        const auto simulate = [&](const VehicleParams& vehicle, const Scenario& scenario, const Recorder& recorder,
                                  const Pushing& pushing) {
            if (otherwise.faster == 0) return bench.simulate(vehicle, scenario, recorder, pushing);
            Scenario other = scenario;
            other.start.speed += otherwise.faster;
            bench.simulate(vehicle, other, recorder, pushing);
        };
        return replayed(bench.drives[index], subject, bench.nominal, bench.step, simulate, otherwise.pushing);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError&) {
        return std::nullopt;
    }
}

std::optional<Rows> rowsAt(Bench& bench, const Deviation& point) {
    const Subject subject = bench.subjectAt(point);
    Rows rows(bench.drives.size());
    std::atomic<bool> failed = false;
    inParallel(rows.size(), bench.threads, [&](std::size_t i) {
        const std::optional<Log> motion = motionAt(bench, i, subject);
        if (motion) rows[i] = readings(bench.drives[i], *motion, subject.instruments);
        else failed = true;
    });
    for (const Eigen::VectorXd& row : rows) failed = failed || !row.allFinite();
    if (failed) return std::nullopt;
    return rows;
}

Linearised linearised(Bench& bench, const Deviation& at, const Wanted& wanted,
                      const std::function<void(double)>& progress) {
    const Subject subject = bench.subjectAt(at);
    const std::size_t drives = bench.drives.size();
    Linearised result{at, Rows(drives), std::vector<Eigen::MatrixXd>(drives)};
    std::vector<std::optional<Log>> motions(drives);
    inParallel(drives, bench.threads, [&](std::size_t d) {
        motions[d] = motionAt(bench, d, subject);
        result.columns[d] = Eigen::MatrixXd::Zero(bench.drives[d].rows(), at.size());
        if (wanted.elsewhere) result.columns[d] = wanted.elsewhere->columns[d];
        if (motions[d]) result.rows[d] = readings(bench.drives[d], *motions[d], subject.instruments);
    });

    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < wanted.parameters.size(); ++i) {
        const Eigen::Index p = wanted.parameters[i];
        const double by = stepOf(bench.parameters[static_cast<std::size_t>(p)], at(p), wanted.step);
        for (std::size_t d = 0; d < drives; ++d) {
            const bool worth = wanted.worth.empty() || wanted.worth[i][d];
            if (motions[d] && worth && bench.firstLike(d) == d) pieces.push_back({d, p, by});
        }
    }
    std::vector<std::filesystem::path> kept(drives);
    for (std::size_t d = 0; d < drives && at.isZero(0); ++d) kept[d] = columnFolder(bench, d, subject);
    std::mutex guard;
    double done = 0;
    inParallel(pieces.size(), bench.threads, [&](std::size_t i) {
        const Piece& one = pieces[i];
        const Eigen::VectorXd& here = result.rows[one.drive];
        const auto column =
            keptColumn(kept[one.drive], bench.parameters[static_cast<std::size_t>(one.parameter)], one.by, here.size(),
                       [&] { return difference(bench, one, subject, *motions[one.drive], here); });
        if (column) result.columns[one.drive].col(one.parameter) = *column;
        const std::scoped_lock lock(guard);
        progress(++done / static_cast<double>(pieces.size()));
    });
    // Repeats of a drive answer alike.
    for (const Eigen::Index p : wanted.parameters) {
        for (std::size_t d = 0; d < drives; ++d)
            if (bench.firstLike(d) != d) result.columns[d].col(p) = result.columns[bench.firstLike(d)].col(p);
    }
    return result;
}

Eigen::VectorXd startSpeedColumn(Bench& bench, std::size_t drive, const Subject& subject, const Eigen::VectorXd& rows) {
    const std::optional<Log> faster = motionAt(bench, drive, subject, {.faster = kSpeedStep});
    if (!faster) return Eigen::VectorXd::Zero(bench.drives[drive].rows());
    return (readings(bench.drives[drive], *faster, subject.instruments) - rows) / kSpeedStep;
}

}  // namespace tread
