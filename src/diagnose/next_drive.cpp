#include "diagnose/next_drive.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "diagnose/open_question.h"
#include "diagnose/replay.h"
#include "diagnose/thresholds.h"
#include "identify/parallel.h"

namespace tread {
namespace {

constexpr int kMostSimulations = 150;  // beyond, no further manoeuvre is looked at closely
constexpr double kLoggedRate = 100;    // Hz

// What the nominal car's instruments would show of a manoeuvre, driven as its file says; no rows when it cannot be.
Log imagined(const Bench& bench, const Scenario& told, const std::vector<ObservedChannel>& channels) {
    Scenario scenario = told;
    scenario.log.rate = kLoggedRate;
    scenario.log.channels = {"driver.*", "driveline.gear", "chassis.vx", "chassis.yaw_rate"};
    scenario.log.sensors = {};
    for (const ObservedChannel& channel : channels) scenario.log.channels.push_back(channel.name);
    Log log;
    try {
        bench.simulate(bench.nominal.vehicle, scenario, recorderInto(log), {});
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError&) {
        log.channels.clear();
    }
    return log;
}

// Manoeuvres on the bench in place of the recordings, for as long as this lives.
class Rehearsal {
public:
    Rehearsal(Study& study, const std::vector<PossibleDrive>& possible) : study_(study), recorded_(study.bench.drives) {
        DiagnosisFile file;
        for (const ObservedChannel& channel : recorded_.front().channels) file.channels.push_back({channel.name});
        std::vector<Log> logs(possible.size());
        inParallel(possible.size(), study.bench.threads, [&](std::size_t i) {
            logs[i] = imagined(study.bench, possible[i].scenario, recorded_.front().channels);
        });
        std::vector<RecordedDrive> drives;
        for (std::size_t i = 0; i < possible.size(); ++i) {
            ++study.bench.simulations;
            if (logs[i].channels.empty() || logs[i].samples() < 2) continue;
            recordings_.push_back({.log = possible[i].name, .name = possible[i].name});
            recordings_.back().road = possible[i].scenario.road;
            drives.push_back(recordedDrive(recordings_.back(), logs[i], file));
        }
        study.bench.drives = std::move(drives);
    }
    ~Rehearsal() { study_.bench.drives = std::move(recorded_); }
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    // Noise of the rows of a drive: per channel as in the recordings.
    RowNoise noiseOf(const RecordedDrive& drive) const {
        RowNoise noise{.deviation = Eigen::VectorXd::Ones(drive.rows()), .ends = {}};
        for (const ObservedChannel& channel : drive.channels) {
            double sum = 0, count = 0;
            for (std::size_t d = 0; d < recorded_.size(); ++d) {
                for (const ObservedChannel& known : recorded_[d].channels) {
                    const double one = study_.uncertainty.noise[d].deviation(known.first_row);
                    if (known.name == channel.name && std::isfinite(one)) sum += one, count += 1;
                }
            }
            const auto rows = static_cast<Eigen::Index>(channel.times.size());
            if (count > 0) noise.deviation.segment(channel.first_row, rows).array() = sum / count;
            noise.ends.push_back(channel.first_row + rows);
        }
        return noise;
    }

private:
    Study& study_;
    std::vector<RecordedDrive> recorded_;
    std::deque<Recording> recordings_;  // to which the drives point
};

// One manoeuvre: what disturbs it, and by how much the two cars of each question differ there, over the noise.
struct Look {
    std::size_t drive = 0;
    RowNoise noise;
    Eigen::MatrixXd directions;
    Eigen::VectorXd sizes;
    std::vector<Eigen::VectorXd> differences;  // per question; empty when one of the cars cannot be driven so
    std::vector<double> most;                  // nats per question if nothing of the car were uncertain
};

Look lookAt(Study& study, const Rehearsal& rehearsal, std::size_t d, const std::vector<Question>& questions) {
    Bench& bench = study.bench;
    const RecordedDrive& drive = bench.drives[d];
    Look look{
        .drive = d, .noise = rehearsal.noiseOf(drive), .directions = {}, .sizes = {}, .differences = {}, .most = {}};
    const auto shown = [&](const Deviation& at) {
        const Subject subject = bench.subjectAt(at);
        const std::optional<Log> motion = motionAt(bench, d, subject);
        return motion ? readings(drive, *motion, subject.instruments) : Eigen::VectorXd{};
    };
    const Disturbances disturbing = disturbances(bench, d, bench.nominal);
    look.directions = look.noise.over(disturbing.columns);
    look.sizes.resize(look.directions.cols());
    for (std::size_t i = 0; i < disturbing.kinds.size(); ++i)
        look.sizes(static_cast<Eigen::Index>(i)) =
            study.uncertainty.sizes[static_cast<std::size_t>(disturbing.kinds[i])];
    Deviation last;
    Eigen::VectorXd rows;
    for (const Question& question : questions) {
        const Eigen::VectorXd one = shown(question.one);
        if (last.size() == 0 || last != question.other) rows = shown(question.other), last = question.other;
        const bool driven = one.size() > 0 && rows.size() > 0 && (one - rows).allFinite();
        look.differences.push_back(driven ? Eigen::VectorXd(look.noise.over(one - rows)) : Eigen::VectorXd{});
        look.most.push_back(
            driven ? 0.5 * whitened(driveGram(look.differences.back(), look.directions), look.sizes).products(0, 0)
                   : 0);
    }
    return look;
}

// How the drive answers to everything that may still move: all tolerances, and the knobs of those questions.
struct Answers {
    std::vector<Eigen::Index> parameters;  // tolerances, then knobs
    std::size_t nuisances;                 // how many tolerances
    Eigen::MatrixXd columns;               // over the noise
};

Answers answersOf(Study& study, const Look& look, const std::vector<Question>& questions) {
    Answers answers{study.nuisances, study.nuisances.size(), {}};
    for (const Question& question : questions) {
        for (const Fit* fit : question.fits)
            answers.parameters.insert(answers.parameters.end(), fit->knobs.begin(), fit->knobs.end());
    }
    const auto knobs = answers.parameters.begin() + static_cast<std::ptrdiff_t>(answers.nuisances);
    std::sort(knobs, answers.parameters.end());
    answers.parameters.erase(std::unique(knobs, answers.parameters.end()), answers.parameters.end());
    // The one drive alone on the bench.
    std::vector<RecordedDrive> all = std::move(study.bench.drives);
    study.bench.drives = {all[look.drive]};
    const Linearised about = linearised(study.bench, study.bench.origin(), {.parameters = answers.parameters});
    study.bench.drives = std::move(all);
    answers.columns = look.noise.over(about.columns.front()(Eigen::all, answers.parameters));
    return answers;
}

// Nats that are left of a difference when a car's uncertain numbers, as well as the recordings have determined them,
// imitate it.
double natsOf(const Look& look, const Answers& answers, const Fit& fit, const Eigen::VectorXd& difference) {
    std::vector<Eigen::Index> places;  // columns of what may move: tolerances, and the knobs of this fit
    std::vector<Eigen::Index> known;   // their places in the fit; -1: as uncertain as before
    for (std::size_t i = 0; i < answers.parameters.size(); ++i) {
        const auto place = std::find(fit.free.begin(), fit.free.end(), answers.parameters[i]);
        if (place == fit.free.end() && i >= answers.nuisances) continue;
        places.push_back(static_cast<Eigen::Index>(i));
        known.push_back(place == fit.free.end() ? -1 : place - fit.free.begin());
    }
    const auto n = static_cast<Eigen::Index>(places.size());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            const Eigen::Index a = known[static_cast<std::size_t>(i)], b = known[static_cast<std::size_t>(j)];
            if (a >= 0 && b >= 0) covariance(i, j) = fit.covariance(a, b);
        }
    }
    Eigen::MatrixXd columns(difference.size(), n + 1);
    columns << answers.columns(Eigen::all, places), difference;
    // Columns that are as uncertain as one unit each.
    columns.leftCols(n) = (columns.leftCols(n) * Eigen::MatrixXd(covariance.llt().matrixL())).eval();
    const Gram gram = whitened(driveGram(columns, look.directions), look.sizes);
    std::vector<Eigen::Index> out(static_cast<std::size_t>(n));
    std::iota(out.begin(), out.end(), 0);
    return 0.5 * marginalised(gram, out).products(n, n);
}

}  // namespace

