#include "diagnose/explain/next_drive.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <utility>

#include "diagnose/explain/open_question.h"
#include "diagnose/settings.h"
#include "log/log_columns.h"
#include "recording/observation.h"
#include "run/together.h"

namespace tread::diagnose::explain {
namespace {

using model::Problem;
using model::RowNoise;
using recording::ObservedChannel;
using recording::RecordedDrive;
using select::Calibration;
using select::Fit;

constexpr std::size_t kStudied = 3;  // manoeuvres that are studied per question
constexpr double kLoggedRate = 100;  // Hz, sampling rate of imagined recordings
// Times the highest recorded speed: faster manoeuvres are not proposed, as the place or the car may not allow them.
// Guess.
constexpr double kFaster = 2;

// Gives a log of the model the channels of further instruments; a rehearsal needs only their times.
void addChannels(Log& log, const std::vector<ObservedChannel>& channels) {
    for (const ObservedChannel& channel : channels) {
        const Channel* quantity = log.find(quantityOf(channel.name));
        if (quantity && !log.find(channel.name))
            log.channels.push_back({channel.name, quantity->unit, std::vector<double>(quantity->values)});
    }
}

// Log of a manoeuvre driven by the nominal car as its scenario says; without channels when it cannot be driven.
Log imagined(const recording::Replayer& replayer, const Scenario& told, const std::vector<ObservedChannel>& channels) {
    Scenario scenario = told;
    scenario.log.rate = kLoggedRate;
    scenario.log.channels = {"driver.*", "driveline.gear", "chassis.vx", "chassis.yaw_rate"};
    scenario.log.sensors = {};
    for (const ObservedChannel& channel : channels) scenario.log.channels.emplace_back(quantityOf(channel.name));
    Log log;
    try {
        replayer.simulate(replayer.nominal.vehicle, scenario, recorderInto(log), {});
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError&) {
        log.channels.clear();
    }
    addChannels(log, channels);
    return log;
}

// Highest speed that a log contains, m/s; 0 without any.
double highestSpeed(const Log& log) {
    const Channel* speed = recording::measuredAs(log, "chassis.vx");
    double highest = 0;
    if (speed)
        for (const double v : speed->values)
            if (std::isfinite(v)) highest = std::max(highest, v);
    return highest;
}

double highestSpeed(recording::Drives drives) {
    double highest = 0;
    for (const RecordedDrive& drive : drives) highest = std::max({highest, drive.speed, highestSpeed(drive.log)});
    return highest;
}

// The possible manoeuvres as if they had been recorded with the nominal car.
struct Rehearsal {
    std::deque<recording::Recording> recordings;  // the drives point to these; a deque keeps their addresses
    std::vector<RecordedDrive> drives;
};

Rehearsal rehearsed(const Problem& problem, const std::vector<PossibleDrive>& possible) {
    const std::vector<ObservedChannel>& channels = problem.drives.front().channels;
    recording::DiagnosisFile file;
    for (const ObservedChannel& channel : channels) file.channels.push_back({channel.name});
    std::vector<Log> logs(possible.size());
    drivenTogether(possible.size(), problem.replays.threads, [&](std::size_t i) {
        logs[i] = imagined(problem.replays.replayer, possible[i].scenario, channels);
    });
    problem.replays.simulations.add(static_cast<int>(possible.size()));
    Rehearsal rehearsal;
    const double fastest = kFaster * highestSpeed(problem.drives);
    for (std::size_t i = 0; i < possible.size(); ++i) {
        if (logs[i].channels.empty() || logs[i].samples() < 2 || highestSpeed(logs[i]) > fastest) continue;
        rehearsal.recordings.push_back({.log = possible[i].name, .name = possible[i].name});
        rehearsal.recordings.back().road = possible[i].scenario.road;
        rehearsal.drives.push_back(recording::recordedDrive(rehearsal.recordings.back(), logs[i], file));
    }
    return rehearsal;
}

// What the recordings say of the rows of each channel.
struct ChannelNoise {
    double deviation = 1;  // of the noise, mean over the recordings
    double variance = 1;   // of noise and disturbances, in units of the squared deviation
};

std::map<std::string, ChannelNoise> noiseOfChannels(const Calibration& car) {
    struct Sums {
        double deviation = 0, drives = 0, squares = 0, rows = 0;
    };
    std::map<std::string, Sums> sums;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const Eigen::VectorXd sizes = car.uncertainty.sizesOf(d, car.uncertainty.sizes);
        for (const ObservedChannel& channel : car.drives()[d].channels) {
            if (channel.rows() == 0) continue;
            const double one = car.uncertainty.noise[d].deviation(channel.first_row);
            if (!std::isfinite(one)) continue;
            const auto directions = car.uncertainty.directions[d].middleRows(channel.first_row, channel.rows());
            Sums& sum = sums[channel.name];
            sum.deviation += one, sum.drives += 1;
            sum.squares += (directions * sizes.asDiagonal()).squaredNorm();
            sum.rows += static_cast<double>(channel.rows());
        }
    }
    std::map<std::string, ChannelNoise> noise;
    for (const auto& [name, sum] : sums) noise[name] = {sum.deviation / sum.drives, 1 + sum.squares / sum.rows};
    return noise;
}

// Noise of the rows of a rehearsed drive.
RowNoise noiseOf(const RecordedDrive& drive, const std::map<std::string, ChannelNoise>& channels) {
    RowNoise noise{.deviation = Eigen::VectorXd::Ones(drive.rows()), .ends = {}};
    for (const ObservedChannel& channel : drive.channels) {
        const auto known = channels.find(channel.name);
        if (known != channels.end())
            noise.deviation.segment(channel.first_row, channel.rows()).setConstant(known->second.deviation);
        noise.ends.push_back(channel.first_row + channel.rows());
    }
    return noise;
}

// First look at a manoeuvre: the whitened difference between the two cars of each question, and the nats that it would
// promise if disturbances were white noise and no parameter of the car were uncertain.
struct Look {
    RowNoise noise;
    std::vector<Eigen::VectorXd> differences = {};  // per question; empty when one of the cars cannot drive it
    std::vector<double> promised = {};              // per question
};

Look lookAt(const RecordedDrive& drive, const Calibration& car, const std::map<std::string, ChannelNoise>& channels,
            const std::vector<Question>& questions) {
    const model::Replays& replays = car.problem.replays;
    const auto shown = [&](const model::Deviation& at) {
        const recording::Subject subject = replays.subjectAt(at, drive);
        const std::optional<Log> motion = model::motionAt(replays, drive, subject);
        return motion ? recording::readings(drive, *motion, subject.instruments) : Eigen::VectorXd{};
    };
    Look look{.noise = noiseOf(drive, channels)};
    model::Deviation last;
    Eigen::VectorXd rows;
    for (const Question& question : questions) {
        const Eigen::VectorXd one = shown(question.one);
        if (last.size() == 0 || last != question.other) rows = shown(question.other), last = question.other;
        const bool driven = one.size() > 0 && rows.size() > 0 && (one - rows).allFinite();
        look.differences.emplace_back();
        if (driven) look.differences.back() = look.noise.over(one - rows);
        double promised = 0;
        for (const ObservedChannel& channel : drive.channels) {
            const auto known = channels.find(channel.name);
            if (!driven || known == channels.end()) continue;
            promised += look.differences.back().segment(channel.first_row, channel.rows()).squaredNorm() /
                        known->second.variance;
        }
        look.promised.push_back(0.5 * promised);
    }
    return look;
}

// What makes rows of a drive uncertain: disturbances, and all that is still uncertain of the car, that is all
// tolerances and the knobs of the open questions.
struct Study {
    Eigen::MatrixXd directions;            // whitened columns of the disturbances
    inference::Metric metric;              // of these
    std::vector<Eigen::Index> parameters;  // tolerances, then knobs
    Eigen::Index nuisances;                // number of tolerances
    Eigen::MatrixXd columns;               // whitened columns of the parameters
};

std::vector<Eigen::Index> uncertainParameters(const Problem& problem, const std::vector<Question>& questions) {
    std::vector<Eigen::Index> all = problem.nuisances;
    for (const Question& question : questions)
        for (const Fit* fit : question.fits) all.insert(all.end(), fit->knobs.begin(), fit->knobs.end());
    const auto knobs = all.begin() + std::ssize(problem.nuisances);
    std::sort(knobs, all.end());
    all.erase(std::unique(knobs, all.end()), all.end());
    return all;
}

Study studyOf(const RecordedDrive& drive, const RowNoise& noise, const Calibration& car,
              const std::vector<Question>& questions) {
    const model::Replays& replays = car.problem.replays;
    const model::Disturbances disturbing =
        model::disturbances(replays, drive, replays.nominal(), model::Resolution::rough);
    Eigen::MatrixXd directions = noise.over(disturbing.columns);
    Eigen::VectorXd sizes(directions.cols());
    for (Eigen::Index i = 0; i < sizes.size(); ++i)
        sizes(i) = car.uncertainty.sizes[model::placeOf(disturbing.kinds[i])];
    inference::Metric metric = inference::metricOf(inference::squareOf(directions), sizes);
    std::vector<Eigen::Index> parameters = uncertainParameters(car.problem, questions);
    const model::Sensitivities about =
        model::sensitivities(replays, {&drive, 1}, replays.origin(), {.parameters = parameters});
    Eigen::MatrixXd columns = noise.over(about.columns.front()(Eigen::all, parameters));
    return {std::move(directions), std::move(metric), std::move(parameters), std::ssize(car.problem.nuisances),
            std::move(columns)};
}

// Columns of the parameters that are uncertain in a fit, times the Cholesky factor of their covariance.
Eigen::MatrixXd uncertainColumns(const Study& study, const Fit& fit) {
    std::vector<Eigen::Index> places;  // tolerances, and the knobs of this fit
    std::vector<Eigen::Index> known;   // their places in the fit; -1: not in the fit, so the prior holds
    for (Eigen::Index i = 0; i < std::ssize(study.parameters); ++i) {
        const auto place = std::find(fit.free.begin(), fit.free.end(), study.parameters[i]);
        if (place == fit.free.end() && i >= study.nuisances) continue;
        places.push_back(i);
        known.push_back(place == fit.free.end() ? -1 : place - fit.free.begin());
    }
    const Eigen::Index n = std::ssize(places);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            if (known[i] >= 0 && known[j] >= 0) covariance(i, j) = fit.covariance(known[i], known[j]);
    }
    return study.columns(Eigen::all, places) * Eigen::MatrixXd(covariance.llt().matrixL());
}

