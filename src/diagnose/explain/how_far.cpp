#include "diagnose/explain/how_far.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "base/math/random.h"
#include "diagnose/explain/resamples.h"
#include "diagnose/model/gap.h"
#include "log/resample.h"
#include "recording/checks/left_out.h"
#include "run/together.h"

namespace tread::diagnose::explain {
namespace {

using answer::GapLevels;
using answer::Overlay;
using model::Deviation;
using model::Drives;
using model::Replays;
using model::Rows;
using model::Uncertainty;
using recording::ObservedChannel;
using recording::RecordedDrive;

constexpr int kDraws = 12;            // draws from the posterior, each one a replay of all drives
constexpr double kStartError = 0.03;  // m/s, standard deviation of a start speed from a line through the first 0.5 s
constexpr double kSignificant = 2;    // standard deviations by which a gap must exceed its floor

// Rows of a model in each drive, and the squared residual that they leave. A drive that cannot be driven has no rows.
struct Stage {
    Rows rows;
    std::vector<double> off;
};
struct Gaps {
    std::vector<double> floor;  // per drive: squared residual expected of noise alone
    Stage nominal, calibrated, extended;
};

// The drives that are judged, with their noise and disturbances.
struct Judged {
    const Replays& replays;
    Drives drives;
    const Uncertainty& uncertainty;
    bool hold_out = false;
};

double sum(const std::vector<double>& values) {
    double all = 0;
    for (const double value : values) all += value;
    return all;
}

// Root of the squared residual over that expected of noise (D49).
GapLevels levels(const Gaps& gaps) {
    const double floor = sum(gaps.floor);
    const auto level = [&](const std::vector<double>& squares) {
        return floor > 0 ? std::sqrt(sum(squares) / floor) : 0;
    };
    return {level(gaps.nominal.off), level(gaps.calibrated.off), level(gaps.extended.off), level(gaps.floor)};
}

// Rows of a drive as a log; without rows only the time column.
Log logOf(const RecordedDrive& drive, const Eigen::VectorXd& rows) {
    Log log;
    std::set<double> every;
    for (const ObservedChannel& channel : drive.channels) every.insert(channel.times.begin(), channel.times.end());
    const std::vector<double> time(every.begin(), every.end());
    log.channels.push_back({"time", "s", time});
    if (rows.size() == 0) return log;
    for (const ObservedChannel& channel : drive.channels) {
        Channel column{channel.name, drive.log.find(channel.name)->unit, std::vector<double>(time.size(), kRequired)};
        for (Eigen::Index i = 0; i < channel.rows(); ++i) {
            const auto place = std::lower_bound(time.begin(), time.end(), channel.times[i]) - time.begin();
            column.values[place] = rows(channel.first_row + i);
        }
        log.channels.push_back(std::move(column));
    }
    return log;
}

// The measured channels and the driver's inputs. With a reference, the rows with the gap to the reference subtracted.
Log measuredOverlay(const RecordedDrive& drive) {
    const bool compared = drive.compared();
    Log log = compared ? logOf(drive, drive.measured) : Log{{{"time", "s", drive.time}}};
    const std::vector<double> time = log.channels.front().values;
    std::vector<Channel> inputs;
    for (const char* input : {"driver.steering_wheel_angle", "driver.throttle", "driver.brake"}) {
        const Channel* channel = drive.log.find(input);
        if (channel) inputs.push_back({channel->name, channel->unit, resample(drive.time, channel->values, time)});
    }
    log.channels.insert(log.channels.begin() + 1, inputs.begin(), inputs.end());
    for (const ObservedChannel& channel : drive.channels)
        if (!compared) log.channels.push_back(*drive.log.find(channel.name));
    return log;
}

// Squared difference of a model in each channel of a drive, beyond that of a perfect model (D46).
std::map<std::string, double> gapByChannel(const RecordedDrive& drive, const Eigen::VectorXd& rows,
                                           const Eigen::VectorXd& floor) {
    std::map<std::string, double> gap;
    if (rows.size() == 0) return gap;
    const Eigen::VectorXd over = (drive.measured - rows).cwiseQuotient(floor);
    for (const ObservedChannel& channel : drive.channels) {
        const auto compared = floor.segment(channel.first_row, channel.rows()).array().isFinite().count();
        const double squares = over.segment(channel.first_row, channel.rows()).squaredNorm();
        gap[channel.name] = std::max(0.0, squares - static_cast<double>(compared));
    }
    return gap;
}

// Sizes of the remainder as far as they are part of the floor: larger errors of readings are part of the gap.
model::Sizes ofTheFloor(model::Sizes sizes) {
    for (const model::Disturbed kind : model::kAllDisturbed)
        if (model::isInstruments(kind)) sizes[placeOf(kind)] = std::min(sizes[placeOf(kind)], 1.0);
    return sizes;
}

// Drives every stage of the model and adds its time histories to the overlays.
Gaps gapsOf(const Judged& judged, const std::array<Deviation, 3>& stages, std::vector<Overlay>& overlays) {
    const std::size_t n = judged.drives.size();
    Gaps gaps{.floor = std::vector<double>(n), .nominal = {}, .calibrated = {}, .extended = {}};
    const model::Sizes sizes = ofTheFloor(judged.uncertainty.sizes);
    Stage* const each[] = {&gaps.nominal, &gaps.calibrated, &gaps.extended};
    for (Stage* stage : each) stage->rows.resize(n), stage->off.resize(n);
    std::vector<Overlay> here(n);
    drivenTogether(n, judged.replays.threads, [&](std::size_t d) {
        const RecordedDrive& drive = judged.drives[d];
        const model::RowNoise& noise = judged.uncertainty.noise[d];
        gaps.floor[d] = noise.expected;
        Log* const logs[] = {&here[d].nominal, &here[d].calibrated, &here[d].extended};
        here[d].recording = drive.name;
        here[d].hold_out = judged.hold_out;
        here[d].measured = measuredOverlay(drive);
        const Eigen::VectorXd floor = model::floorOf(judged.uncertainty, d);
        here[d].rows = logOf(drive, drive.measured);
        here[d].floor = logOf(drive, floor);
        for (std::size_t stage = 0; stage < stages.size(); ++stage) {
            Eigen::VectorXd& rows = each[stage]->rows[d];
            const auto driven = model::rowsOf(judged.replays, drive, stages[stage]);
            if (driven) rows = *driven;
            *logs[stage] = logOf(drive, rows);
            const Eigen::VectorXd off = driven ? drive.measured - rows : drive.measured;
            each[stage]->off[d] = model::squaresOf(judged.uncertainty, d, noise.over(off), sizes);
        }
        here[d].gap = gapByChannel(drive, gaps.nominal.rows[d], floor);
        here[d].remainder = gapByChannel(drive, gaps.extended.rows[d], floor);
    });
    overlays.insert(overlays.end(), here.begin(), here.end());
    return gaps;
}

bool driven(const Rows& rows) {
    return std::all_of(rows.begin(), rows.end(),
                       [](const Eigen::VectorXd& r) { return r.size() > 0 && r.allFinite(); });
}

// Squared gap of each drive to a car that may be the true one, for the nominal car and for the answer.
struct TrueGaps {
    std::vector<double> before, after;
};

// Gaps to `truth`, a possible true car, with a start speed as uncertain as that of the replay. Where the answer leaves
// more than its floor in the recording itself, the excess counts as not closed, whatever the posterior says.
TrueGaps gapsTo(const Rows& truth, const Judged& judged, const Gaps& gaps, Random& random) {
    TrueGaps found;
    for (std::size_t d = 0; d < judged.drives.size(); ++d) {
        const model::RowNoise& noise = judged.uncertainty.noise[d];
        const double floor = gaps.floor[d];
        const double beyond = gaps.extended.off[d] - floor - kSignificant * std::sqrt(2 * floor);
        const Eigen::VectorXd start = random.normal() * kStartError * judged.uncertainty.directions[d].rightCols(1);
        const auto squares = [&](const Rows& rows) { return (noise.over(rows[d] - truth[d]) + start).squaredNorm(); };
        found.before.push_back(squares(gaps.nominal.rows));
        found.after.push_back(squares(gaps.extended.rows) + std::max(0.0, beyond));
    }
    return found;
}

// Share of the gap closed in a bootstrap sample of the drives; nothing when the sample has no gap.
std::optional<double> resampled(const TrueGaps& gaps, Random& random) {
    const std::size_t n = gaps.before.size();
    double before = 0, after = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto d = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
        before += gaps.before[d], after += gaps.after[d];
    }
    if (before <= 0) return std::nullopt;
    return 1 - after / before;
}

// Share of the gap between nominal and true car that the answer closes. The true car is unknown, so each draw from the
// posterior takes its place in turn (D50).
void closure(answer::HowFar& how_far, const Judged& judged, const Gaps& gaps, const select::Fit& fit) {
    if (!driven(gaps.nominal.rows) || !driven(gaps.extended.rows)) return;
    Random random(1);
    std::vector<double> closures;
    double before = 0, after = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
        const std::optional<Rows> truth =
            model::rowsAt(judged.replays, judged.drives, select::drawn(judged.replays, fit, random));
        if (!truth) continue;
        const TrueGaps here = gapsTo(*truth, judged, gaps, random);
        before += sum(here.before), after += sum(here.after);
        for (int again = 0; again < kResamples / kDraws; ++again) {
            if (const std::optional<double> closed = resampled(here, random)) closures.push_back(*closed);
        }
    }
    if (closures.empty()) return;
    how_far.closure = 1 - after / before;
    std::tie(how_far.closure_low, how_far.closure_high) = ninetyPercentInterval(how_far.closure, std::move(closures));
}

