#include "blind/examine.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/numbers.h"
#include "base/parallel.h"
#include "blind/gauges.h"
#include "blind/measure.h"
#include "diagnose/catalogue/effect.h"
#include "log/resample.h"
#include "recording/instruments.h"
#include "recording/subject.h"
#include "run/simulate.h"

namespace tread {
namespace {

using diagnose::catalogue::applies;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;
using recording::Instrument;
using recording::Instruments;
using recording::numberAt;
using recording::Subject;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStep = 0.005;            // s: differences of two runs of the same step
constexpr std::uint64_t kAnySeed = 1;      // nothing of these drives is random but misreadings
constexpr double kSpeedStep = 0.1;         // m/s
constexpr std::size_t kApart = 20;         // hats: after two seconds a push is forgotten but for the speed it cost
constexpr double kLeastKept = 0.02;        // of a change of speed, of which something is still known
constexpr double kLeastPush = 1e-3;        // of the variance of a source: smaller parts are left out
constexpr std::array kTail{"chassis.vx"};  // shows the speed

constexpr Conditions conditions() {
    Conditions ideal = kIdeal;
    ideal.step = kStep;
    return ideal;
}

std::vector<const Gauge*> gaugesOfTheCar() {
    std::vector<const Gauge*> found;
    for (const Gauge& gauge : gauges())
        if (!isOfTheDriver(gauge)) found.push_back(&gauge);
    return found;
}

// ---- The same drive again ------------------------------------------------------------------------------------------

// What the driver really did when his instrument showed this.
Curve behind(const std::vector<double>& times, const std::vector<double>& shown, const Instrument& instrument,
             const Limits& limits) {
    Curve curve;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double value = (shown[i] - instrument.bias) / instrument.gain;
        curve.points.push_back({times[i] - instrument.delay, std::clamp(value, limits.lowest, limits.highest)});
    }
    return curve;
}

// A drive whose inputs lie in a log, by a car that has these instruments; it holds its gear.
Drive repeated(const Drive& drive, const Log& log, const Truth& truth, double faster) {
    const std::vector<double>& times = log.channels.front().values;
    const Instruments& instruments = truth.car.instruments;
    const auto input = [&](const char* name, const Instrument& instrument, const Limits& limits) {
        return behind(times, log.find(name)->values, instrument, limits);
    };
    Phase phase;
    phase.steering =
        Table<Angle>{input("driver.steering_wheel_angle", instruments.steering_wheel_angle, Angle::kLimits)};
    phase.throttle = Table<Pedal>{input("driver.throttle", instruments.throttle, Pedal::kLimits)};
    phase.brake = Table<Pedal>{input("driver.brake", instruments.brake, Pedal::kLimits)};
    phase.until.duration = times.back();
    Drive again = drive;
    again.scenario.start.speed += faster;
    again.scenario.phases = {phase};
    return again;
}

// A drive as one car drove it, and how others do with the same recorded inputs.
class Course {
public:
    Course(const Drive& drive, const Truth& truth)
        : drive_(drive), driven_(readingsOf(truth, drive, kAnySeed, conditions())) {}

    Log readings(const Truth& truth, double faster = 0) const {
        Truth held = truth;
        holdGear(held.car.vehicle);
        return readingsOf(held, repeated(drive_, driven_, truth, faster), kAnySeed, conditions());
    }
    VectorXd rows(const Truth& truth, double faster = 0) const { return shownRows(readings(truth, faster)); }

private:
    // The gear of the drive as the only one: nothing shifts at another time.
    void holdGear(VehicleParams& car) const {
        const auto gear = static_cast<std::size_t>(std::lround(driven_.find("driveline.gear")->values.front()));
        std::vector<double>& ratios = car.driveline.gearbox.ratios;
        if (gear >= 1 && gear <= ratios.size()) ratios = {ratios[gear - 1]};
    }

