#include "blind/other_shows.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/numbers.h"
#include "base/parallel.h"
#include "blind/gauges.h"
#include "blind/measure.h"
#include "blind/other_errors.h"
#include "blind/other_match.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/model/parameter.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::diagnose::model::knobsOf;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using tread::recording::Subject;

constexpr double kPush = 100;       // N, N m, of the differences
constexpr double kFaster = 0.002;   // of the speed, of the differences
constexpr double kRivalStep = 0.1;  // of the typical size, of the differences

VectorXd rowsOf(const tread::Log& log) {
    std::vector<double> rows;
    for (const tread::Gauge& gauge : tread::gauges()) {
        if (tread::isOfTheDriver(gauge)) continue;
        const VectorXd blocks =
            tread::shownBlocks(log.channels.front().values, log.find(std::string(gauge.channel))->values);
        rows.insert(rows.end(), blocks.begin(), blocks.end());
    }
    return Eigen::Map<const VectorXd>(rows.data(), static_cast<Index>(rows.size()));
}

// As the data sheets say, in the order of rowsOf().
VectorXd noiseOfRows(Index rows) {
    std::vector<double> noises;
    for (const tread::Gauge& gauge : tread::gauges())
        if (!tread::isOfTheDriver(gauge)) noises.push_back(noiseOfMeans(gauge));
    const Index of_each = rows / static_cast<Index>(noises.size());
    VectorXd all(rows);
    for (Index i = 0; i < rows; ++i) all(i) = noises[static_cast<std::size_t>(i / of_each)];
    return all;
}

// ---- What can absorb a change --------------------------------------------------------------------------------------

// Another car, driven with the same recorded inputs; its change is that of `units` of the column.
struct Difference {
    Truth truth;
    double units = 1;
    tread::Pushing push = {};
    double faster = 0;
};

std::vector<Difference> openNumbers(const Truth& plain, const Subject& nominal) {
    Truth any;
    const std::vector<SharedNumber> shared = sharedNumbers(any);
    Subject subject = nominal;
    std::vector<Difference> all;
    for (const tread::Number& number : tread::numbers(subject)) {
        const bool has =
            std::any_of(shared.begin(), shared.end(), [&](const auto& s) { return s.path == number.path; });
        const double stated = number.about.tolerance * std::abs(*number.value) / std::sqrt(3.0);
        const double sd = stated > 0 ? stated : spreadOf(number.path, *number.value);
        if (!has || sd == 0) continue;
        const double value = *number.value;
        *number.value += sd;
        all.push_back({withChanges(plain, nominal, subject)});
        *number.value = value;
    }
    return all;
}

std::vector<Difference> circumstancesOf(const Truth& plain, const Subject& nominal, double Circumstance::*sd) {
    std::vector<Difference> all;
    for (const Circumstance& one : circumstances()) {
        if (one.*sd == 0) continue;
        Subject subject = nominal;
        one.apply(subject, one.*sd);
        all.push_back({withChanges(plain, nominal, subject)});
    }
    return all;
}

std::vector<Difference> knobsOf(const Truth& plain, const Subject& nominal,
                                const std::vector<tread::diagnose::catalogue::Effect>& effects) {
    std::vector<Difference> all;
    for (const tread::diagnose::catalogue::Effect& effect : effects) {
        for (const tread::diagnose::catalogue::Knob& knob : effect.knobs) {
            const double units =
                knob.direction == tread::diagnose::catalogue::Direction::down ? -kRivalStep : kRivalStep;
            Subject subject = nominal;
            move(subject, knob, units * knob.typical);
            all.push_back({withChanges(plain, nominal, subject), units});
        }
    }
    return all;
}

tread::Pushing hat(std::size_t kind, std::size_t which) {
    return [=](double time, const tread::VehicleInput&, const tread::VehicleOutput&) {
        const double top = static_cast<double>(which) * kHat;
        const double size = kPush * std::max(0.0, 1 - std::abs(time + kStep / 2 - top) / kHat);
        tread::Push push;
        (kind == 0   ? push.force.x()
         : kind == 1 ? push.force.y()
         : kind == 2 ? push.moment.x()
                     : push.moment.z()) = size;
        return push;
    };
}

MatrixXd columnsOf(const tread::Drive& drive, const Truth& plain, const std::vector<Difference>& differences) {
    const Replayed first = replay(plain, drive);
    const VectorXd here = rowsOf(first.log);
    MatrixXd columns(here.size(), static_cast<Index>(differences.size()));
    tread::inParallel(differences.size(), 0, [&](std::size_t i) {
        const Difference& one = differences[i];
        const Replayed again =
            replay(one.truth, drive, {.recorded = &first.recorded, .push = one.push, .faster = one.faster});
        columns.col(static_cast<Index>(i)) = (rowsOf(again.log) - here) / one.units;
    });
    return columns;
}

