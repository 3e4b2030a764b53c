#include "blind/other_detectability.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/fields/numbers.h"
#include "base/threads/parallel.h"
#include "blind/drives/measure.h"
#include "blind/faults/drawn_case.h"
#include "blind/other_errors.h"
#include "blind/other_match.h"
#include "blind/world/instruments.h"
#include "diagnose/catalogue/effect.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::blind::detectability::detectabilities;
using tread::blind::detectability::Fault;
using tread::blind::detectability::faultAmong;
using tread::blind::detectability::products;
using tread::blind::detectability::Rival;
using tread::blind::drives::Drive;
using tread::blind::drives::kSpeedScatter;
using tread::blind::faults::sharePaths;
using tread::blind::world::autocovariance;
using tread::blind::world::blockCovariance;
using tread::blind::world::blockMeans;
using tread::blind::world::enginePhase;
using tread::blind::world::InstrumentSheet;
using tread::blind::world::instrumentSheets;
using tread::blind::world::kSourceSpeed;
using tread::blind::world::measuresDriver;
using tread::blind::world::PushSource;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using tread::recording::Subject;

constexpr double kPush = 100;       // N or N m, finite difference
constexpr double kFaster = 0.002;   // of the initial speed, finite difference
constexpr double kRivalStep = 0.1;  // of the typical size, finite difference

VectorXd rowsOf(const tread::Log& log) {
    std::vector<double> rows;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        if (measuresDriver(sheet)) continue;
        const VectorXd blocks = blockMeans(log.channels.front().values, log.find(std::string(sheet.channel))->values);
        rows.insert(rows.end(), blocks.begin(), blocks.end());
    }
    return Eigen::Map<const VectorXd>(rows.data(), static_cast<Index>(rows.size()));
}

// Noise of the data sheets, for each row of rowsOf().
VectorXd noiseOfRows(Index rows) {
    std::vector<double> noises;
    for (const InstrumentSheet& sheet : instrumentSheets())
        if (!measuresDriver(sheet)) noises.push_back(noiseOfMeans(sheet));
    const Index of_each = rows / static_cast<Index>(noises.size());
    VectorXd all(rows);
    for (Index i = 0; i < rows; ++i) all(i) = noises[static_cast<std::size_t>(i / of_each)];
    return all;
}

// ---- Columns that can absorb a change ------------------------------------------------------------------------------

// Differences of the shared numbers of two cars.
VectorXd between(const Subject& from, const Subject& to, const std::vector<std::string>& paths) {
    Subject before = from, after = to;
    VectorXd changes(static_cast<Index>(paths.size()));
    for (std::size_t i = 0; i < paths.size(); ++i)
        changes(static_cast<Index>(i)) =
            *tread::recording::numberAt(after, paths[i]) - *tread::recording::numberAt(before, paths[i]);
    return changes;
}

MatrixXd sideBySide(const std::vector<VectorXd>& columns) {
    MatrixXd all(columns.front().size(), static_cast<Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) all.col(static_cast<Index>(i)) = columns[i];
    return all;
}

MatrixXd openNumbers(const Subject& nominal, const std::vector<std::string>& paths) {
    Subject subject = nominal;
    std::vector<VectorXd> all;
    for (const tread::Number& number : tread::numbers(subject)) {
        const auto path = std::find(paths.begin(), paths.end(), number.path);
        const double stated = number.about.tolerance * std::abs(*number.value) / std::sqrt(3.0);
        const double sd = stated > 0 ? stated : spreadOf(number.path, *number.value);
        if (path == paths.end() || sd == 0) continue;
        all.push_back(sd * VectorXd::Unit(static_cast<Index>(paths.size()), path - paths.begin()));
    }
    return sideBySide(all);
}

MatrixXd ofCircumstances(const Subject& nominal, const std::vector<std::string>& paths, double Circumstance::*sd) {
    std::vector<VectorXd> all;
    for (const Circumstance& one : circumstances()) {
        if (one.*sd == 0) continue;
        Subject subject = nominal;
        one.apply(subject, one.*sd);
        all.push_back(between(nominal, subject, paths));
    }
    return sideBySide(all);
}