void tellLeftOut(answer::Diagnosis& diagnosis, Drives drives, const Uncertainty& uncertainty) {
    for (std::size_t d = 0; d < drives.size(); ++d) {
        const auto rows = static_cast<double>(drives[d].rows());
        const double left_out = rows - model::comparedRows(uncertainty, d);
        if (left_out > 0) diagnosis.cuts.push_back({drives[d].name, uncertainty.until[d], left_out / rows});
    }
    const std::vector<std::string> sentences = recording::checks::leftOut(drives, uncertainty.until);
    diagnosis.data_warnings.insert(diagnosis.data_warnings.end(), sentences.begin(), sentences.end());
}

}  // namespace

void howFar(answer::Diagnosis& diagnosis, const select::Calibration& car, const select::HeldOut& held_out,
            const Stages& stages) {
    const model::Problem& problem = car.problem;
    const std::array<Deviation, 3> points{problem.replays.origin(), stages.calibrated, stages.answer.at};
    answer::HowFar& how_far = diagnosis.how_far;
    const Judged learnt{problem.replays, problem.drives, car.uncertainty, false};
    const Gaps training = gapsOf(learnt, points, diagnosis.overlays);
    for (std::size_t d = 0; d < car.allowed.size(); ++d)
        diagnosis.overlays[d].allowed = logOf(problem.drives[d], car.allowed[d]);
    how_far.training = levels(training);
    tellLeftOut(diagnosis, problem.drives, car.uncertainty);
    how_far.in_sample = problem.held_out.empty();
    if (how_far.in_sample) {
        closure(how_far, learnt, training, stages.answer);
        return;
    }
    const Uncertainty& uncertainty = held_out.uncertainty;
    if (uncertainty.noise.empty()) return;
    const Judged unseen{problem.replays, problem.held_out, uncertainty, true};
    const Gaps gaps = gapsOf(unseen, points, diagnosis.overlays);
    how_far.held_out = levels(gaps);
    tellLeftOut(diagnosis, problem.held_out, uncertainty);
    closure(how_far, unseen, gaps, stages.answer);
}

}  // namespace tread::diagnose::explain
