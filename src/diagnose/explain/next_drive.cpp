#include "diagnose/explain/next_drive.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "diagnose/explain/open_question.h"
#include "diagnose/settings.h"
#include "log/log_columns.h"
#include "run/together.h"

namespace tread::diagnose::explain {
namespace {

using model::Problem;
using model::RowNoise;
using recording::ObservedChannel;
using recording::RecordedDrive;
using select::Calibration;
using select::Fit;

constexpr int kMostSimulations = 150;  // simulations after which no further manoeuvre is studied in detail
constexpr double kLoggedRate = 100;    // Hz, sampling rate of imagined recordings

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
    for (std::size_t i = 0; i < possible.size(); ++i) {
        if (logs[i].channels.empty() || logs[i].samples() < 2) continue;
        rehearsal.recordings.push_back({.log = possible[i].name, .name = possible[i].name});
        rehearsal.recordings.back().road = possible[i].scenario.road;
        rehearsal.drives.push_back(recording::recordedDrive(rehearsal.recordings.back(), logs[i], file));
    }
    return rehearsal;
}

// Noise of the rows of a rehearsed drive: for each channel the mean over the recordings.
RowNoise noiseOf(const RecordedDrive& drive, const Calibration& car) {
    RowNoise noise{.deviation = Eigen::VectorXd::Ones(drive.rows()), .ends = {}};
    for (const ObservedChannel& channel : drive.channels) {
        double sum = 0, count = 0;
        for (std::size_t d = 0; d < car.drives().size(); ++d) {
            for (const ObservedChannel& known : car.drives()[d].channels) {
                const double one = car.uncertainty.noise[d].deviation(known.first_row);
                if (known.name == channel.name && std::isfinite(one)) sum += one, count += 1;
            }
        }
        if (count > 0) noise.deviation.segment(channel.first_row, channel.rows()).array() = sum / count;
        noise.ends.push_back(channel.first_row + channel.rows());
    }
    return noise;
}

// First look at a manoeuvre: its noise and disturbances, and the whitened difference between the two cars of each
// question.
struct Look {
    RowNoise noise;
    Eigen::MatrixXd directions;
    Eigen::VectorXd sizes;
    std::vector<Eigen::VectorXd> differences;  // per question; empty when one of the cars cannot drive it
    std::vector<double> most;                  // per question: nats if no parameter of the car were uncertain
};

Look lookAt(const RecordedDrive& drive, const Calibration& car, const std::vector<Question>& questions) {
    const model::Replays& replays = car.problem.replays;
    Look look{.noise = noiseOf(drive, car), .directions = {}, .sizes = {}, .differences = {}, .most = {}};
    const auto shown = [&](const model::Deviation& at) {
        const recording::Subject subject = replays.subjectAt(at, drive);
        const std::optional<Log> motion = model::motionAt(replays, drive, subject);
        return motion ? recording::readings(drive, *motion, subject.instruments) : Eigen::VectorXd{};
    };
    const model::Disturbances disturbing = model::disturbances(replays, drive, replays.nominal());
    look.directions = look.noise.over(disturbing.columns);
    look.sizes.resize(look.directions.cols());
    for (Eigen::Index i = 0; i < look.sizes.size(); ++i)
        look.sizes(i) = car.uncertainty.sizes[model::placeOf(disturbing.kinds[i])];
    model::Deviation last;
    Eigen::VectorXd rows;
    for (const Question& question : questions) {
        const Eigen::VectorXd one = shown(question.one);
        if (last.size() == 0 || last != question.other) rows = shown(question.other), last = question.other;
        const bool driven = one.size() > 0 && rows.size() > 0 && (one - rows).allFinite();
        if (!driven) {
            look.differences.emplace_back();
            look.most.push_back(0);
            continue;
        }
        look.differences.emplace_back(look.noise.over(one - rows));
        const auto products = inference::productsOf(look.differences.back(), look.directions);
        look.most.push_back(0.5 * inference::normalEquations(products, look.sizes).products(0, 0));
    }
    return look;
}

// Sensitivities of a drive to everything that is still uncertain: all tolerances, and the knobs of the open questions.
struct Answers {
    std::vector<Eigen::Index> parameters;  // tolerances, then knobs
    Eigen::Index nuisances;                // number of tolerances
    Eigen::MatrixXd columns;               // whitened
};

Answers answersOf(const RecordedDrive& drive, const Look& look, const Problem& problem,
                  const std::vector<Question>& questions) {
    Answers answers{problem.nuisances, std::ssize(problem.nuisances), {}};
    for (const Question& question : questions) {
        for (const Fit* fit : question.fits)
            answers.parameters.insert(answers.parameters.end(), fit->knobs.begin(), fit->knobs.end());
    }
    const auto knobs = answers.parameters.begin() + answers.nuisances;
    std::sort(knobs, answers.parameters.end());
    answers.parameters.erase(std::unique(knobs, answers.parameters.end()), answers.parameters.end());
    const model::Sensitivities about = model::sensitivities(problem.replays, {&drive, 1}, problem.replays.origin(),
                                                            {.parameters = answers.parameters});
    answers.columns = look.noise.over(about.columns.front()(Eigen::all, answers.parameters));
    return answers;
}

// Columns of the parameters that are uncertain in a fit, times the Cholesky factor of their covariance.
Eigen::MatrixXd uncertainColumns(const Answers& answers, const Fit& fit) {
    std::vector<Eigen::Index> places;  // tolerances, and the knobs of this fit
    std::vector<Eigen::Index> known;   // their places in the fit; -1: not in the fit, so the prior holds
    for (Eigen::Index i = 0; i < std::ssize(answers.parameters); ++i) {
        const auto place = std::find(fit.free.begin(), fit.free.end(), answers.parameters[i]);
        if (place == fit.free.end() && i >= answers.nuisances) continue;
        places.push_back(i);
        known.push_back(place == fit.free.end() ? -1 : place - fit.free.begin());
    }
    const Eigen::Index n = std::ssize(places);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            if (known[i] >= 0 && known[j] >= 0) covariance(i, j) = fit.covariance(known[i], known[j]);
    }
    return answers.columns(Eigen::all, places) * Eigen::MatrixXd(covariance.llt().matrixL());
}