MatrixXd ofKnobs(const Subject& nominal, const std::vector<std::string>& paths,
                 const std::vector<tread::diagnose::catalogue::Effect>& effects) {
    std::vector<VectorXd> all;
    for (const tread::diagnose::catalogue::Effect& effect : effects) {
        for (const tread::diagnose::catalogue::Knob& knob : effect.knobs) {
            const double units =
                knob.direction == tread::diagnose::catalogue::Direction::down ? -kRivalStep : kRivalStep;
            Subject subject = nominal;
            move(subject, knob, units * knob.typical);
            all.push_back(between(nominal, subject, paths) / units);
        }
    }
    return sideBySide(all);
}

// Finite difference of each number: the largest of its usual changes; 0 for a number that nothing changes.
VectorXd stepsOf(const Directions& directions) {
    VectorXd steps = VectorXd::Zero(static_cast<Index>(directions.paths.size()));
    const MatrixXd knobs = kRivalStep * directions.knobs;
    for (const MatrixXd* all : {&directions.open, &directions.days, &directions.drives, &knobs}) {
        for (Index i = 0; i < steps.size(); ++i)
            if (steps(i) == 0) steps(i) = all->row(i).cwiseAbs().maxCoeff();
    }
    return steps;
}

// Changes of the rows of other cars that repeat the recorded inputs of the first.
MatrixXd again(const Drive& drive, const Truth& truth, std::size_t count,
               const std::function<Replayed(std::size_t i, const Recorded& recorded)>& other) {
    const Replayed first = replay(truth, drive);
    const VectorXd here = rowsOf(first.log);
    MatrixXd changes(here.size(), static_cast<Index>(count));
    tread::inParallel(count, 0, [&](std::size_t i) {
        changes.col(static_cast<Index>(i)) = rowsOf(other(i, first.recorded).log) - here;
    });
    return changes;
}

// Derivatives of the rows by the shared numbers.
MatrixXd columnsOf(const Drive& drive, const Truth& truth, const Subject& nominal, const Directions& directions) {
    const auto count = directions.paths.size();
    MatrixXd columns = again(drive, truth, count, [&](std::size_t i, const Recorded& recorded) {
        Subject changed = nominal;
        *tread::recording::numberAt(changed, directions.paths[i]) += directions.steps(static_cast<Index>(i));
        return replay(withChanges(truth, nominal, changed), drive, {.recorded = &recorded});
    });
    return columns * directions.steps.unaryExpr([](double step) { return step > 0 ? 1 / step : 0; }).asDiagonal();
}

tread::Pushing hat(std::size_t kind, std::size_t which) {
    return [=](double time, const tread::VehicleInput&, const tread::VehicleOutput&) {
        const double top = static_cast<double>(which) * kHatSpacing;
        const double size = kPush * std::max(0.0, 1 - std::abs(time + kStep / 2 - top) / kHatSpacing);
        tread::Push push;
        (kind == 0   ? push.force.x()
         : kind == 1 ? push.force.y()
         : kind == 2 ? push.moment.x()
                     : push.moment.z()) = size;
        return push;
    };
}

void takeHats(Pushed& one, const Truth& plain) {
    const tread::Log log = replay(plain, one.drive).log;
    const std::vector<double>&times = log.channels.front().values, &speed = log.find("chassis.vx")->values;
    const auto count = static_cast<std::size_t>(std::ceil(times.back() / kHatSpacing)) + 1;
    const auto rows_of_hat = static_cast<std::size_t>(std::lround(kHatSpacing / (kStep * kRowSteps)));
    double way = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (i % rows_of_hat == 0) one.speed.push_back(speed[i]), one.way.push_back(way);
        way += speed[i] * kStep * kRowSteps;
    }
    while (one.speed.size() < count) one.speed.push_back(speed.back()), one.way.push_back(way);
    for (std::size_t kind = 0; kind < one.hats.size(); ++kind) {
        one.hats[kind] = again(one.drive, plain, count, [&](std::size_t i, const Recorded& recorded) {
            return replay(plain, one.drive, {.recorded = &recorded, .push = hat(kind, i)});
        });
        one.hats[kind] /= kPush;
    }
}

// ---- One case ------------------------------------------------------------------------------------------------------

