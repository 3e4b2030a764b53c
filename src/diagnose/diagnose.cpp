#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "diagnose/calibrate.h"
#include "diagnose/diagnosis.h"
#include "diagnose/how_far.h"
#include "diagnose/replay.h"
#include "diagnose/verdict.h"
#include "diagnose/where.h"
#include "identify/parallel.h"

namespace tread {
namespace {

constexpr double kNegligible = 0.01;  // nats that a nuisance of usual size makes of difference

void prepare(Bench& bench, const Subject& nominal, const DiagnosisFile& file, const DiagnoseOptions& options) {
    bench.nominal = nominal;
    bench.step = file.step;
    bench.simulate = options.simulate;
    bench.threads = options.threads;
}

// The recordings from which to learn, or those held out.
std::vector<RecordedDrive> drivesOf(const DiagnosisFile& file, const std::vector<Log>& logs, bool held_out) {
    std::vector<RecordedDrive> drives;
    for (std::size_t i = 0; i < file.recordings.size(); ++i) {
        if (file.recordings[i].hold_out == held_out) drives.push_back(recordedDrive(file.recordings[i], logs[i], file));
    }
    return drives;
}

void addParameters(Study& study, const DiagnosisFile& file, const std::vector<Effect>& effects) {
    Bench& bench = study.bench;
    bench.parameters = nuisances(bench.nominal, file.tolerances);
    for (std::size_t i = 0; i < bench.parameters.size(); ++i) study.nuisances.push_back(static_cast<Eigen::Index>(i));
    for (const Effect& effect : effects) {
        std::vector<Eigen::Index> knobs;
        for (Parameter& parameter : knobsOf(effect, bench.nominal)) {
            knobs.push_back(static_cast<Eigen::Index>(bench.parameters.size()));
            bench.parameters.push_back(std::move(parameter));
        }
        if (knobs.empty()) continue;
        study.effects.push_back(effect);
        study.knobs.push_back(std::move(knobs));
    }
}

// Nuisances without which the answer is the same are left out.
std::vector<Eigen::Index> thatMatter(const Study& study, const Linearised& about) {
    std::vector<double> matter(study.nuisances.size(), 0);
    for (std::size_t d = 0; d < about.columns.size(); ++d) {
        Eigen::MatrixXd columns = about.columns[d](Eigen::all, study.nuisances);
        columns.array().colwise() /= study.uncertainty.noise[d].array();
        const Gram gram = whitened(driveGram(columns, study.uncertainty.directions[d]),
                                   study.uncertainty.sizesOf(d, study.uncertainty.sizes));
        for (std::size_t i = 0; i < matter.size(); ++i)
            matter[i] += 0.5 * gram.products(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
    }
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < matter.size(); ++i)
        if (matter[i] > kNegligible) kept.push_back(study.nuisances[i]);
    return kept;
}

void tellNuisances(Diagnosis& diagnosis, const Study& study, const Fit& fit) {
    for (std::size_t i = 0; i < study.calibrated.nuisances.size(); ++i) {
        const Eigen::Index p = fit.free[i];
        const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(p)];
        const Parameter::Move& one = parameter.moves.front();
        const double sd = std::sqrt(fit.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)));
        diagnosis.nuisance[one.path] = {one.nominal + fit.at(p) * one.by, sd * std::abs(one.by), fit.at(p)};
    }
}

}  // namespace

Diagnosis diagnose(const Subject& nominal, const DiagnosisFile& file, const std::vector<Log>& logs,
                   const std::vector<Effect>& effects, const DiagnoseOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    Diagnosis diagnosis;
    const auto progress = [&](double from, double to) {
        return [&, from, to](double share, const std::string& what) {
            options.progress(from + (to - from) * share, what);
        };
    };

    // The recordings, and what may differ between them and the model.
    Study study;
    prepare(study.bench, nominal, file, options);
    study.bench.drives = drivesOf(file, logs, false);
    if (study.bench.drives.empty())
        throw std::invalid_argument("every recording is held out, expected at least one from which to learn");
    addParameters(study, file, effects);

    // The nominal car: what its tolerances do, noise, disturbances.
    const auto start = progress(0, 0.1);
    Linearised about = linearised(study.bench, study.bench.origin(), {.parameters = study.nuisances},
                                  [&](double share) { start(share, "sensitivities to tolerances"); });
    for (std::size_t d = 0; d < about.rows.size(); ++d) {
        if (about.rows[d].size() == 0)
            throw std::invalid_argument(
                fmt::format("recording {}: the nominal car cannot be driven so", study.bench.drives[d].name));
    }
    study.nominal = about.rows;
    study.uncertainty = uncertaintyOf(study.bench, study.bench.origin(), study.nominal);
    const std::vector<Eigen::Index> matter = thatMatter(study, about);

    // The calibrated one, from which effects are sought.
    const std::vector<DriveGram> grams =
        calibrate(study, ground(study.bench, std::move(about), matter, study.uncertainty), progress(0.1, 0.4));

    // Which effect.
    const Screen screened = screen(study, grams);
    const Search found = search(study, screened, progress(0.4, 0.9));
    const Inflation larger = inflation(study, found.best().fit);
    judge(diagnosis, study, screened, found, larger);
    diagnosis.confusable = confusablePairs(study, screened, grams);
    tellNuisances(diagnosis, study, found.best().fit);

    // Where, and how far.
    diagnosis.where = whereItLies(study, found);
    howFar(diagnosis, study, found, drivesOf(file, logs, true));
    options.progress(1, "done");
    diagnosis.simulations += study.bench.simulations;
    diagnosis.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return diagnosis;
}

}  // namespace tread