void takeHats(Absorbing& one, const Truth& plain) {
    const tread::Log log = replay(plain, one.drive).log;
    const std::vector<double>&times = log.channels.front().values, &speed = log.find("chassis.vx")->values;
    const auto count = static_cast<std::size_t>(std::ceil(times.back() / kHat)) + 1;
    const auto rows_of_hat = static_cast<std::size_t>(std::lround(kHat / (kStep * kRowSteps)));
    double way = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (i % rows_of_hat == 0) one.speed.push_back(speed[i]), one.way.push_back(way);
        way += speed[i] * kStep * kRowSteps;
    }
    while (one.speed.size() < count) one.speed.push_back(speed.back()), one.way.push_back(way);
    for (std::size_t kind = 0; kind < one.hats.size(); ++kind) {
        std::vector<Difference> pushed;
        for (std::size_t i = 0; i < count; ++i) pushed.push_back({plain, kPush, hat(kind, i)});
        one.hats[kind] = columnsOf(one.drive, plain, pushed);
    }
}

// ---- One case ------------------------------------------------------------------------------------------------------

// Covariance of the heights of the hats of a source: of its means over the width of a hat.
MatrixXd covarianceOfHats(const tread::PushSource& source, const Absorbing& one) {
    constexpr int kPoints = 4;  // to each side, of the triangle that two means make
    const auto count = static_cast<Index>(one.speed.size());
    MatrixXd covariance(count, count);
    for (Index i = 0; i < count; ++i) {
        for (Index j = 0; j <= i; ++j) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
            const double apart = source.by_distance ? one.way[a] - one.way[b] : static_cast<double>(i - j) * kHat;
            const double width = kHat * (source.by_distance ? 0.5 * (one.speed[a] + one.speed[b]) : 1);
            double mean = 0;
            for (int k = -kPoints; k <= kPoints; ++k) {
                const double share = static_cast<double>(k) / (kPoints + 1);
                mean += (1 - std::abs(share)) / (kPoints + 1) * tread::autocovariance(source, apart + share * width);
            }
            const double grows = one.speed[a] * one.speed[b] / (tread::kSourceSpeed * tread::kSourceSpeed);
            covariance(i, j) = covariance(j, i) = (source.by_speed ? grows : 1) * mean;
        }
    }
    return covariance;
}

// Columns of standard deviation 1 of all that pushes and of what differs from drive to drive.
MatrixXd pushesOf(const Absorbing& one, const std::vector<tread::PushSource>& surroundings) {
    const Index count = one.hats[0].cols(), all = 4 * count;
    MatrixXd covariance = MatrixXd::Zero(all, all), responses(one.hats[0].rows(), all);
    for (Index kind = 0; kind < 4; ++kind)
        responses.middleCols(kind * count, count) = one.hats[static_cast<std::size_t>(kind)];
    for (const tread::PushSource& source : surroundings) {
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
    const VectorXd sizes = parts.eigenvalues().cwiseMax(0).cwiseSqrt();  // rising
    constexpr double kLeast = 0.01;                                      // of the largest: smaller ones are left out
    Index kept = 0;
    while (kept < all && sizes(all - 1 - kept) > kLeast * sizes(all - 1)) ++kept;
    MatrixXd columns(responses.rows(), kept + one.drives.cols());
    columns << responses * (parts.eigenvectors().rightCols(kept) * sizes.tail(kept).asDiagonal()), one.drives;
    return columns;
}

std::vector<MatrixXd> noiseOf(const ProvingGround& ground, const Replayed& replayed) {
    const std::vector<double>& times = replayed.log.channels.front().values;
    const std::vector<double> phase = tread::enginePhase(times, replayed.engine_speed);
    std::vector<MatrixXd> covariances;
    for (std::size_t i = 0; i < ground.noise.size(); ++i) {
        const tread::Gauge& gauge = tread::gauges()[i];
        if (tread::isOfTheDriver(gauge)) continue;
        const std::vector<double>& readings = replayed.log.find(std::string(gauge.channel))->values;
        covariances.push_back(tread::blockCovariance(ground.noise[i], times, readings, phase));
    }
    return covariances;
}

MatrixXd productsOf(const Absorbing& one, const Drawn& drawn, const ProvingGround& ground,
                    const std::vector<tread::WrongThing>& wrong) {
    const Replayed first = replay(drivenCar(drawn), one.drive);
    const VectorXd here = rowsOf(first.log);
    tread::ShownDrive shown{.noise = noiseOf(ground, first),
                            .pushes = pushesOf(one, ground.surroundings),
                            .tolerances = MatrixXd(here.size(), one.open.cols() + one.days.cols()),
                            .rivals = one.rivals,
                            .changes = MatrixXd(here.size(), static_cast<Index>(wrong.size())),
                            .times = static_cast<double>(one.drive.repeats)};
    shown.tolerances << one.open, one.days;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        const Truth without = drivenCar(drawn, {wrong[i].name});
        shown.changes.col(static_cast<Index>(i)) =
            here - rowsOf(replay(without, one.drive, {.recorded = &first.recorded}).log);
    }
    return tread::products(shown);
}