// Nats of a difference that remain when the uncertain numbers of the car imitate it, as far as the recordings leave
// them free (D51).
double natsOf(const Study& study, const Fit& fit, const Eigen::VectorXd& difference) {
    const Eigen::MatrixXd uncertain = uncertainColumns(study, fit);
    const Eigen::Index n = uncertain.cols();
    Eigen::MatrixXd columns(difference.size(), n + 1);
    columns << uncertain, difference;
    const inference::DriveProducts products{.columns = inference::squareOf(columns),
                                            .disturbances = {},
                                            .mixed = inference::transposedTimes(study.directions, columns)};
    const inference::MarginalProducts marginal(products, study.metric);
    return 0.5 * inference::withoutFirst(marginal.equations(), n).products(0, 0);
}

// Chooses manoeuvres: of those that promise most per second of driving, the first that separates clearly when studied.
class Chooser {
public:
    Chooser(const Calibration& car, const Rehearsal& rehearsal, const std::vector<Question>& questions)
        : car_(car),
          rehearsal_(rehearsal),
          questions_(questions),
          looks_(rehearsal.drives.size()),
          studies_(rehearsal.drives.size()) {
        const std::map<std::string, ChannelNoise> channels = noiseOfChannels(car);
        drivenTogether(looks_.size(), car.problem.replays.threads,
                       [&](std::size_t d) { looks_[d] = lookAt(rehearsal.drives[d], car, channels, questions); });
    }

