#include <algorithm>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "base/yaml/setting.h"
#include "log/log_columns.h"
#include "recording/diagnosis_file.h"
#include "recording/further_instruments.h"
#include "recording/subject_paths.h"
#include "tread/load.h"

namespace tread::recording {
namespace {

using Path = std::filesystem::path;

// Faults that cannot be seen in the file alone: paths of numbers, names of channels and effects, missing files.
struct Faults {
    const Path& file;
    std::vector<Problem> problems = {};

    void add(const std::string& path, std::string text) {
        if (text.empty()) return;
        const TextPosition position = positionOfValue(file.string(), path);
        problems.push_back({file.string(), position.line, position.column, path, std::move(text)});
    }
    void addUnlessThere(const std::string& path, const std::string& name) {
        if (!name.empty() && !std::filesystem::exists(name))
            add(path, "found " + quote(name) + ", which does not exist; expected an existing file");
    }
};

std::string channelFault(const std::string& channel) {
    if (logUnit(channel)) return {};
    std::vector<std::string> names;
    for (const ReferenceRow& row : referenceTable<LogColumns>()) names.push_back(row.path);
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string suggestion = didYouMean(channel, known);
    return "found the unknown channel " + quote(channel) + ", expected a name such as chassis.yaw_rate" +
           (suggestion.empty() ? ";" : suggestion) + " `tread describe log` lists all channels";
}

std::string at(const char* list, std::size_t i, const char* field) {
    return std::string(list) + "." + std::to_string(i) + "." + field;
}

// Names of a list of recordings, and the files that they name.
void judgeRecordings(Faults& faults, const char* list, const std::vector<Recording>& recordings, bool with_logs) {
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        const Recording& recording = recordings[i];
        const std::string& name = recording.name;
        if (name == "." || name == ".." || name.find_first_of("/\\") != std::string::npos)
            faults.add(
                at(list, i, "name"),
                "found " + quote(name) + ", expected a name without slashes, not . or ..: it is used as a folder name");
        if (!with_logs) continue;
        faults.addUnlessThere(at(list, i, "log"), recording.log);
        faults.addUnlessThere(at(list, i, "reference"), recording.reference);
        if (recording.reference == recording.log)
            faults.add(at(list, i, "reference"),
                       "found the recording itself, expected the log of the same drive before the change");
    }
}

void judgeBefore(Faults& faults, const std::vector<Recording>& before) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!before[i].reference.empty())
            faults.add(at("before", i, "reference"),
                       "found a reference for a drive of the car before the change, expected none: the drive is a "
                       "reference itself");
        if (before[i].hold_out)
            faults.add(at("before", i, "hold_out"),
                       "found true for a drive of the car before the change, expected false: the car is fitted to it");
    }
}

void judgeNames(Faults& faults, const DiagnosisFile& diagnosis, bool with_logs) {
    for (std::size_t i = 0; i < diagnosis.channels.size(); ++i)
        faults.add(at("channels", i, "channel"), channelFault(diagnosis.channels[i].channel));
    for (std::size_t i = 0; i < diagnosis.tolerances.size(); ++i)
        faults.add(at("tolerances", i, "path"), pathFault(diagnosis.tolerances[i].path));
    for (std::size_t i = 0; i < diagnosis.instruments.further.size(); ++i)
        faults.add(at("instruments.further", i, "channel"),
                   furtherChannelFault(diagnosis.instruments.further[i].channel));
    for (std::size_t i = 0; i < diagnosis.fit.size(); ++i)
        faults.add("fit." + std::to_string(i), pathFault(diagnosis.fit[i]));
    faults.addUnlessThere("vehicle", diagnosis.vehicle);
    faults.addUnlessThere("import", diagnosis.import);
    faults.addUnlessThere("own_effects", diagnosis.own_effects);
    judgeRecordings(faults, "recordings", diagnosis.recordings, with_logs);
    judgeRecordings(faults, "before", diagnosis.before, with_logs);
    judgeBefore(faults, diagnosis.before);
    if (std::all_of(diagnosis.recordings.begin(), diagnosis.recordings.end(),
                    [](const Recording& recording) { return recording.hold_out; }))
        faults.add("recordings", "found hold_out: true for every recording, expected at least one recording to fit");
}

// Every drive that the file names.
std::vector<Recording*> allRecordings(DiagnosisFile& diagnosis) {
    std::vector<Recording*> all;
    for (std::vector<Recording>* list : {&diagnosis.recordings, &diagnosis.before})
        for (Recording& recording : *list) all.push_back(&recording);
    return all;
}

// Gives every recording a name of its own, by which the report tells them apart.
void nameRecordings(DiagnosisFile& diagnosis) {
    std::vector<std::string> taken;
    for (Recording* recording : allRecordings(diagnosis)) {
        std::string name = recording->name.empty() ? Path(recording->log).stem().string() : recording->name;
        const std::string plain = name;
        for (int i = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++i)
            name = plain + " (" + std::to_string(i) + ")";
        recording->name = name;
        taken.push_back(name);
    }
}

DiagnosisFile load(const Path& file, const Path& data, const ShippedFiles& shipped, bool with_logs) {
    std::vector<Problem> problems;
    DiagnosisFile diagnosis = readYaml<DiagnosisFile>(file, problems);
    const Path folder = file.parent_path();
    diagnosis.vehicle = namedFile(folder, diagnosis.vehicle, shipped, "vehicles");
    diagnosis.import = namedFile(folder, diagnosis.import);
    diagnosis.own_effects = namedFile(folder, diagnosis.own_effects);
    for (Recording* recording : allRecordings(diagnosis)) {
        for (std::string* log : {&recording->log, &recording->reference})
            *log = namedFile(data.empty() ? folder : data, *log);
    }
    nameRecordings(diagnosis);
    Faults faults{file};
    judgeNames(faults, diagnosis, with_logs);
    addFurther(problems, std::move(faults.problems));
    throwIfAny(std::move(problems));
    return diagnosis;
}

}  // namespace

DiagnosisFile loadDiagnosis(const Path& file, const Path& data, const ShippedFiles& shipped) {
    return load(file, data, shipped, true);
}

DiagnosisFile checkedDiagnosis(const Path& file, const ShippedFiles& shipped) {
    return load(file, {}, shipped, false);
}

Subject nominalSubject(const DiagnosisFile& file) {
    Subject subject;
    subject.vehicle = loadVehicle(file.vehicle);
    subject.instruments = file.instruments;
    applySettings(subject.vehicle, file.vehicle_settings, "vehicle_settings",
                  [](std::string_view) { return std::string("`tread describe vehicle` lists all paths"); });
    return subject;
}

}  // namespace tread::recording
