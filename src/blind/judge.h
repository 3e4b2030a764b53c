// Having the cases of a blind check diagnosed without the key, and then looking at what was obtained.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "blind/answer.h"
#include "blind/key.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"

namespace tread {

// Diagnoses what a diagnosis.yaml asks, on so many threads.
using Diagnoser = std::function<diagnose::answer::Diagnosis(const std::filesystem::path& file, int threads)>;

struct JudgeOptions {
    int jobs = 1;     // cases at a time
    int threads = 1;  // of each
    std::function<void(int done, int of)> progress = [](int, int) {};
};

// The answers to the cases in a folder, in the order of their names. Each is kept in a folder of its own in `answers`,
// with the simulated drives that were held out, and is taken from there when it is there: an interrupted check goes on
// where it stopped. What cannot be diagnosed has a `failure`. Throws LoadError when there is no case.
std::vector<CaseAnswer> judge(const std::filesystem::path& cases, const std::filesystem::path& answers,
                              const Diagnoser& diagnose, const JudgeOptions& options = {});

// Fills in `closure_obtained`, with the key: the cars are drawn again and driven without noise. Left out where the
// catalogue or the nominal car is no longer that of the key, and where another simulator drove them.
void lookUp(std::vector<CaseAnswer>& found, const BlindKey& key, const std::filesystem::path& cases,
            const std::filesystem::path& answers, const std::vector<diagnose::catalogue::Effect>& effects);

}  // namespace tread
