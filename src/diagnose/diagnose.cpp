#include <chrono>
#include <cmath>

#include "diagnose/baselines.h"
#include "diagnose/calibrate.h"
#include "diagnose/diagnosis.h"
#include "diagnose/how_far.h"
#include "diagnose/next_drive.h"
#include "diagnose/verdict.h"
#include "diagnose/where.h"

namespace tread {
namespace {

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

Diagnosis diagnose(const Subject& nominal, const DiagnosisFile& file, const Recorded& recorded,
                   const std::vector<Effect>& effects, const DiagnoseOptions& options) {
    const auto started = std::chrono::steady_clock::now();
    Diagnosis diagnosis;
    const auto progress = [&](double from, double to) {
        return [&, from, to](double share, const std::string& what) {
            options.progress(from + (to - from) * share, what);
        };
    };

    // The recordings, and what may differ between them and the model.
    Study study;
    begin(study.bench, nominal, file, recorded, options);
    std::vector<RecordedDrive> held_out = drivesOf(study.bench, file, recorded, true);
    addParameters(study, file, effects);
    diagnosis.compared = study.bench.compared();

    // The nominal car: what its tolerances do, noise, disturbances.
    Linearised about = aboutNominal(study, progress(0, 0.1));
    const std::vector<Eigen::Index> matter = thatMatter(study, about);

    // The calibrated one, from which effects are sought.
    const std::vector<DriveGram> grams =
        calibrate(study, ground(std::move(about), matter, study.uncertainty), progress(0.1, 0.4));

    // Which effect.
    Screen screened = screen(study, grams);
    diagnosis.baselines = baselines(study);
    const Search found = search(study, screened, progress(0.4, 0.9));
    lookAgain(study, found.best().fit, screened);
    const MissingForce missing = missingForce(study);
    judge(diagnosis, study, screened, found, outside(study, found), missing);
    diagnosis.confusable = confusablePairs(study, screened, grams);
    tellNuisances(diagnosis, study, found.best().fit);

    // Where, and how far.
    diagnosis.where = whereItLies(study, missing);
    howFar(diagnosis, study, found, std::move(held_out));
    diagnosis.next = nextDrives(diagnosis, study, found, options.possible_next);
    options.progress(1, "done");
    diagnosis.simulations += study.bench.simulations;
    diagnosis.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return diagnosis;
}

}  // namespace tread