    Drive drive_;
    Log driven_;
};

// ---- Columns -------------------------------------------------------------------------------------------------------

// A car that differs from the one about which columns are taken, and what becomes of the difference of their rows.
struct Piece {
    std::size_t drive;
    std::function<std::optional<Truth>(double sign)> car;  // changed to one side or the other, where that can be
    double faster = 0;
    std::function<void(const VectorXd& change)> take;
};

// Another value of a number, on the side where it may lie.
bool moved(Subject& car, const std::string& path, double by) {
    for (const Number& number : numbers(car)) {
        if (number.path != path) continue;
        if (!number.about.limits.allow(*number.value + by)) return false;
        *number.value += by;
        return true;
    }
    return false;
}

// The change of the rows by a piece, upwards or, where that cannot be, downwards with the sign turned; nothing when
// neither can be driven.
VectorXd changeOf(const Piece& piece, const Course& course, const VectorXd& here) {
    for (const double sign : {1.0, -1.0}) {
        try {
            const std::optional<Truth> there = piece.car(sign);
            if (!there) continue;
            const VectorXd change = sign * (course.rows(*there, piece.faster) - here);
            if (change.allFinite()) return change;
        } catch (const Interrupted&) {
            throw;
        } catch (const SimulationError&) {
        }
    }
    return VectorXd::Zero(here.size());
}

// Every kApart-th hat from the first one, on one of the four generalised forces.
Pushing hats(std::size_t kind, std::size_t first) {
    return [=](double time, const VehicleInput&, const VehicleOutput&) {
        const double since = time - static_cast<double>(first) * kHat, period = static_cast<double>(kApart) * kHat;
        const double near = std::max(0.0, std::round(since / period)) * period;
        const double size = kUnitPush * std::max(0.0, 1 - std::abs(since - near) / kHat);
        Push push;
        (kind == 0   ? push.force.x()
         : kind == 1 ? push.force.y()
         : kind == 2 ? push.moment.x()
                     : push.moment.z()) = size;
        return push;
    };
}

// First row of the speed, and rows of a channel.
struct SpeedRows {
    Index first, count;
};
SpeedRows speedRows(Index rows) {
    const std::vector<const Gauge*> all = gaugesOfTheCar();
    const auto count = rows / static_cast<Index>(all.size());
    const auto speed = std::find_if(all.begin(), all.end(), [](const Gauge* g) { return g->channel == kTail[0]; });
    return {(speed - all.begin()) * count, count};
}

// Takes what several hats do apart: each until the next one begins; of the speed that it cost stays what a car that
// starts slower shows.
void takeApart(VectorXd change, std::size_t first, const VectorXd& by_start_speed, MatrixXd& by_hat) {
    const auto [speed, count] = speedRows(change.size());
    const auto blocks = [](double seconds) { return static_cast<Index>(std::lround(seconds / kShownBlock)); };
    for (auto hat = static_cast<Index>(first); hat < by_hat.cols(); hat += kApart) {
        const Index begins = std::max<Index>(0, blocks((static_cast<double>(hat) - 1) * kHat));
        const Index over = std::min(count, begins + blocks(static_cast<double>(kApart) * kHat));
        if (begins >= count) break;
        const double kept = by_start_speed(speed + over - 1);
        const double faster = std::abs(kept) > kLeastKept ? change(speed + over - 1) / kept : 0;
        for (Index channel = 0; channel < change.size(); channel += count) {
            by_hat.col(hat).segment(channel + begins, over - begins) = change.segment(channel + begins, over - begins);
            by_hat.col(hat).segment(channel + over, count - over) =
                faster * by_start_speed.segment(channel + over, count - over);
        }
        change -= by_hat.col(hat);
    }
}

// A knob as a mixture of open numbers; empty when it moves others, too.
VectorXd mixtureOf(const Knob& knob, Subject about, const std::vector<OpenNumber>& open) {
    VectorXd shares = VectorXd::Zero(static_cast<Index>(open.size()));
    for (std::size_t i = 0; i < knob.paths.size(); ++i) {
        const double* number = numberAt(about, knob.paths[i]);
        if (!number) continue;
        const auto found =
            std::find_if(open.begin(), open.end(), [&](const OpenNumber& one) { return one.path == knob.paths[i]; });
        if (found == open.end()) return {};
        const double share = knob.shares.empty() ? 1 : knob.shares[i];
        shares(found - open.begin()) += share * knob.typical * (knob.relative ? *number : 1) / found->sd;
    }
    return shares;
}

// What makes the columns of all drives about one car.
class Columns {
public:
    Columns(const Subject& about, const std::vector<Drive>& drives, const std::vector<OpenNumber>& open,
            const std::vector<Effect>& effects)
        : open_(open) {
        about_.car = about;
        found_.effects = effects;
        for (const Drive& drive : drives) {
            if (drive.hold_out) continue;
            ExaminedDrive& one = found_.drives.emplace_back();
            one.drive = drive;
            courses_.emplace_back(drive, about_);
        }
        here_.resize(courses_.size());
    }

