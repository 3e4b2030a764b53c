#include "diagnose/model/sensitivities.h"

#include <mutex>
#include <numeric>

#include "diagnose/model/sensitivity_cache.h"
#include "run/together.h"

namespace tread::diagnose::model {
namespace {

// One column of one drive.
struct Column {
    std::size_t drive, wanted;  // `wanted`: place among the parameters asked for
    Eigen::Index parameter;
    double by;  // step of the difference, in units of the parameter
};

// Upwards, or downwards if the limits leave room only below; up to the upper limit if neither step fits.
double stepOf(const Parameter& parameter, double at, double step) {
    if (at + step <= parameter.highest) return step;
    return at - step >= parameter.lowest ? -step : parameter.highest - at;
}

std::vector<Column> columnsToDrive(const Replays& replays, Drives drives, const Deviation& at, const Wanted& wanted,
                                   const std::vector<Base>& bases) {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < wanted.parameters.size(); ++i) {
        const Eigen::Index p = wanted.parameters[i];
        const double by = stepOf(replays.parameters[p], at(p), wanted.step);
        for (std::size_t d = 0; d < drives.size(); ++d) {
            const Parameter& parameter = replays.parameters[p];
            const bool worth = wanted.worth.empty() || wanted.worth[i][d];
            const bool own = parameter.only ? parameter.concerns(drives[d]) : recording::firstLike(drives, d) == d;
            if (bases[d].motion && worth && own) columns.push_back({d, i, p, by});
        }
    }
    return columns;
}

// The finite difference of a column. It is taken with the opposite step when the drive fails; nothing when both fail
// (D18).
DrivenColumn difference(const Replays& replays, const RecordedDrive& drive, const Column& column, const Base& base) {
    const Parameter& parameter = replays.parameters[column.parameter];
    int simulations = 0;
    for (const double by : {column.by, -column.by}) {
        if (by == 0) break;
        Subject there = base.subject;
        move(there, parameter, by);
        simulations += parameter.instruments_only ? 0 : 1;
        const std::optional<Log> driven =
            parameter.instruments_only ? base.motion : motionAt(replays, drive, there, {.coarse = base.coarse});
        if (!driven) continue;
        Eigen::VectorXd change = recording::readings(drive, *driven, there.instruments) - base.rows;
        if (parameter.of_both) {
            Deviation moved = replays.origin();
            moved(column.parameter) = by;
            simulations += drive.reference ? 1 : 0;
            const std::optional<Eigen::VectorXd> in_reference = changeByReference(replays, drive, moved);
            if (!in_reference) continue;
            if (in_reference->size() > 0) change += *in_reference;
        }
        if (change.allFinite()) return {change / by, simulations};
    }
    return {std::nullopt, simulations};
}

// Where the columns are written: of each drive, at the places of the parameters asked for.
struct Columns {
    std::vector<Eigen::MatrixXd>& of_drives;
    std::vector<Eigen::Index> places;

