#include "diagnose/answer/vehicle_with_effect.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/number_text.h"
#include "recording/subject_paths.h"
#include "tread/load.h"

namespace tread::diagnose::answer {
namespace {

// Calls visit(effect, path, estimate) for every fitted parameter of the causes.
void forEachFitted(const Diagnosis& diagnosis, const auto& visit) {
    for (const RankedEffect& effect : diagnosis.effects) {
        const auto& causes = diagnosis.causes;
        if (std::find(causes.begin(), causes.end(), effect.name) == causes.end()) continue;
        for (const auto& [path, estimate] : effect.parameters) visit(effect, path, estimate);
    }
}

}  // namespace

recording::Subject withCauses(recording::Subject nominal, const Diagnosis& diagnosis) {
    forEachFitted(diagnosis, [&](const RankedEffect&, const std::string& path, const Estimate& estimate) {
        if (double* number = recording::numberAt(nominal, path)) *number = estimate.value;
    });
    return nominal;
}

std::string vehicleWithEffectYaml(const recording::Subject& nominal, const Diagnosis& diagnosis) {
    std::string head = "# " + diagnosis.answer + ".\n";
    std::string beside;
    forEachFitted(diagnosis, [&](const RankedEffect& effect, const std::string& path, const Estimate& estimate) {
        const ReferenceRow* row = recording::subjectNumber(path);
        const std::string unit = row && row->unit != "-" ? " " + row->unit : "";
        const std::string line = fmt::format("#   {}: {} = {:.4g}{} (+- {:.2g}), nominal {:.4g}\n", effect.name, path,
                                             estimate.value, unit, estimate.sd, estimate.neutral);
        (recording::isOfTheCar(path) ? head : beside) += line;
    });
    if (!beside.empty()) head += "# Not numbers of the car, and therefore not in this file:\n" + beside;
    return head + vehicleYaml(withCauses(nominal, diagnosis).vehicle);
}

}  // namespace tread::diagnose::answer