    Examination take(int threads) {
        inParallel(courses_.size(), threads, [&](std::size_t d) { begin(d); });
        addRivals();
        for (std::size_t d = 0; d < courses_.size(); ++d) {
            addOpenNumbers(d);
            addDifferences(d);
            addHats(d);
        }
        run(threads);
        for (ExaminedDrive& drive : found_.drives)
            for (const auto& [column, shares] : mixtures_) drive.rivals.col(column) = drive.tolerances * shares;
        return std::move(found_);
    }

private:
    void begin(std::size_t d) {
        ExaminedDrive& drive = found_.drives[d];
        const Log log = courses_[d].readings(about_);
        here_[d] = shownRows(log);
        drive.times = log.channels.front().values;
        drive.speed = log.find("chassis.vx")->values;
        const Index rows = here_[d].size();
        drive.by_start_speed =
            changeOf({d, [&](double) { return about_; }, kSpeedStep, {}}, courses_[d], here_[d]) / kSpeedStep;
        drive.tolerances = MatrixXd::Zero(rows, static_cast<Index>(open_.size()));
        const auto count = static_cast<Index>(std::ceil(drive.times.back() / kHat)) + 1;
        for (MatrixXd& columns : drive.by_hat) columns = MatrixXd::Zero(rows, count);
        drive.differences = MatrixXd::Zero(rows, 5);
    }

    void addOpenNumbers(std::size_t d) {
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const auto car = [this, i](double sign) {
                std::optional<Truth> there = about_;
                if (!moved(there->car, open_[i].path, sign * open_[i].sd)) there.reset();
                return there;
            };
            pieces_.push_back({d, car, 0, [this, d, i](const VectorXd& change) {
                                   found_.drives[d].tolerances.col(static_cast<Index>(i)) = change;
                               }});
        }
    }

    void addDifferences(std::size_t d) {
        const DriveDifference spread = differenceSpread();
        const std::array<DriveDifference, 5> each{{{.wind_x = spread.wind_x},
                                                   {.wind_y = spread.wind_y},
                                                   {.grade = spread.grade},
                                                   {.bank = spread.bank},
                                                   {.latency = spread.latency}}};
        for (std::size_t i = 0; i < each.size(); ++i) {
            const auto car = [this, difference = each[i]](double) {
                Truth there = about_;
                apply(difference, there.car);
                return there;
            };
            pieces_.push_back({d, car, 0, [this, d, i](const VectorXd& change) {
                                   found_.drives[d].differences.col(static_cast<Index>(i)) = change;
                               }});
        }
    }

    void addHats(std::size_t d) {
        ExaminedDrive& drive = found_.drives[d];
        for (std::size_t kind = 0; kind < drive.by_hat.size(); ++kind) {
            const auto count = static_cast<std::size_t>(drive.by_hat[kind].cols());
            for (std::size_t first = 0; first < std::min(kApart, count); ++first) {
                const auto car = [this, kind, first](double) {
                    Truth there = about_;
                    there.push = [=] { return hats(kind, first); };
                    return there;
                };
                pieces_.push_back({d, car, 0, [&drive, kind, first](const VectorXd& change) {
                                       takeApart(change, first, drive.by_start_speed, drive.by_hat[kind]);
                                   }});
            }
        }
    }