    auto at(std::size_t drive, std::size_t wanted) { return of_drives[drive].col(places[wanted]); }
};

void repeatsAnswerAlike(const Replays& replays, Drives drives, const std::vector<Eigen::Index>& parameters,
                        Columns& columns) {
    for (std::size_t d = 0; d < drives.size(); ++d) {
        const std::size_t first = recording::firstLike(drives, d);
        if (first == d) continue;
        for (std::size_t i = 0; i < parameters.size(); ++i)
            if (!replays.parameters[parameters[i]].only) columns.at(d, i) = columns.at(first, i);
    }
}

// Replays of the drives at a point, and with `rows` also the rows there.
std::vector<Base> basesAt(const Replays& replays, Drives drives, const Deviation& at, Rows* rows = nullptr) {
    std::vector<Base> bases(drives.size());
    drivenTogether((rows ? 2 : 1) * drives.size(), replays.threads, [&](std::size_t i) {
        const std::size_t d = i % drives.size();
        if (i < drives.size()) bases[d] = baseOf(replays, drives[d], replays.subjectAt(at, drives[d]));
        else if (std::optional<Eigen::VectorXd> there = rowsOf(replays, drives[d], at)) (*rows)[d] = std::move(*there);
    });
    return bases;
}

// Computes the columns that are wanted; the others stay.
void fill(Columns columns, const Replays& replays, Drives drives, const Deviation& at, const Wanted& wanted,
          const std::vector<Base>& bases, const std::function<void(double)>& progress) {
    const std::vector<Column> all = columnsToDrive(replays, drives, at, wanted, bases);
    std::vector<std::filesystem::path> kept(drives.size());
    for (std::size_t d = 0; d < drives.size() && at.isZero(0); ++d)
        kept[d] = columnFolder(replays, drives[d], bases[d].subject);
    std::mutex guard;
    double done = 0;
    drivenTogether(all.size(), replays.threads, [&](std::size_t i) {
        const Column& one = all[i];
        const RecordedDrive& drive = drives[one.drive];
        const Base& base = bases[one.drive];
        bool made = false;
        const DrivenColumn column =
            keptColumn(kept[one.drive], replays.parameters[one.parameter], one.by, base.rows.size(), [&] {
                made = true;
                return difference(replays, drive, one, base);
            });
        // A kept column counts like a new one: the answer does not depend on what was kept.
        if (!made) replays.simulations.add(column.simulations);
        if (column.values) columns.at(one.drive, one.wanted) = *column.values;
        const std::scoped_lock lock(guard);
        progress(++done / static_cast<double>(all.size()));
    });
    repeatsAnswerAlike(replays, drives, wanted.parameters, columns);
}

}  // namespace

std::vector<std::vector<bool>> onlyIn(const std::vector<bool>& drives, std::size_t parameters) {
    return std::vector(parameters, drives);
}

Sensitivities sensitivities(const Replays& replays, Drives drives, const Deviation& at, const Wanted& wanted,
                            const std::function<void(double)>& progress) {
    const std::size_t n = drives.size();
    Sensitivities result{at, Rows(n), std::vector<Eigen::MatrixXd>(n)};
    if (wanted.rows) result.rows = *wanted.rows;
    const std::vector<Base> bases = basesAt(replays, drives, at, wanted.rows ? nullptr : &result.rows);
    for (std::size_t d = 0; d < n; ++d)
        result.columns[d] =
            wanted.elsewhere ? wanted.elsewhere->columns[d] : Eigen::MatrixXd::Zero(drives[d].rows(), at.size()).eval();
    fill({result.columns, wanted.parameters}, replays, drives, at, wanted, bases, progress);
    return result;
}

std::vector<Eigen::MatrixXd> columnsAt(const Replays& replays, Drives drives, const Deviation& at,
                                       const std::vector<Eigen::Index>& parameters, double step) {
    std::vector<Eigen::MatrixXd> columns;
    for (const RecordedDrive& one : drives)
        columns.emplace_back(Eigen::MatrixXd::Zero(one.rows(), std::ssize(parameters)));
    if (parameters.empty()) return columns;
    std::vector<Eigen::Index> places(parameters.size());
    std::iota(places.begin(), places.end(), 0);
    fill({columns, std::move(places)}, replays, drives, at, {.parameters = parameters, .step = step},
         basesAt(replays, drives, at), [](double) {});
    return columns;
}

Base baseOf(const Replays& replays, const RecordedDrive& drive, Subject subject) {
    Base base{.subject = std::move(subject)};
    base.motion = motionAt(replays, drive, base.subject, {.coarse = true});
    if (!base.motion) {
        base.coarse = false;
        base.motion = motionAt(replays, drive, base.subject);
    }
    if (base.motion) base.rows = recording::readings(drive, *base.motion, base.subject.instruments);
    return base;
}

Eigen::VectorXd startSpeedColumn(const Replays& replays, const RecordedDrive& drive, const Base& base) {
    const std::optional<Log> faster =
        motionAt(replays, drive, base.subject, {.faster = kStartSpeedStep, .coarse = base.coarse});
    if (!faster) return Eigen::VectorXd::Zero(drive.rows());
    return (recording::readings(drive, *faster, base.subject.instruments) - base.rows) / kStartSpeedStep;
}

}  // namespace tread::diagnose::model
