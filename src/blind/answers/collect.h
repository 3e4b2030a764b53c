// Obtains the answers of a blind check: has its cases diagnosed without the key and keeps the answers.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "blind/answers/answer.h"
#include "blind/key/key.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "store/shared_work.h"

namespace tread::blind::answers {

// Diagnoses a diagnosis.yaml.
using Diagnoser = std::function<diagnose::answer::Diagnosis(const std::filesystem::path& file, int threads)>;

// Has the cases in the folder `cases` diagnosed, each on `threads` threads; several processes may share the work
// (store/shared_work.h). Each answer is kept in its own folder below `answers`, together with the simulated held-out
// drives, and stays if it exists and the case has not changed: an interrupted check resumes. A case that cannot be
// diagnosed has a `failure`. Returns whether all cases are answered, not only those of the shard. Throws LoadError when
// there is no case.
bool answerCases(const std::filesystem::path& cases, const std::filesystem::path& answers, const Diagnoser& diagnose,
                 int threads, const WorkOptions& options);

// The answers to all cases in the folder, sorted by name. Throws FileError when one is missing, LoadError when one is
// to another case.
std::vector<CaseAnswer> keptAnswers(const std::filesystem::path& cases, const std::filesystem::path& answers);

// Computes `closure_obtained`: draws the cars of the key again and drives them without noise. Left NaN where catalogue
// or nominal car have changed since the key was made, and where another simulator drove the cars.
void addObtainedClosure(std::vector<CaseAnswer>& found, const key::SealedKey& key, const std::filesystem::path& cases,
                        const std::filesystem::path& answers, const std::vector<diagnose::catalogue::Effect>& effects);

}  // namespace tread::blind::answers
