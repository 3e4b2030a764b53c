// Diagnoses a case of a blind check as `tread diagnose` does.
#pragma once

#include <filesystem>

#include "diagnose/answer/diagnosis.h"
#include "recording/diagnosis_file.h"

namespace tread::blind::answers {

// left_out: the references that the file names are ignored.
enum class References { used, left_out };

recording::DiagnosisFile askedOf(const std::filesystem::path& diagnosis_yaml, References references);

// Throws what recording::loadDiagnosis and diagnose::diagnosisOf throw.
diagnose::answer::Diagnosis diagnosedCase(const std::filesystem::path& diagnosis_yaml, References references,
                                          int threads);

}  // namespace tread::blind::answers
