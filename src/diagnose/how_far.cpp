#include "diagnose/how_far.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.h"
#include "diagnose/replay.h"
#include "diagnose/sliding.h"
#include "identify/parallel.h"
#include "log/resample.h"

namespace tread {
namespace {

constexpr int kDraws = 12;            // of the posterior, each driven
constexpr int kResamples = 400;       // of the recordings, spread over the draws
constexpr double kStartError = 0.03;  // m/s: what a line through the first half second of speeds leaves
constexpr double kSignificant = 2;    // standard deviations by which a gap must exceed its floor
constexpr double kLow = 0.05, kHigh = 0.95;

// What a model does in each drive, and the sum of squares of what is then off. No rows where it cannot be driven.
struct Stage {
    Rows rows;
    std::vector<double> off;
};
struct Gaps {
    std::vector<double> floor;  // per drive: the sum that noise alone leaves
    Stage nominal, calibrated, extended;
};

double sum(const std::vector<double>& values) {
    double all = 0;
    for (const double value : values) all += value;
    return all;
}

GapLevels levels(const Gaps& gaps) {
    const double floor = sum(gaps.floor);
    const auto level = [&](const std::vector<double>& squares) {
        return floor > 0 ? std::sqrt(sum(squares) / floor) : 0;
    };
    return {level(gaps.nominal.off), level(gaps.calibrated.off), level(gaps.extended.off), level(gaps.floor)};
}

// Rows of a drive as a log; with no rows, only their times.
Log logOf(const RecordedDrive& drive, const Eigen::VectorXd& rows) {
    Log log;
    std::set<double> every;
    for (const ObservedChannel& channel : drive.channels) every.insert(channel.times.begin(), channel.times.end());
    const std::vector<double> time(every.begin(), every.end());
    log.channels.push_back({"time", "s", time});
    if (rows.size() == 0) return log;
    for (const ObservedChannel& channel : drive.channels) {
        Channel column{channel.name, drive.log.find(channel.name)->unit, std::vector<double>(time.size(), kRequired)};
        for (std::size_t i = 0; i < channel.times.size(); ++i) {
            const auto place = std::lower_bound(time.begin(), time.end(), channel.times[i]) - time.begin();
            column.values[static_cast<std::size_t>(place)] = rows(channel.first_row + static_cast<Eigen::Index>(i));
        }
        log.channels.push_back(std::move(column));
    }
    return log;
}

// What was measured; its rows where something was taken off them.
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

// Drives every stage of the model, and adds what is off.
Gaps gapsOf(Bench& bench, const Uncertainty& uncertainty, const std::vector<Deviation>& stages, bool hold_out,
            std::vector<Overlay>& overlays) {
    const std::size_t n = bench.drives.size();
    Gaps gaps{.floor = std::vector<double>(n), .nominal = {}, .calibrated = {}, .extended = {}};
    Stage* const each[] = {&gaps.nominal, &gaps.calibrated, &gaps.extended};
    for (Stage* stage : each) stage->rows.resize(n), stage->off.resize(n);
    std::vector<Overlay> here(n);
    std::vector<Subject> subjects;
    for (const Deviation& stage : stages) subjects.push_back(bench.subjectAt(stage));
    inParallel(n, bench.threads, [&](std::size_t d) {
        const RecordedDrive& drive = bench.drives[d];
        gaps.floor[d] = uncertainty.noise[d].expected;
        Log* const logs[] = {&here[d].nominal, &here[d].calibrated, &here[d].extended};
        here[d].recording = drive.name;
        here[d].hold_out = hold_out;
        here[d].measured = measuredOverlay(drive);
        for (std::size_t stage = 0; stage < stages.size(); ++stage) {
            const std::optional<Log> motion = motionAt(bench, d, subjects[stage]);
            Eigen::VectorXd& rows = each[stage]->rows[d];
            if (motion) rows = readings(drive, *motion, subjects[stage].instruments);
            *logs[stage] = logOf(drive, rows);
            const Eigen::VectorXd off = motion ? drive.measured - rows : drive.measured;
            each[stage]->off[d] = squaresOf(uncertainty, d, uncertainty.noise[d].over(off));
        }
    });
    overlays.insert(overlays.end(), here.begin(), here.end());
    return gaps;
}

// A point as likely as the posterior makes it.
Deviation drawn(const Bench& bench, const Fit& fit, Random& random) {
    const Eigen::Index n = fit.covariance.rows();
    Eigen::VectorXd normal(n);
    for (Eigen::Index i = 0; i < n; ++i) normal(i) = random.normal();
    Deviation point = fit.at;
    point(fit.free) += fit.covariance.llt().matrixL() * normal;
    for (const Eigen::Index i : fit.free) {
        const Parameter& parameter = bench.parameters[static_cast<std::size_t>(i)];
        point(i) = std::clamp(point(i), parameter.lowest, parameter.highest);
    }
    return point;
}

// How much of the nominal car's gap to the true one the answer closes. The true car is not known, but the posterior
// says what it can be: each draw of it is driven and stands for the truth once, from a start as uncertain as the
// replay's. A gap that the answer leaves beyond its floor in the recordings themselves is not closed whatever the
// posterior says.
void closure(HowFar& how_far, Bench& bench, const Uncertainty& uncertainty, const Gaps& gaps, const Fit& fit) {
    Random random(1);
    const std::size_t n = bench.drives.size();
    for (const Rows* rows : {&gaps.nominal.rows, &gaps.extended.rows})
        for (const Eigen::VectorXd& of_drive : *rows)
            if (of_drive.size() == 0 || !of_drive.allFinite()) return;
    std::vector<double> closures;
    double before_sum = 0, after_sum = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
        const std::optional<Rows> truth = rowsAt(bench, drawn(bench, fit, random));
        if (!truth) continue;
        std::vector<double> before(n), after(n);
        for (std::size_t d = 0; d < n; ++d) {
            const RowNoise& noise = uncertainty.noise[d];
            const double floor = gaps.floor[d],
                         beyond = gaps.extended.off[d] - floor - kSignificant * std::sqrt(2 * floor);
            const Eigen::MatrixXd& directions = uncertainty.directions[d];
            const Eigen::VectorXd start = random.normal() * kStartError * directions.rightCols(1);
            before[d] = (noise.over(gaps.nominal.rows[d] - (*truth)[d]) + start).squaredNorm();
            after[d] = (noise.over(gaps.extended.rows[d] - (*truth)[d]) + start).squaredNorm() + std::max(0.0, beyond);
            before_sum += before[d], after_sum += after[d];
        }
        for (int again = 0; again < kResamples / kDraws; ++again) {
            double b = 0, a = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const auto d = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
                b += before[d], a += after[d];
            }
            if (b > 0) closures.push_back(1 - a / b);
        }
    }
    if (closures.empty()) return;
    std::sort(closures.begin(), closures.end());
    const auto at = [&](double share) {
        return closures[static_cast<std::size_t>(share * static_cast<double>(closures.size() - 1))];
    };
    how_far.closure = 1 - after_sum / before_sum;
    how_far.closure_low = std::min(at(kLow), how_far.closure);
    how_far.closure_high = std::max(at(kHigh), how_far.closure);
}

