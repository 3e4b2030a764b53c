#include "blind/answers/diagnose_case.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effects_to_consider.h"
#include "diagnose/diagnose.h"
#include "diagnose/options.h"
#include "recording/diagnosis_file.h"

namespace tread::blind::answers {

using diagnose::answer::Diagnosis;
using diagnose::catalogue::effectsToConsider;
using recording::DiagnosisFile;
using recording::loadDiagnosis;
using recording::nominalSubject;
using recording::readRecordings;
using recording::Recording;

DiagnosisFile askedOf(const std::filesystem::path& diagnosis_yaml, References references) {
    DiagnosisFile asked = loadDiagnosis(diagnosis_yaml);
    if (references == References::left_out) {
        for (Recording& recording : asked.recordings) recording.reference.clear();
    }
    return asked;
}

Diagnosis diagnosedCase(const std::filesystem::path& diagnosis_yaml, References references, int threads) {
    const DiagnosisFile asked = askedOf(diagnosis_yaml, references);
    diagnose::Options options;
    options.threads = threads;
    return diagnose::diagnosisOf(nominalSubject(asked), asked, readRecordings(asked), effectsToConsider(asked),
                                 options);
}

}  // namespace tread::blind::answers
