// A case of a blind check, diagnosed as a user would.
#pragma once

#include <filesystem>

#include "diagnose/answer/diagnosis.h"
#include "recording/diagnosis_file.h"

namespace tread {

// Without references, those that the file names are left out, as if there were none.
enum class References { used, left_out };

recording::DiagnosisFile askedOf(const std::filesystem::path& diagnosis_yaml, References references);

// Throws as loading and diagnosing do.
diagnose::answer::Diagnosis diagnosedCase(const std::filesystem::path& diagnosis_yaml, References references,
                                          int threads);

}  // namespace tread
