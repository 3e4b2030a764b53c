#include "diagnose/bench.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "diagnose/replay.h"
#include "identify/parallel.h"

namespace tread {
namespace {

// Steps of the differences, in units: small against what bends the response, large against what jumps in a replay.
constexpr double kCentralStep = 0.3;
constexpr double kOneSidedStep = 0.6;
constexpr double kSpeedStep = 0.1;  // m/s

struct Piece {
    std::size_t drive;
    Eigen::Index parameter;
    double above, below;  // steps, in units
};

// Where the limits of a parameter leave room for a step.
Piece piece(const Parameter& parameter, double at, Difference difference) {
    Piece piece{0, 0, kCentralStep, kCentralStep};
    if (difference == Difference::one_sided) piece.above = kOneSidedStep, piece.below = 0;
    if (at + piece.above > parameter.highest) piece = {0, 0, 0, kOneSidedStep};
    if (at - piece.below < parameter.lowest) piece = {0, 0, std::min(kOneSidedStep, parameter.highest - at), 0};
    return piece;
}

}  // namespace

Subject Bench::subjectAt(const Deviation& point) const {
    Subject subject = nominal;
    for (Eigen::Index i = 0; i < point.size(); ++i) move(subject, parameters[static_cast<std::size_t>(i)], point(i));
    return subject;
}

std::optional<Log> motionAt(Bench& bench, std::size_t index, const Subject& subject, double faster) {
    ++bench.simulations;
    try {
        if (faster == 0) return replayed(bench.drives[index], subject, bench.nominal, bench.step, bench.simulate);
        RecordedDrive drive = bench.drives[index];
        drive.speed += faster;
        return replayed(drive, subject, bench.nominal, bench.step, bench.simulate);
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

Linearised linearised(Bench& bench, const Deviation& at, const std::vector<Eigen::Index>& parameters,
                      Difference difference, const std::function<void(double)>& progress) {
    const Subject subject = bench.subjectAt(at);
    Linearised result{at, Rows(bench.drives.size()), std::vector<Eigen::MatrixXd>(bench.drives.size())};
    std::vector<std::optional<Log>> motions(bench.drives.size());
    inParallel(bench.drives.size(), bench.threads, [&](std::size_t i) {
        motions[i] = motionAt(bench, i, subject);
        result.columns[i] = Eigen::MatrixXd::Zero(bench.drives[i].rows(), at.size());
        if (motions[i]) result.rows[i] = readings(bench.drives[i], *motions[i], subject.instruments);
    });

    std::vector<Piece> pieces;
    for (const Eigen::Index p : parameters) {
        const Piece one = piece(bench.parameters[static_cast<std::size_t>(p)], at(p), difference);
        for (std::size_t drive = 0; drive < bench.drives.size(); ++drive)
            if (motions[drive]) pieces.push_back({drive, p, one.above, one.below});
    }
    std::mutex guard;
    double done = 0;
    inParallel(pieces.size(), bench.threads, [&](std::size_t i) {
        const Piece& one = pieces[i];
        const Parameter& parameter = bench.parameters[static_cast<std::size_t>(one.parameter)];
        const RecordedDrive& drive = bench.drives[one.drive];
        const auto rows = [&](double by) -> std::optional<Eigen::VectorXd> {
            if (by == 0) return result.rows[one.drive];
            Subject there = subject;
            move(there, parameter, by);
            if (parameter.instruments_only) return readings(drive, *motions[one.drive], there.instruments);
            const std::optional<Log> motion = motionAt(bench, one.drive, there);
            if (!motion) return std::nullopt;
            return readings(drive, *motion, there.instruments);
        };
        const auto above = rows(one.above), below = rows(-one.below);
        // Where one side cannot be driven the other must do.
        if (above && below) result.columns[one.drive].col(one.parameter) = (*above - *below) / (one.above + one.below);
        else if (above) result.columns[one.drive].col(one.parameter) = (*above - result.rows[one.drive]) / one.above;
        else if (below) result.columns[one.drive].col(one.parameter) = (result.rows[one.drive] - *below) / one.below;
        if (!result.columns[one.drive].col(one.parameter).allFinite())
            result.columns[one.drive].col(one.parameter).setZero();
        const std::scoped_lock lock(guard);
        progress(++done / static_cast<double>(pieces.size()));
    });
    return result;
}

Eigen::VectorXd startSpeedColumn(Bench& bench, std::size_t drive) {
    const RecordedDrive& here = bench.drives[drive];
    const auto nominal = motionAt(bench, drive, bench.nominal),
               faster = motionAt(bench, drive, bench.nominal, kSpeedStep);
    if (!nominal || !faster) return Eigen::VectorXd::Zero(here.rows());
    return (readings(here, *faster, bench.nominal.instruments) - readings(here, *nominal, bench.nominal.instruments)) /
           kSpeedStep;
}

}  // namespace tread
