#include "blind/diagnose_case.h"

namespace tread {

DiagnosisFile askedOf(const std::filesystem::path& diagnosis_yaml, References references) {
    DiagnosisFile asked = loadDiagnosis(diagnosis_yaml);
    if (references == References::left_out) {
        for (Recording& recording : asked.recordings) recording.reference.clear();
    }
    return asked;
}

Diagnosis diagnosedCase(const std::filesystem::path& diagnosis_yaml, References references, int threads) {
    const DiagnosisFile asked = askedOf(diagnosis_yaml, references);
    DiagnoseOptions options;
    options.threads = threads;
    return diagnose(nominalSubject(asked), asked, readRecordings(asked), effectsToConsider(asked), options);
}

}  // namespace tread
