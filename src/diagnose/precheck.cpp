#include "diagnose/precheck.h"

#include "diagnose/select/screen.h"
#include "recording/checks/left_out.h"

namespace tread::diagnose {

answer::Precheck precheckOf(const recording::Subject& nominal, const recording::DiagnosisFile& file,
                            const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                            const Options& options) {
    const model::Problem problem = model::problemOf(nominal, file, recorded, effects, options);
    const select::Calibration car = select::uncalibrated(
        problem, model::nominalCar(problem, partOf(options.progress, 0, 0.6)), partOf(options.progress, 0.6, 1));
    const select::Screen screened = select::screen(car);

    answer::Precheck result;
    for (std::size_t e = 0; e < problem.effects.size(); ++e)
        result.expected_evidence[problem.effects[e].name] = screened.expected_evidence[e];
    result.confusable = select::confusablePairs(car, screened, screened.expected_evidence);
    result.warnings = recording::checks::leftOut(problem.drives, car.uncertainty.until);
    result.simulations = problem.replays.simulations.value();
    options.progress(1, "done");
    return result;
}

}  // namespace tread::diagnose