// Nats of a difference that remain when the uncertain numbers of the car imitate it, as far as the recordings leave
// them free (D51).
double natsOf(const Look& look, const Answers& answers, const Fit& fit, const Eigen::VectorXd& difference) {
    const Eigen::MatrixXd uncertain = uncertainColumns(answers, fit);
    const Eigen::Index n = uncertain.cols();
    Eigen::MatrixXd columns(difference.size(), n + 1);
    columns << uncertain, difference;
    const auto sum = inference::normalEquations(inference::productsOf(columns, look.directions), look.sizes);
    return 0.5 * inference::withoutFirst(sum, n).products(0, 0);
}

// Chooses manoeuvres. The most promising one is studied first; the nats it reaches exclude all manoeuvres whose upper
// bound is lower.
class Chooser {
public:
    Chooser(const Calibration& car, const Rehearsal& rehearsal, const std::vector<Question>& questions, int before)
        : problem_(car.problem),
          rehearsal_(rehearsal),
          questions_(questions),
          before_(before),
          looks_(rehearsal.drives.size()),
          answers_(rehearsal.drives.size()) {
        drivenTogether(looks_.size(), problem_.replays.threads,
                       [&](std::size_t d) { looks_[d] = lookAt(rehearsal.drives[d], car, questions); });
    }

    // Best manoeuvre for one question; without a scenario when none reaches the threshold.
    answer::NextDrive best(std::size_t q) {
        const Question& question = questions_[q];
        std::vector<std::size_t> order(looks_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return looks_[a].most[q] > looks_[b].most[q]; });
        answer::NextDrive best{{}, question.causes_of_one, question.causes_of_other, 0};
        for (const std::size_t d : order) {
            if (looks_[d].most[q] <= std::max(best.nats, kSettings.clear)) break;
            if (!looked(d)) continue;
            double nats = kInfinity;
            for (const Fit* fit : question.fits)
                nats = std::min(nats, natsOf(looks_[d], *answers_[d], *fit, looks_[d].differences[q]));
            if (nats > best.nats) best.nats = nats, best.scenario = rehearsal_.drives[d].name;
        }
        return best;
    }

private:
    // Studies a manoeuvre in detail unless this was done or the simulations are used up; false in the last case. One
    // manoeuvre is always studied.
    bool looked(std::size_t d) {
        if (answers_[d]) return true;
        const bool first = std::none_of(answers_.begin(), answers_.end(), [](const auto& a) { return a.has_value(); });
        if (!first && problem_.replays.simulations.value() - before_ > kMostSimulations) return false;
        answers_[d] = answersOf(rehearsal_.drives[d], looks_[d], problem_, questions_);
        return true;
    }

    const Problem& problem_;
    const Rehearsal& rehearsal_;
    const std::vector<Question>& questions_;
    int before_;  // simulations at the start of the rehearsal
    std::vector<Look> looks_;
    std::vector<std::optional<Answers>> answers_;
};

}  // namespace

std::vector<answer::NextDrive> nextDrives(const answer::Diagnosis& diagnosis, const Calibration& car,
                                          const select::Search& found, const std::vector<PossibleDrive>& possible) {
    const std::vector<Question> questions = openQuestions(diagnosis, car.problem, found);
    if (questions.empty() || possible.empty()) return {};
    const int before = car.problem.replays.simulations.value();
    const Rehearsal rehearsal = rehearsed(car.problem, possible);
    Chooser chooser(car, rehearsal, questions, before);
    std::vector<answer::NextDrive> next;
    for (std::size_t q = 0; q < questions.size(); ++q) {
        answer::NextDrive best = chooser.best(q);
        if (best.nats >= kSettings.clear) next.push_back(std::move(best));
    }
    std::stable_sort(next.begin(), next.end(), [](const auto& a, const auto& b) { return a.nats > b.nats; });
    return next;
}

}  // namespace tread::diagnose::explain