std::vector<tread::WrongThing> wrongThingsOf(const Examination& examination, const Drawn& drawn) {
    std::vector<tread::WrongThing> wrong;
    for (const Drawn::Planted& one : drawn.planted) {
        wrong.push_back({one.effect.name, drawn.key.effects});
        for (const tread::diagnose::catalogue::Effect& other : examination.effects) {
            if (tread::sharePaths(one.effect, other)) wrong.back().no_rivals.push_back(other.name);
        }
    }
    if (drawn.outsider) wrong.push_back({drawn.outsider->name, drawn.key.effects});
    return wrong;
}

// Of a diagnosis that compares with the same drives on another day: twice the noise, two days, and nothing else open.
MatrixXd withReferences(const MatrixXd& products, Index open, Index days) {
    const Index rest = products.cols() - open;
    VectorXd scale = VectorXd::Ones(rest);
    scale.head(days).setConstant(std::sqrt(2.0));
    return 0.5 * scale.asDiagonal() * products.bottomRightCorner(rest, rest) * scale.asDiagonal();
}

}  // namespace

Examination examinationOf(const Truth& plain, const Subject& nominal,
                          const std::vector<tread::diagnose::catalogue::Effect>& effects,
                          const std::vector<tread::Drive>& all) {
    Examination examination{{}, effects, {}};
    Index column = 0;
    for (const tread::diagnose::catalogue::Effect& effect : effects) {
        tread::Rival& rival = examination.rivals.emplace_back(tread::Rival{effect.name, {}});
        for (std::size_t i = 0; i < effect.knobs.size(); ++i) rival.columns.push_back(column++);
    }
    const std::vector<Difference> open = openNumbers(plain, nominal), rivals = knobsOf(plain, nominal, effects);
    const std::vector<Difference> days = circumstancesOf(plain, nominal, &Circumstance::each_day);
    std::vector<Difference> drives = circumstancesOf(plain, nominal, &Circumstance::each_drive);
    drives.push_back({plain, kFaster / tread::kSpeedScatter, {}, kFaster});
    for (const tread::Drive& drive : all) {
        if (drive.hold_out) continue;
        Absorbing& one = examination.drives.emplace_back();
        one.drive = drive;
        one.open = columnsOf(drive, plain, open);
        one.days = columnsOf(drive, plain, days);
        one.rivals = columnsOf(drive, plain, rivals);
        one.drives = columnsOf(drive, plain, drives);
        takeHats(one, plain);
    }
    return examination;
}

std::vector<tread::diagnose::catalogue::Effect> shownEffects(const Examination& examination) {
    constexpr double kShown = 200;  // sum of squares over the noise of all readings
    std::vector<tread::diagnose::catalogue::Effect> effects;
    for (std::size_t i = 0; i < examination.effects.size(); ++i) {
        double sum = 0;
        for (const Absorbing& one : examination.drives) {
            const VectorXd noise = noiseOfRows(one.rivals.rows());
            for (const Index column : examination.rivals[i].columns)
                sum += one.rivals.col(column).cwiseQuotient(noise).squaredNorm();
        }
        if (sum >= kShown) effects.push_back(examination.effects[i]);
    }
    return effects;
}

Shown shown(const Examination& examination, const Drawn& drawn, const ProvingGround& ground) {
    const std::vector<tread::WrongThing> wrong = wrongThingsOf(examination, drawn);
    if (wrong.empty()) return {};
    std::vector<MatrixXd> all(examination.drives.size());
    tread::inParallel(all.size(), 0,
                      [&](std::size_t i) { all[i] = productsOf(examination.drives[i], drawn, ground, wrong); });
    MatrixXd sum = all.front();
    for (std::size_t i = 1; i < all.size(); ++i) sum += all[i];
    const Index open = examination.drives.front().open.cols(), days = examination.drives.front().days.cols();
    return {tread::shows(withReferences(sum, open, days), days, examination.rivals, wrong),
            tread::shows(sum, open + days, examination.rivals, wrong)};
}

}  // namespace other_car
