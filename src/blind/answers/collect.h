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

namespace tread::blind::answers {

// Diagnoses a diagnosis.yaml.
using Diagnoser = std::function<diagnose::answer::Diagnosis(const std::filesystem::path& file, int threads)>;

struct CollectOptions {
    int jobs = 1;     // cases in parallel
    int threads = 1;  // per case
    std::function<void(int done, int of)> progress = [](int, int) {};
};

// Answers to all cases in the folder `cases`, sorted by name. Each is kept in its own folder below `answers`, together
// with the simulated held-out drives, and is read from there if it exists: an interrupted check resumes. A case that
// cannot be diagnosed has a `failure`. Throws LoadError when there is no case.
std::vector<CaseAnswer> collectAnswers(const std::filesystem::path& cases, const std::filesystem::path& answers,
                                       const Diagnoser& diagnose, const CollectOptions& options = {});

// Computes `closure_obtained`: draws the cars of the key again and drives them without noise. Left NaN where catalogue
// or nominal car have changed since the key was made, and where another simulator drove the cars.
void addObtainedClosure(std::vector<CaseAnswer>& found, const key::SealedKey& key, const std::filesystem::path& cases,
                        const std::filesystem::path& answers, const std::vector<diagnose::catalogue::Effect>& effects);

}  // namespace tread::blind::answers
