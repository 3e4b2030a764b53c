#include "diagnose_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text/number_text.h"
#include "base/yaml/position.h"
#include "base/yaml/session.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/precheck.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/catalogue/effects_to_consider.h"
#include "diagnose/options.h"
#include "diagnose/precheck.h"
#include "kind_of_file.h"
#include "output.h"
#include "plausibility.h"
#include "recording/checks/data_checks.h"
#include "recording/checks/rigid_body.h"
#include "recording/choose_windows.h"
#include "recording/diagnosis_file.h"
#include "recording/further_instruments.h"
#include "shipped_file.h"
#include "terminal.h"

namespace tread::program {
namespace {

using diagnose::answer::confusableJson;
using diagnose::answer::Precheck;
using diagnose::answer::precheckText;
using diagnose::answer::Visibility;
using diagnose::answer::visibility;
using diagnose::catalogue::applies;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectsToConsider;
using recording::addFurtherInstruments;
using recording::chooseWindows;
using recording::DiagnosisFile;
using recording::loadDiagnosis;
using recording::nominalSubject;
using recording::readRecordings;
using recording::Recording;
using recording::checks::DataWarning;
using recording::checks::dataWarnings;
using recording::checks::leaveOutContradictions;

struct Checked {
    std::vector<std::string> warnings;  // about the data, and about drives that the nominal car cannot repeat
    Precheck precheck;
    Visibility groups;
};

Checked check(const DiagnosisInputs& inputs, tread::diagnose::Options options) {
    Checked checked{inputs.warnings, {}, {}};
    Progress bar(100, "%");
    options.progress = [&](double done, const std::string&) { bar.at(100 * done); };
    try {
        checked.precheck =
            tread::diagnose::precheckOf(inputs.nominal, inputs.file, inputs.recorded, inputs.effects, options);
    } catch (const std::invalid_argument& error) {
        checked.warnings.push_back(
            fmt::format("{}; the expected evidence is therefore unknown. Check the previous "
                        "warnings and the vehicle file.",
                        error.what()));
    }
    const std::vector<std::string>& more = checked.precheck.warnings;
    checked.warnings.insert(checked.warnings.end(), more.begin(), more.end());
    checked.groups = visibility(checked.precheck.expected_evidence);
    return checked;
}

std::string answer(std::size_t recordings, const Checked& checked) {
    const std::size_t warnings = checked.warnings.size(), effects = checked.precheck.expected_evidence.size();
    std::string words = fmt::format("{} recording{}", recordings, recordings == 1 ? "" : "s");
    words = warnings == 0 ? words + (recordings == 1 ? " is fine" : " are fine")
                          : fmt::format("{} warning{} about {}", warnings, warnings == 1 ? "" : "s", words);
    if (effects == 0) return words;
    return fmt::format("{}; {} of {} effect{} would be found", words, checked.groups.found.size(), effects,
                       effects == 1 ? "" : "s");
}

std::vector<std::string> namesOf(const Visibility::Group& group) {
    std::vector<std::string> names;
    for (const auto& [name, nats] : group) names.push_back(name);
    return names;
}

std::vector<std::string> effectsWithoutNumbers(const DiagnosisInputs& inputs) {
    std::vector<std::string> names;
    for (const Effect& effect : inputs.effects) {
        if (!applies(effect, inputs.nominal)) names.push_back(effect.name);
    }
    return names;
}

// Adds the position in the file to faults of its entries.
void locate(const Path& file, const std::function<void()>& judge) {
    try {
        judge();
    } catch (const LoadError& error) {
        std::vector<Problem> problems = error.problems();
        for (Problem& problem : problems) {
            if (!problem.file.empty()) continue;
            const TextPosition position = positionOfValue(file.string(), problem.path);
            problem.file = file.string(), problem.line = position.line, problem.column = position.column;
        }
        throw LoadError(std::move(problems));
    }
}

bool isNamed(const Recording& recording, const std::string& name) {
    return recording.name == name || Path(recording.log).filename() == Path(name).filename();
}

// Holds out the named recordings. Throws LoadError for a name that no recording has.
void holdOut(DiagnosisFile& file, const std::vector<std::string>& names) {
    std::vector<Problem> problems;
    for (const std::string& name : names) {
        bool found = false;
        for (Recording& recording : file.recordings) {
            if (!isNamed(recording, name)) continue;
            recording.hold_out = found = true;
        }
        if (!found)
            problems.push_back({"--without", 0, 0, "", "found " + quote(name) + ", expected a recording of the file"});
    }
    throwIfAny(std::move(problems));
}

}  // namespace

DiagnosisInputs readDiagnosisInputs(const Path& file, const Path& data, const std::string& vehicle,
                                    const std::vector<std::string>& without) {
    DiagnosisInputs inputs;
    expectKind(file, {"diagnosis"});
    const std::string car = shippedFile(vehicle, "vehicles");
    expectKind(car, {"vehicle"});
    inputs.file = loadDiagnosis(file, data, shippedFileNamed);
    holdOut(inputs.file, without);
    if (!vehicle.empty()) inputs.file.vehicle = car, inputs.file.vehicle_settings.clear();
    expectKind(inputs.file.vehicle, {"vehicle"});
    inputs.recorded = readRecordings(inputs.file);
    chooseWindows(inputs.file, inputs.recorded);
    addFurtherInstruments(inputs.file.instruments, inputs.recorded.logs);
    addFurtherInstruments(inputs.file.instruments, inputs.recorded.before);
    inputs.nominal = nominalSubject(inputs.file);
    inputs.implausible = implausibleIn(inputs.nominal.vehicle, inputs.file.vehicle,
                                       {{inputs.file.vehicle_settings, file.string(), "", "vehicle_settings"}});
    locate(file, [&] { inputs.effects = effectsToConsider(inputs.file); });
    inputs.warnings = inputs.recorded.notes;
    for (const DataWarning& warning : dataWarnings(inputs.file, inputs.recorded, inputs.nominal))
        inputs.warnings.push_back(toText(warning));
    for (std::string& sentence : leaveOutContradictions(inputs.file, inputs.recorded))
        inputs.warnings.push_back(std::move(sentence));
    return inputs;
}

void warnOf(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) warn(warning);
}

int checkData(const DiagnosisInputs& inputs, tread::diagnose::Options options, bool json) {
    const Checked checked = check(inputs, std::move(options));
    const std::string words = answer(inputs.recorded.logs.size(), checked);
    const std::vector<std::string> without = effectsWithoutNumbers(inputs);
    if (json) {
        printJson({{"answer", words},
                   {"data_warnings", checked.warnings},
                   {"expected_evidence", checked.precheck.expected_evidence},
                   {"confusable", confusableJson(checked.precheck.confusable)},
                   {"can_be_found", namesOf(checked.groups.found)},
                   {"may_show", namesOf(checked.groups.perhaps)},
                   {"cannot_be_seen", namesOf(checked.groups.hidden)},
                   {"not_of_this_car", without},
                   {"simulations", checked.precheck.simulations}});
    } else {
        std::string text = words + "\n";
        for (const std::string& warning : checked.warnings) text += "  " + warning + "\n";
        text += precheckText(checked.precheck);
        if (!without.empty()) text += fmt::format("Not applicable to this car: {}\n", fmt::join(without, ", "));
        say(text, checked.warnings.empty() ? Tone::good : Tone::bad);
    }
    return checked.warnings.empty() ? kYes : kNo;
}

}  // namespace tread::program