const Candidate& answered(const Diagnosis& diagnosis, const Study& study, const Search& found) {
    for (const Candidate& one : found.candidates) {
        if (one.fitted && study.namesOf(one.effects) == diagnosis.causes) return one;
    }
    return found.none();
}

Uncertainty uncertaintyOfHeldOut(Bench& bench, const Study& study, const Deviation& at, const Rows& rows) {
    Uncertainty uncertainty = uncertaintyOf(bench, at, rows);
    uncertainty.sizes = study.uncertainty.sizes;
    return uncertainty;
}

void tellLeftOut(Diagnosis& diagnosis, const Bench& bench) {
    const std::vector<std::string> sentences = leftOut(bench.drives);
    diagnosis.data_warnings.insert(diagnosis.data_warnings.end(), sentences.begin(), sentences.end());
}

}  // namespace

void howFar(Diagnosis& diagnosis, Study& study, const Search& found, std::vector<RecordedDrive> held_out) {
    const Candidate& answer = answered(diagnosis, study, found);
    const std::vector<Deviation> stages{study.bench.origin(), found.none().fit.at, answer.fit.at};
    HowFar& how_far = diagnosis.how_far;
    const Gaps training = gapsOf(study.bench, study.uncertainty, stages, false, diagnosis.overlays);
    for (std::size_t d = 0; d < study.allowed.size(); ++d)
        diagnosis.overlays[d].allowed = logOf(study.bench.drives[d], study.allowed[d]);
    how_far.training = levels(training);
    tellLeftOut(diagnosis, study.bench);
    how_far.in_sample = held_out.empty();
    const double floor = sum(training.floor);
    const double nominal = sum(training.nominal.off) - floor, left = sum(training.extended.off) - floor;
    diagnosis.unexplained.share = nominal > 0 ? std::clamp(left / nominal, 0.0, 1.0) : 0;
    if (held_out.empty()) {
        closure(how_far, study.bench, study.uncertainty, training, answer.fit);
        return;
    }
    std::vector<RecordedDrive> trained = std::move(study.bench.drives);
    study.bench.drives = std::move(held_out);
    const std::optional<Rows> here = rowsAt(study.bench, study.calibration.at);
    if (here) {
        const Uncertainty uncertainty = uncertaintyOfHeldOut(study.bench, study, study.calibration.at, *here);
        const Gaps gaps = gapsOf(study.bench, uncertainty, stages, true, diagnosis.overlays);
        how_far.held_out = levels(gaps);
        tellLeftOut(diagnosis, study.bench);
        closure(how_far, study.bench, uncertainty, gaps, answer.fit);
    }
    study.bench.drives = std::move(trained);
}

}  // namespace tread