// Covariance of the heights of the hats of a source: of its means over the spacing of the hats.
MatrixXd covarianceOfHats(const PushSource& source, const Pushed& one) {
    constexpr int kPoints = 4;  // per side, of the triangular weight of the lag between two means
    const auto count = static_cast<Index>(one.speed.size());
    MatrixXd covariance(count, count);
    for (Index i = 0; i < count; ++i) {
        for (Index j = 0; j <= i; ++j) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
            const double apart =
                source.by_distance ? one.way[a] - one.way[b] : static_cast<double>(i - j) * kHatSpacing;
            const double width = kHatSpacing * (source.by_distance ? 0.5 * (one.speed[a] + one.speed[b]) : 1);
            double mean = 0;
            for (int k = -kPoints; k <= kPoints; ++k) {
                const double share = static_cast<double>(k) / (kPoints + 1);
                mean += (1 - std::abs(share)) / (kPoints + 1) * autocovariance(source, apart + share * width);
            }
            const double grows = one.speed[a] * one.speed[b] / (kSourceSpeed * kSourceSpeed);
            covariance(i, j) = covariance(j, i) = (source.by_speed ? grows : 1) * mean;
        }
    }
    return covariance;
}

// Columns of unit standard deviation: principal components of the pushes of all sources.
MatrixXd pushesOf(const Pushed& one, const std::vector<PushSource>& surroundings) {
    const Index count = one.hats[0].cols(), all = 4 * count;
    MatrixXd covariance = MatrixXd::Zero(all, all), responses(one.hats[0].rows(), all);
    for (Index kind = 0; kind < 4; ++kind)
        responses.middleCols(kind * count, count) = one.hats[static_cast<std::size_t>(kind)];
    for (const PushSource& source : surroundings) {
        const std::array<double, 4> push{source.push.force.x(), source.push.force.y(), source.push.moment.x(),
                                         source.push.moment.z()};
        const MatrixXd of_source = covarianceOfHats(source, one);
        for (Index i = 0; i < 4; ++i) {
            for (Index j = 0; j < 4; ++j)
                covariance.block(i * count, j * count, count, count) +=
                    push[static_cast<std::size_t>(i)] * push[static_cast<std::size_t>(j)] * of_source;
        }
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(covariance);
    const VectorXd sizes = parts.eigenvalues().cwiseMax(0).cwiseSqrt();  // ascending
    constexpr double kLeast = 0.01;  // of the largest standard deviation; smaller components are dropped
    Index kept = 0;
    while (kept < all && sizes(all - 1 - kept) > kLeast * sizes(all - 1)) ++kept;
    return responses * (parts.eigenvectors().rightCols(kept) * sizes.tail(kept).asDiagonal());
}

MatrixXd joined(const std::vector<MatrixXd>& parts) {
    Index columns = 0;
    for (const MatrixXd& part : parts) columns += part.cols();
    MatrixXd all(parts.front().rows(), columns);
    columns = 0;
    for (const MatrixXd& part : parts) all.middleCols(columns, part.cols()) = part, columns += part.cols();
    return all;
}

std::vector<MatrixXd> noiseOf(const ProvingGround& ground, const Replayed& replayed) {
    const std::vector<double>& times = replayed.log.channels.front().values;
    const std::vector<double> phase = enginePhase(times, replayed.engine_speed);
    std::vector<MatrixXd> covariances;
    for (std::size_t i = 0; i < ground.noise.size(); ++i) {
        const InstrumentSheet& sheet = instrumentSheets()[i];
        if (measuresDriver(sheet)) continue;
        const std::vector<double>& readings = replayed.log.find(std::string(sheet.channel))->values;
        covariances.push_back(blockCovariance(ground.noise[i], times, readings, phase));
    }
    return covariances;
}

MatrixXd productsOf(const Pushed& one, const Directions& directions, const Drawn& drawn, const ProvingGround& ground,
                    const std::vector<Fault>& faults) {
    const MatrixXd columns = columnsOf(one.drive, drivenCar(drawn, faultNames(drawn)), drawn.nominal, directions);
    const Replayed first = replay(drivenCar(drawn), one.drive);
    const VectorXd here = rowsOf(first.log);
    std::vector<VectorXd> changes;
    for (const Fault& fault : faults) {
        const Truth without = drivenCar(drawn, {fault.name});
        changes.push_back(here - rowsOf(replay(without, one.drive, {.recorded = &first.recorded}).log));
    }
    return products({.noise = noiseOf(ground, first),
                     .pushes = joined({pushesOf(one, ground.surroundings), columns * directions.drives, one.start}),
                     .tolerances = columns * joined({directions.open, directions.days}),
                     .rivals = columns * directions.knobs,
                     .changes = sideBySide(changes),
                     .times = static_cast<double>(one.drive.repeats)});
}

std::vector<Fault> faultsOf(const Directions& directions, const Drawn& drawn) {
    std::vector<Fault> faults;
    for (const Drawn::Planted& one : drawn.planted) {
        faults.push_back(faultAmong(drawn.key.effects, one.effect.name));
        for (const tread::diagnose::catalogue::Effect& other : directions.effects) {
            if (sharePaths(one.effect, other)) faults.back().excluded_rivals.push_back(other.name);
        }
    }
    if (drawn.outsider) faults.push_back(faultAmong(drawn.key.effects, drawn.outsider->name));
    return faults;
}

// Products with references: twice the noise, twice the variance of a day, no other uncertain number.
MatrixXd withReferences(const MatrixXd& products, Index open, Index days) {
    const Index rest = products.cols() - open;
    VectorXd scale = VectorXd::Ones(rest);
    scale.head(days).setConstant(std::sqrt(2.0));
    return 0.5 * scale.asDiagonal() * products.bottomRightCorner(rest, rest) * scale.asDiagonal();
}

}  // namespace