std::vector<NextDrive> nextDrives(const Diagnosis& diagnosis, Study& study, const Search& found,
                                  const std::vector<PossibleDrive>& possible) {
    const std::vector<Question> questions = openQuestions(diagnosis, study, found);
    if (questions.empty() || possible.empty()) return {};

    const int before = study.bench.simulations;
    const Rehearsal rehearsal(study, possible);
    std::vector<Look> looks(study.bench.drives.size());
    inParallel(looks.size(), study.bench.threads,
               [&](std::size_t d) { looks[d] = lookAt(study, rehearsal, d, questions); });

    // The most promising first; what it really tells bounds what is worth another look.
    std::vector<std::optional<Answers>> answers(looks.size());
    std::vector<NextDrive> next;
    for (std::size_t q = 0; q < questions.size(); ++q) {
        std::vector<std::size_t> order(looks.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return looks[a].most[q] > looks[b].most[q]; });
        NextDrive best{{}, questions[q].separates, 0};
        for (const std::size_t d : order) {
            if (looks[d].most[q] <= std::max(best.nats, kThresholds.separable)) break;
            const bool first =
                std::none_of(answers.begin(), answers.end(), [](const auto& a) { return a.has_value(); });
            if (!answers[d]) {
                if (!first && study.bench.simulations - before > kMostSimulations) continue;
                answers[d] = answersOf(study, looks[d], questions);
            }
            double nats = kInfinity;
            for (const Fit* fit : questions[q].fits)
                nats = std::min(nats, natsOf(looks[d], *answers[d], *fit, looks[d].differences[q]));
            if (nats > best.nats) best.nats = nats, best.scenario = study.bench.drives[d].name;
        }
        if (best.nats >= kThresholds.separable) next.push_back(std::move(best));
    }
    std::stable_sort(next.begin(), next.end(), [](const auto& a, const auto& b) { return a.nats > b.nats; });
    return next;
}

}  // namespace tread