    // The columns of all knobs of effects that this car can have.
    void addRivals() {
        Index columns = 0;
        for (const Effect& effect : found_.effects) {
            if (!applies(effect, about_.car)) continue;
            Rival& rival = found_.rivals.emplace_back(Rival{effect.name, {}});
            for (const Knob& knob : effect.knobs) {
                rival.columns.push_back(columns);
                const VectorXd shares = mixtureOf(knob, about_.car, open_);
                if (shares.size() > 0) mixtures_.emplace_back(columns, shares);
                else addKnob(knob, columns);
                ++columns;
            }
        }
        for (std::size_t d = 0; d < courses_.size(); ++d)
            found_.drives[d].rivals = MatrixXd::Zero(here_[d].size(), columns);
    }

    void addKnob(const Knob& knob, Index column) {
        const double by = knob.direction == Direction::down ? -knob.typical : knob.typical;
        for (std::size_t d = 0; d < courses_.size(); ++d) {
            const auto car = [this, &knob, by](double sign) {
                Truth there = about_;
                move(there.car, knob, sign * by);
                return there;
            };
            pieces_.push_back({d, car, 0, [this, d, column](const VectorXd& change) {
                                   found_.drives[d].rivals.col(column) = change;
                               }});
        }
    }

    void run(int threads) {
        inParallel(pieces_.size(), threads, [&](std::size_t i) {
            const Piece& piece = pieces_[i];
            piece.take(changeOf(piece, courses_[piece.drive], here_[piece.drive]));
        });
    }

    Truth about_;
    std::vector<OpenNumber> open_;
    Examination found_;
    std::vector<Course> courses_;
    std::vector<VectorXd> here_;
    std::vector<Piece> pieces_;
    std::vector<std::pair<Index, VectorXd>> mixtures_;
};

// ---- One case ------------------------------------------------------------------------------------------------------

