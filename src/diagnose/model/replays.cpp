#include "diagnose/model/replays.h"

#include <algorithm>

#include "recording/reference.h"
#include "run/together.h"

namespace tread::diagnose::model {
namespace {
constexpr double kLongestTimeStep = 0.01;  // s
}

Subject Replays::subjectAt(const Deviation& point, const RecordedDrive& drive) const {
    return movedIn(drive, nominal(), parameters, point);
}

std::optional<Log> motionAt(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                            const Variation& variation) {
    replays.simulations.add();
    try {
        recording::Replayer replayer = replays.replayer;
        replayer.faster = variation.faster;
        if (variation.coarse) replayer.step = std::max(replayer.step, std::min(2 * replayer.step, kLongestTimeStep));
        return recording::replayed(drive, subject, replayer, variation.pushing);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError&) {
        return std::nullopt;
    }
}

std::optional<Eigen::VectorXd> changeByReference(const Replays& replays, const RecordedDrive& drive,
                                                 const Deviation& point) {
    Deviation of_both = point;
    for (Eigen::Index i = 0; i < point.size(); ++i)
        if (!replays.parameters[i].of_both) of_both(i) = 0;
    if (!drive.reference || of_both.isZero(0)) return Eigen::VectorXd();
    const RecordedDrive& reference = drive.reference->drive;
    const Subject subject = replays.subjectAt(of_both, reference);
    const std::optional<Log> motion = motionAt(replays, reference, subject);
    if (!motion) return std::nullopt;
    const Eigen::VectorXd rows = recording::readings(reference, *motion, subject.instruments);
    return recording::atRowsOf(drive, reference, drive.reference->nominal - rows);
}

std::optional<Eigen::VectorXd> rowsOf(const Replays& replays, const RecordedDrive& drive, const Deviation& point) {
    const Subject subject = replays.subjectAt(point, drive);
    const std::optional<Log> motion = motionAt(replays, drive, subject);
    const std::optional<Eigen::VectorXd> change = changeByReference(replays, drive, point);
    if (!motion || !change) return std::nullopt;
    Eigen::VectorXd rows = recording::readings(drive, *motion, subject.instruments);
    if (change->size() > 0) rows += *change;
    return rows;
}

std::optional<Rows> rowsAt(const Replays& replays, Drives drives, const Deviation& point) {
    return std::move(rowsAt(replays, drives, std::vector{point}).front());
}

std::vector<std::optional<Rows>> rowsAt(const Replays& replays, Drives drives, const std::vector<Deviation>& points) {
    std::vector<std::vector<std::optional<Eigen::VectorXd>>> rows(
        points.size(), std::vector<std::optional<Eigen::VectorXd>>(drives.size()));
    drivenTogether(points.size() * drives.size(), replays.threads, [&](std::size_t i) {
        const std::size_t p = i / drives.size(), d = i % drives.size();
        rows[p][d] = rowsOf(replays, drives[d], points[p]);
    });
    std::vector<std::optional<Rows>> all(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        const auto fails = [](const std::optional<Eigen::VectorXd>& one) { return !one || !one->allFinite(); };
        if (std::any_of(rows[p].begin(), rows[p].end(), fails)) continue;
        all[p].emplace();
        for (std::optional<Eigen::VectorXd>& one : rows[p]) all[p]->push_back(std::move(*one));
    }
    return all;
}

}  // namespace tread::diagnose::model
