#include "diagnose/model/replays.h"

#include <algorithm>

#include "base/parallel.h"

namespace tread::diagnose::model {

Subject Replays::subjectAt(const Deviation& point, const RecordedDrive& drive) const {
    return movedIn(drive, nominal(), parameters, point);
}

std::optional<Log> motionAt(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                            const Variation& variation) {
    replays.simulations.add();
    try {
        if (variation.faster == 0) return recording::replayed(drive, subject, replays.replayer, variation.pushing);
        recording::Replayer replayer = replays.replayer;
        replayer.simulate = [&](const VehicleParams& vehicle, Scenario scenario, const Recorder& recorder,
                                const Pushing& pushing) {
            scenario.start.speed += variation.faster;
            replays.replayer.simulate(vehicle, scenario, recorder, pushing);
        };
        return recording::replayed(drive, subject, replayer, variation.pushing);
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError&) {
        return std::nullopt;
    }
}

std::optional<Rows> rowsAt(const Replays& replays, Drives drives, const Deviation& point) {
    Rows rows(drives.size());
    std::atomic<bool> failed = false;
    inParallel(rows.size(), replays.threads, [&](std::size_t d) {
        const Subject subject = replays.subjectAt(point, drives[d]);
        const std::optional<Log> motion = motionAt(replays, drives[d], subject);
        if (motion) rows[d] = recording::readings(drives[d], *motion, subject.instruments);
        else failed = true;
    });
    for (const Eigen::VectorXd& row : rows) failed = failed || !row.allFinite();
    if (failed) return std::nullopt;
    return rows;
}

}  // namespace tread::diagnose::model