// A process that pushes: direction, and autocovariance between two places of a drive.
struct Process {
    Push push;
    bool by_speed, by_distance;
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

// Covariance of the heights of the hats of a process: of its values at their peaks. Hats a tenth of a second apart keep
// what changes slower than 5 Hz, and what is faster a car hardly follows.
MatrixXd covarianceOfHats(const Process& process, const ExaminedDrive& drive, Index hats) {
    std::vector<double> way(drive.times.size());
    for (std::size_t i = 1; i < way.size(); ++i)
        way[i] = way[i - 1] + (drive.times[i] - drive.times[i - 1]) * drive.speed[i];
    VectorXd place(hats), size(hats);
    for (Index i = 0; i < hats; ++i) {
        const double time = std::min(static_cast<double>(i) * kHat, drive.times.back());
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

// Columns of standard deviation 1 of all that pushes.
MatrixXd pushesOf(const Truth& truth, const ExaminedDrive& drive) {
    std::vector<MatrixXd> parts;
    for (const Process& process : processesOf(truth)) {
        const Vector3 &force = process.push.force / kUnitPush, &moment = process.push.moment / kUnitPush;
        const MatrixXd response = force.x() * drive.by_hat[0] + force.y() * drive.by_hat[1] +
                                  moment.x() * drive.by_hat[2] + moment.z() * drive.by_hat[3];
        const Eigen::SelfAdjointEigenSolver<MatrixXd> parts_of(covarianceOfHats(process, drive, response.cols()));
        const VectorXd& variances = parts_of.eigenvalues();  // rising
        Index kept = 0;
        while (kept < variances.size() && variances(variances.size() - 1 - kept) > kLeastPush * variances.sum()) ++kept;
        parts.push_back(response *
                        (parts_of.eigenvectors().rightCols(kept) * variances.tail(kept).cwiseSqrt().asDiagonal()));
    }
    if (truth.own) parts.push_back(drive.differences);
    parts.push_back(kSpeedScatter * drive.drive.scenario.start.speed * drive.by_start_speed);
    Index columns = 0;
    for (const MatrixXd& part : parts) columns += part.cols();
    MatrixXd all(drive.by_start_speed.size(), columns);
    Index first = 0;
    for (const MatrixXd& part : parts) all.middleCols(first, part.cols()) = part, first += part.cols();
    return all;
}

std::vector<MatrixXd> noiseOf(const Truth& truth, const Log& readings) {
    const std::vector<ReadingNoise> noises = truth.own ? truth.own->noise : assumedNoise();
    const std::vector<double>& times = readings.channels.front().values;
    const std::vector<double> phase = enginePhase(times, readings.find(kEngineSpeed)->values);
    std::vector<MatrixXd> covariances;
    for (std::size_t i = 0; i < noises.size(); ++i) {
        if (isOfTheDriver(gauges()[i])) continue;
        covariances.push_back(blockCovariance(noises[i], times, readings.find(gauges()[i].channel)->values, phase));
    }
    return covariances;
}

MatrixXd productsOf(const ExaminedDrive& drive, const DrawnCase& drawn, const std::vector<WrongThing>& wrong) {
    const Course course(drive.drive, drawn.truth);
    const Log readings = course.readings(drawn.truth);
    const VectorXd here = shownRows(readings);
    ShownDrive shown = hiding(drive, drawn.truth, readings);
    shown.tolerances = drive.tolerances;
    shown.rivals = drive.rivals;
    shown.changes.resize(here.size(), static_cast<Index>(wrong.size()));
    for (std::size_t i = 0; i < wrong.size(); ++i)
        shown.changes.col(static_cast<Index>(i)) = here - course.rows(drawn.without.at(wrong[i].name));
    return products(shown);
}

// All that is wrong, each with whom it cannot be mistaken for.
std::vector<WrongThing> wrongThings(const Examination& examination, const DrawnCase& drawn) {
    const std::vector<Effect>& effects = examination.effects;
    std::vector<WrongThing> wrong;
    for (const auto& [name, truth] : drawn.without) {
        WrongThing& one = wrong.emplace_back(WrongThing{name, drawn.key.effects});
        const auto planted = std::find_if(effects.begin(), effects.end(),
                                          [&, &wanted = name](const Effect& e) { return e.name == wanted; });
        if (planted == effects.end()) continue;
        for (const Effect& other : effects)
            if (sharePaths(other, *planted)) one.no_rivals.push_back(other.name);
    }
    return wrong;
}

}  // namespace

Eigen::VectorXd shownRows(const Log& log) {
    const std::vector<double>& times = log.channels.front().values;
    std::vector<VectorXd> parts;
    Index count = 0;
    for (const Gauge* gauge : gaugesOfTheCar()) {
        parts.push_back(shownBlocks(times, log.find(gauge->channel)->values));
        count += parts.back().size();
    }
    VectorXd rows(count);
    Index first = 0;
    for (const VectorXd& part : parts) rows.segment(first, part.size()) = part, first += part.size();
    return rows;
}

ShownDrive hiding(const ExaminedDrive& drive, const Truth& truth, const Log& readings) {
    return {.noise = noiseOf(truth, readings),
            .pushes = pushesOf(truth, drive),
            .tolerances = {},
            .rivals = {},
            .changes = {},
            .times = static_cast<double>(drive.drive.repeats)};
}

Examination examination(const Subject& about, const std::vector<Drive>& drives, const std::vector<OpenNumber>& open,
                        const std::vector<Effect>& effects, int threads) {
    return Columns(about, drives, open, effects).take(threads);
}

std::map<std::string, Shows> examined(const Examination& examination, const DrawnCase& drawn, int threads) {
    if (drawn.without.empty()) return {};
    const std::vector<WrongThing> wrong = wrongThings(examination, drawn);
    std::vector<MatrixXd> all(examination.drives.size());
    inParallel(all.size(), threads, [&](std::size_t d) { all[d] = productsOf(examination.drives[d], drawn, wrong); });
    MatrixXd sum = all.front();
    for (std::size_t d = 1; d < all.size(); ++d) sum += all[d];
    return shows(sum, examination.drives.front().tolerances.cols(), examination.rivals, wrong);
}

}  // namespace tread