Directions directionsOf(const Subject& nominal, const std::vector<tread::diagnose::catalogue::Effect>& effects) {
    Directions directions;
    directions.effects = effects;
    Truth any;
    Subject subject = nominal;
    for (const SharedNumber& shared : sharedNumbers(any)) {
        if (tread::recording::numberAt(subject, shared.path)) directions.paths.push_back(shared.path);
    }
    directions.open = openNumbers(nominal, directions.paths);
    directions.days = ofCircumstances(nominal, directions.paths, &Circumstance::each_day);
    directions.drives = ofCircumstances(nominal, directions.paths, &Circumstance::each_drive);
    directions.knobs = ofKnobs(nominal, directions.paths, effects);
    directions.steps = stepsOf(directions);
    Index column = 0;
    for (const tread::diagnose::catalogue::Effect& effect : effects) {
        Rival& rival = directions.rivals.emplace_back(Rival{effect.name, {}});
        for (std::size_t i = 0; i < effect.knobs.size(); ++i) rival.columns.push_back(column++);
    }
    return directions;
}

std::vector<Pushed> pushedDrives(const Truth& plain, const std::vector<Drive>& drives) {
    std::vector<Pushed> pushed;
    for (const Drive& drive : drives) {
        if (drive.hold_out) continue;
        Pushed& one = pushed.emplace_back();
        one.drive = drive;
        takeHats(one, plain);
        one.start = again(drive, plain, 1, [&](std::size_t, const Recorded& recorded) {
            return replay(plain, drive, {.recorded = &recorded, .faster = kFaster});
        });
        one.start *= kSpeedScatter / kFaster;
    }
    return pushed;
}

std::vector<tread::diagnose::catalogue::Effect> detectableEffects(const Truth& plain, const Subject& nominal,
                                                                  const Directions& directions,
                                                                  const std::vector<Drive>& drives) {
    constexpr double kLeastChange = 200;  // sum of squared changes of all readings over their noise
    VectorXd sums = VectorXd::Zero(directions.knobs.cols());
    for (const Drive& drive : drives) {
        if (drive.hold_out) continue;
        const MatrixXd knobs = columnsOf(drive, plain, nominal, directions) * directions.knobs;
        sums += (noiseOfRows(knobs.rows()).cwiseInverse().asDiagonal() * knobs).colwise().squaredNorm().transpose();
    }
    std::vector<tread::diagnose::catalogue::Effect> effects;
    for (std::size_t i = 0; i < directions.effects.size(); ++i) {
        double sum = 0;
        for (const Index column : directions.rivals[i].columns) sum += sums(column);
        if (sum >= kLeastChange) effects.push_back(directions.effects[i]);
    }
    return effects;
}

Shown shown(const std::vector<Pushed>& pushed, const Directions& directions, const Drawn& drawn,
            const ProvingGround& ground) {
    const std::vector<Fault> faults = faultsOf(directions, drawn);
    if (faults.empty()) return {};
    std::vector<MatrixXd> all;
    for (const Pushed& one : pushed) all.push_back(productsOf(one, directions, drawn, ground, faults));
    MatrixXd sum = all.front();
    for (std::size_t i = 1; i < all.size(); ++i) sum += all[i];
    const Index open = directions.open.cols(), days = directions.days.cols();
    return {detectabilities(withReferences(sum, open, days), days, directions.rivals, faults),
            detectabilities(sum, open + days, directions.rivals, faults)};
}

}  // namespace other_car
