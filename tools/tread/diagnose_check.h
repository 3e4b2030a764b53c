// `tread diagnose FILE --check` and `tread diagnose --init FOLDER`: before a diagnosis.
#pragma once

#include <string>
#include <vector>

#include "calibrate/identification.h"
#include "commands.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/options.h"
#include "recording/checks/data_checks.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::program {

// A diagnosis and all that it names, read; with `vehicle`, that is the nominal car. Recordings in `without`, by name or
// log, are held out. Throws LoadError with every fault.
struct DiagnosisInputs {
    recording::DiagnosisFile file;
    recording::Subject nominal;
    std::vector<diagnose::catalogue::Effect> effects;
    recording::Recorded recorded;
    std::vector<std::string> warnings;  // of reading and of the data checks, one sentence or two each
    std::vector<Problem> implausible;   // numbers of the nominal car
};
DiagnosisInputs readDiagnosisInputs(const Path& file, const Path& data, const std::string& vehicle,
                                    const std::vector<std::string>& without = {});

// The diagnosis of these inputs, among its warnings theirs. Throws SimulationError, with the numbers that are
// suspected.
diagnose::answer::Diagnosis diagnosisOf(const DiagnosisInputs& inputs, const diagnose::Options& options);

// diagnosis.json, the drives of each stage, the car with the effects, and the page.
void writeDiagnosis(const DiagnosisInputs& inputs, const diagnose::answer::Diagnosis& diagnosis, const Path& folder);

// The same for an identification: paths that cannot be fitted are faults of `source`. `calibrated.yaml` is the car
// found.
DiagnosisInputs readIdentificationInputs(const IdentifyRequest& request, const std::string& source);
calibrate::Identification identificationOf(const DiagnosisInputs& inputs, const diagnose::Options& options);
void writeIdentification(const DiagnosisInputs& inputs, const calibrate::Identification& found, const Path& folder);

void warnOf(const std::vector<std::string>& warnings);

// Prints what the data checks found and what the drives could show of each effect; kNo when there are warnings.
int checkData(const DiagnosisInputs& inputs, tread::diagnose::Options options, bool json);

// Writes a first diagnosis.yaml for the logs of a folder, and says what is left to fill in.
int initDiagnosis(const Path& folder, const std::string& vehicle);

}  // namespace tread::program
