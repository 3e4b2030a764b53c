#include "diagnose/answer/vehicle_with_effect.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/number_text.h"
#include "diagnose/answer/changed_numbers.h"
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
    const auto set = [&](const std::string& path, const auto& estimate) {
        if (double* number = recording::numberAt(nominal, path)) *number = estimate.value;
    };
    for (const auto& [path, estimate] : diagnosis.before.moved) set(path, estimate);
    forEachFitted(diagnosis,
                  [&](const RankedEffect&, const std::string& path, const Estimate& estimate) { set(path, estimate); });
    return nominal;
}

std::string vehicleWithEffectYaml(const recording::Subject& nominal, const Diagnosis& diagnosis) {
    std::string head = "# " + diagnosis.answer + ".\n";
    std::string beside;
    const auto lineOf = [](const std::string& path, const auto& estimate, const std::string& otherwise) {
        const ReferenceRow* row = recording::subjectNumber(path);
        const std::string unit = row && row->unit != "-" ? " " + row->unit : "";
        return fmt::format("{} = {:.4g}{} (+- {:.2g}), {}\n", path, estimate.value, unit, estimate.sd, otherwise);
    };
    const char* const neutral = diagnosis.compared ? "before" : "nominal";
    forEachFitted(diagnosis, [&](const RankedEffect& effect, const std::string& path, const Estimate& estimate) {
        (recording::isOfTheCar(path) ? head : beside) += fmt::format(
            "#   {}: {}", effect.name, lineOf(path, estimate, fmt::format("{} {:.4g}", neutral, estimate.neutral)));
    });
    std::string before;
    for (const MovedNumber& one : movedNumbers(diagnosis.before.moved))
        if (recording::isOfTheCar(one.name))
            before += "#   " + lineOf(one.name, one.estimate, fmt::format("nominal {:.4g}", one.estimate.nominal));
    if (!before.empty()) head += "# The car before the change, as fitted to its drives:\n" + before;
    if (!beside.empty()) head += "# Not numbers of the car, and therefore not in this file:\n" + beside;
    return head + vehicleYaml(withCauses(nominal, diagnosis).vehicle);
}

}  // namespace tread::diagnose::answer
