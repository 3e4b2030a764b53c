#include "diagnose/precheck.h"

#include "diagnose/calibrate.h"
#include "diagnose/screen.h"
#include "diagnose/sliding.h"

namespace tread {

Precheck precheck(const Subject& nominal, const DiagnosisFile& file, const Recorded& recorded,
                  const std::vector<Effect>& effects, const DiagnoseOptions& options) {
    Study study;
    begin(study.bench, nominal, file, recorded, options);
    drivesOf(study.bench, file, recorded, true);  // throws what they would throw in the end
    addParameters(study, file, effects);

    // The nominal car stands for the calibrated one: nothing is moved.
    Linearised about =
        aboutNominal(study, [&](double share, const std::string& what) { options.progress(0.6 * share, what); });
    const std::vector<Eigen::Index> matter = thatMatter(study, about);
    study.calibrated = ground(std::move(about), matter, study.uncertainty);
    study.calibration.free = matter;
    study.calibration.at = study.bench.origin();
    study.calibration.rows = study.nominal;
    study.calibration.columns = study.calibrated.columns;

    // The effects about it, and what is left of them when all that is uncertain has imitated them.
    Linearised with_knobs = withKnobs(study, study.calibrated.about, [&](double share) {
        options.progress(0.6 + 0.4 * share, "sensitivities to effects");
    });
    study.calibrated = ground(std::move(with_knobs), matter, study.uncertainty);
    const std::vector<DriveGram> grams = everything(study, study.calibrated);
    const Screen screened = screen(study, grams);

    Precheck result;
    for (std::size_t e = 0; e < study.effects.size(); ++e)
        result.testable[study.effects[e].name] = screened.detectability[e];
    result.confusable = confusablePairs(study, screened, grams);
    result.warnings = leftOut(study.bench.drives);
    result.simulations = study.bench.simulations;
    options.progress(1, "done");
    return result;
}

}  // namespace tread
