#include "diagnose_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "output.h"

namespace tread::program {
namespace {

std::string answer(const DiagnosisInputs& inputs) {
    const std::size_t n = inputs.logs.size(), w = inputs.warnings.size();
    const std::string drives = fmt::format("{} recording{}", n, n == 1 ? "" : "s");
    return w == 0 ? drives + (n == 1 ? " is fine" : " are fine")
                  : fmt::format("{} warning{} about {}", w, w == 1 ? "" : "s", drives);
}

// The effects that the car has numbers for, and those that it has not.
std::vector<std::string> applying(const DiagnosisInputs& inputs, bool wanted) {
    std::vector<std::string> names;
    for (const Effect& effect : inputs.effects) {
        if (applies(effect, inputs.nominal) == wanted) names.push_back(effect.name);
    }
    return names;
}

}  // namespace

DiagnosisInputs readDiagnosisInputs(const Path& file, const Path& data, const std::string& vehicle) {
    DiagnosisInputs inputs;
    inputs.file = loadDiagnosis(file, data);
    if (!vehicle.empty()) inputs.file.vehicle = vehicle, inputs.file.vehicle_settings.clear();
    inputs.nominal = nominalSubject(inputs.file);
    inputs.effects = effectsToConsider(inputs.file);
    Recorded recorded = readRecordings(inputs.file);
    inputs.logs = std::move(recorded.logs);
    inputs.warnings = std::move(recorded.notes);
    for (const DataWarning& warning : dataWarnings(inputs.file, inputs.logs, inputs.nominal))
        inputs.warnings.push_back(toText(warning));
    return inputs;
}

int checkData(const DiagnosisInputs& inputs, bool json) {
    const std::string words = answer(inputs);
    const std::vector<std::string> without = applying(inputs, false);
    if (json) {
        printJson({{"answer", words},
                   {"data_warnings", inputs.warnings},
                   {"effects", applying(inputs, true)},
                   {"not_of_this_car", without}});
    } else {
        std::string text = words + "\n";
        for (const std::string& warning : inputs.warnings) text += "  " + warning + "\n";
        text += fmt::format("{} effects are considered", inputs.effects.size() - without.size());
        if (!without.empty()) text += fmt::format("; this car has no numbers for {}", fmt::join(without, ", "));
        print(text + "\n");
    }
    return inputs.warnings.empty() ? kYes : kNo;
}

}  // namespace tread::program