    // Manoeuvre for one question; without a scenario when none of those studied reaches the threshold.
    answer::NextDrive best(std::size_t q) {
        const Question& question = questions_[q];
        std::vector<std::size_t> order(looks_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto perSecond = [&](std::size_t d) { return looks_[d].promised[q] / rehearsal_.drives[d].duration(); };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return perSecond(a) > perSecond(b); });
        order.resize(std::min(order.size(), kStudied));
        answer::NextDrive best{{}, question.causes_of_one, question.causes_of_other, 0};
        for (const std::size_t d : order) {
            if (best.nats >= kSettings.clear) break;
            if (0.5 * looks_[d].differences[q].squaredNorm() < kSettings.clear) continue;  // not even by noise alone
            double nats = kInfinity;
            for (const Fit* fit : question.fits)
                nats = std::min(nats, natsOf(studied(d), *fit, looks_[d].differences[q]));
            if (nats > best.nats) best.nats = nats, best.scenario = rehearsal_.drives[d].name;
        }
        return best;
    }

private:
    const Study& studied(std::size_t d) {
        if (!studies_[d]) studies_[d] = studyOf(rehearsal_.drives[d], looks_[d].noise, car_, questions_);
        return *studies_[d];
    }

    const Calibration& car_;
    const Rehearsal& rehearsal_;
    const std::vector<Question>& questions_;
    std::vector<Look> looks_;
    std::vector<std::optional<Study>> studies_;
};

}  // namespace

std::vector<answer::NextDrive> nextDrives(const answer::Diagnosis& diagnosis, const Calibration& car,
                                          const select::Search& found, const std::vector<PossibleDrive>& possible) {
    const std::vector<Question> questions = openQuestions(diagnosis, car.problem, found);
    if (questions.empty() || possible.empty()) return {};
    const Rehearsal rehearsal = rehearsed(car.problem, possible);
    Chooser chooser(car, rehearsal, questions);
    std::vector<answer::NextDrive> next;
    for (std::size_t q = 0; q < questions.size(); ++q) {
        answer::NextDrive best = chooser.best(q);
        if (best.nats >= kSettings.clear) next.push_back(std::move(best));
    }
    std::stable_sort(next.begin(), next.end(), [](const auto& a, const auto& b) { return a.nats > b.nats; });
    return next;
}

}  // namespace tread::diagnose::explain
