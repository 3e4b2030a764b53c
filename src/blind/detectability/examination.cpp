#include "blind/detectability/examination.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/fields/numbers.h"
#include "base/threads/parallel.h"
#include "blind/detectability/drive_replay.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "run/simulate.h"

namespace tread::blind::detectability {
namespace {

using diagnose::catalogue::applies;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;
using drives::Drive;
using recording::numberAt;
using recording::Subject;
using world::apply;
using world::differenceSpread;
using world::DriveDifference;
using world::OpenNumber;
using world::Truth;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSpeedStep = 0.1;  // m/s, of the difference by the speed at the start

// One difference: a car that differs from the examined one in drive number `drive`, and where the change of its rows
// goes.
struct Piece {
    std::size_t drive;
    std::function<std::optional<Truth>(double sign)> car;  // changed up (+1) or down (-1); empty beyond a limit
    double faster = 0;                                     // m/s, at the start
    std::function<void(const VectorXd& change)> take;
};

// Moves a number unless that would exceed its limits.
bool moved(Subject& car, const std::string& path, double by) {
    for (const Number& number : numbers(car)) {
        if (number.path != path) continue;
        if (!number.about.limits.allow(*number.value + by)) return false;
        *number.value += by;
        return true;
    }
    return false;
}

// Change of the rows by a piece: of an increase or, where that is impossible, of a decrease with its sign reversed;
// zero when neither car can be driven.
VectorXd changeOf(const Piece& piece, const DriveReplay& replay, const VectorXd& here) {
    for (const double sign : {1.0, -1.0}) {
        try {
            const std::optional<Truth> there = piece.car(sign);
            if (!there) continue;
            const VectorXd change = sign * (replay.rows(*there, piece.faster) - here);
            if (change.allFinite()) return change;
        } catch (const Interrupted&) {
            throw;
        } catch (const SimulationError&) {
        }
    }
    return VectorXd::Zero(here.size());
}

// A knob as a combination of the columns of open numbers; empty when it moves any number that is not open.
VectorXd mixtureOf(const Knob& knob, Subject about, const std::vector<OpenNumber>& open) {
    VectorXd shares = VectorXd::Zero(static_cast<Index>(open.size()));
    for (std::size_t i = 0; i < knob.paths.size(); ++i) {
        const double* number = numberAt(about, knob.paths[i]);
        if (!number) continue;
        const auto found =
            std::find_if(open.begin(), open.end(), [&](const OpenNumber& one) { return one.path == knob.paths[i]; });
        if (found == open.end()) return {};
        shares(found - open.begin()) += knob.typicalChange(i, *number) / found->sd;
    }
    return shares;
}

// Simulates the columns of all drives, all pieces in parallel.
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
            replays_.emplace_back(drive, about_);
        }
        here_.resize(replays_.size());
    }

    Examination take(int threads) {
        inParallel(replays_.size(), threads, [&](std::size_t d) { begin(d); });
        addRivals();
        for (std::size_t d = 0; d < replays_.size(); ++d) {
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
        const Log log = replays_[d].readings(about_);
        here_[d] = rowsOf(log);
        drive.times = log.channels.front().values;
        drive.speed = log.find("chassis.vx")->values;
        const Index rows = here_[d].size();
        drive.by_start_speed =
            changeOf({d, [&](double) { return about_; }, kSpeedStep, {}}, replays_[d], here_[d]) / kSpeedStep;
        drive.tolerances = MatrixXd::Zero(rows, static_cast<Index>(open_.size()));
        const auto hat_count = static_cast<Index>(std::ceil(drive.times.back() / kHatSpacing)) + 1;
        for (MatrixXd& columns : drive.by_hat) columns = MatrixXd::Zero(rows, hat_count);
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
            for (std::size_t first = 0; first < std::min(kHatsPerRun, count); ++first) {
                const auto car = [this, kind, first](double) {
                    Truth there = about_;
                    there.push = [=] { return hats(kind, first); };
                    return there;
                };
                pieces_.push_back({d, car, 0, [&drive, kind, first](const VectorXd& change) {
                                       separateHats(change, first, drive.by_start_speed, drive.by_hat[kind]);
                                   }});
            }
        }
    }

    // One column for each knob of each effect that applies to this car.
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
        for (std::size_t d = 0; d < replays_.size(); ++d)
            found_.drives[d].rivals = MatrixXd::Zero(here_[d].size(), columns);
    }

    void addKnob(const Knob& knob, Index column) {
        const double by = knob.direction == Direction::down ? -knob.typical : knob.typical;
        for (std::size_t d = 0; d < replays_.size(); ++d) {
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
            piece.take(changeOf(piece, replays_[piece.drive], here_[piece.drive]));
        });
    }

    Truth about_;
    std::vector<OpenNumber> open_;
    Examination found_;
    std::vector<DriveReplay> replays_;
    std::vector<VectorXd> here_;
    std::vector<Piece> pieces_;
    std::vector<std::pair<Index, VectorXd>> mixtures_;
};

}  // namespace

Examination examination(const Subject& about, const std::vector<Drive>& drives, const std::vector<OpenNumber>& open,
                        const std::vector<Effect>& effects, int threads) {
    return Columns(about, drives, open, effects).take(threads);
}

}  // namespace tread::blind::detectability
