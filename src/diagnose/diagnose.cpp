#include "diagnose/diagnose.h"

#include <chrono>

#include "diagnose/answer/headline.h"
#include "diagnose/explain/decomposition.h"
#include "diagnose/explain/how_far.h"
#include "diagnose/explain/missing_force.h"
#include "diagnose/explain/next_drive.h"
#include "diagnose/explain/where.h"
#include "diagnose/model/remainder.h"
#include "diagnose/select/baselines.h"
#include "diagnose/select/car_before.h"
#include "diagnose/select/verdict.h"
#include "diagnose/select/vibration.h"
#include "diagnose/settings.h"

namespace tread::diagnose {
namespace {

using answer::Diagnosis;

// Values of the nuisance parameters in the best model.
void tellNuisances(Diagnosis& diagnosis, const model::Problem& problem, const select::Fit& fit) {
    for (Eigen::Index i = 0; i < fit.numbers(); ++i) {
        const std::string name = problem.replays.parameters[fit.free[i]].name();
        diagnosis.nuisance[name] = select::numberOf(fit, problem.replays, i);
    }
}

// The kind of errors of readings that is furthest beyond its usual size; empty if a kind of force is further, or if
// none is clearly beyond it.
std::string instrumentIn(const model::Sizes& sizes) {
    constexpr double kClearly = 2;  // standard deviations of the prior of a size
    const auto beyond = [&](model::Disturbed kind) { return model::kWidePrior.deviations(kind, sizes[placeOf(kind)]); };
    const auto furthest = *std::max_element(model::kAllDisturbed.begin(), model::kAllDisturbed.end(),
                                            [&](auto a, auto b) { return beyond(a) < beyond(b); });
    const bool is_error = model::isInstruments(furthest) && beyond(furthest) > kClearly;
    return is_error ? std::string(nameOf(furthest)) : std::string();
}

void tellUnexplained(Diagnosis& diagnosis, const explain::MissingForce& missing, const select::Judgement& judgement) {
    const select::Remains& remains = judgement.remains;
    const auto largest = std::max_element(missing.shares.begin(), missing.shares.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    answer::Unexplained& unexplained = diagnosis.unexplained;
    unexplained.generalised_force = largest->first;
    unexplained.when = missing.when;
    unexplained.instrument = instrumentIn(judgement.answer.sizes);
    unexplained.law = remains.law;
    unexplained.vibration = remains.vibration;
    unexplained.beyond_ordinary = std::max(remains.beyond_ordinary, remains.rejected);
    for (std::size_t k = 0; k < model::kDisturbances; ++k)
        unexplained.sizes[std::string(model::kDisturbedNames[k])] = judgement.answer.sizes[k];
    for (std::size_t k = 0; k < model::kParts; ++k)
        unexplained.sizes["imperfections of " + std::string(model::kPartNames[k])] =
            judgement.answer.imperfection[k] / kSettings.imperfection;
    if (!remains.law.generalised_force.empty()) unexplained.generalised_force = remains.law.generalised_force;
}

}  // namespace

Diagnosis diagnosisOf(const recording::Subject& nominal, const recording::DiagnosisFile& file,
                      const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                      const Options& options) {
    const auto started = std::chrono::steady_clock::now();
    const Progress& progress = options.progress;

    // The car before the change, if it was driven.
    const std::optional<select::CarBefore> before =
        select::carBefore(nominal, file, recorded, effects, options, partOf(progress, 0, 0.3));

    // The drives, and the calibrated car: the nominal car with its nuisance parameters fitted to the recordings.
    recording::DiagnosisFile after = file;
    if (before) after.tolerances = before->tolerances;
    const model::Problem problem = model::problemOf(before ? before->car : nominal, after, recorded, effects, options,
                                                    before ? before->left_open : std::vector<recording::KnownWithin>{});
    select::Calibration car =
        select::calibrate(problem, model::nominalCar(problem, partOf(progress, 0.3, 0.4), model::Resolution::rough),
                          partOf(progress, 0.4, 0.6));
    if (before) car.structure_error = before->structure_error;

    // Which effects explain the gap.
    const select::Screen screened = select::screen(car);
    select::Search found = select::search(car, screened, partOf(progress, 0.6, 0.9));
    const std::vector<double> expected = select::expectedEvidenceAt(car, found.best().fit, screened);
    Diagnosis diagnosis;
    diagnosis.compared = problem.compared();
    if (before) diagnosis.before = {before->gap.nominal, before->gap.calibrated, before->moved};
    diagnosis.baselines = select::baselines(car);
    const select::HeldOut held_out = select::heldOut(car);
    const select::Judgement judgement =
        select::judge(diagnosis, car, expected, found, held_out, select::vibrationOf(recorded));
    diagnosis.confusable = select::confusablePairs(car, screened, expected);
    tellNuisances(diagnosis, problem, judgement.named->fit);

    // Where the gap is, and how far the causes close it.
    const explain::MissingForce missing = explain::missingForce(car);
    tellUnexplained(diagnosis, missing, judgement);
    diagnosis.where = explain::whereItLies(car, missing);
    explain::decompose(diagnosis, car, judgement, held_out);
    explain::howFar(diagnosis, car, held_out, {car.closest.at, judgement.answer});
    diagnosis.next = explain::nextDrives(diagnosis, car, found, options.possible_next);
    diagnosis.answer = answer::headline(diagnosis);
    progress(1, "done");
    diagnosis.simulations = problem.replays.simulations.value();
    diagnosis.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return diagnosis;
}

}  // namespace tread::diagnose
