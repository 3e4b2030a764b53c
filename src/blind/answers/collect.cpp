#include "blind/answers/collect.h"

#include <algorithm>

#include "blind/detectability/detectable_effects.h"
#include "blind/make/make_cases.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "log/csv.h"
#include "recording/diagnosis_folders.h"
#include "store/result_folder.h"
#include "store/sha256.h"
#include "store/whole_file.h"
#include "tread/load.h"

namespace tread::blind::answers {
namespace {

using detectability::detectableEffects;
using diagnose::answer::Diagnosis;
using diagnose::answer::Overlay;
using diagnose::catalogue::Effect;
using drives::caseDrives;
using drives::Conditions;
using drives::Drive;
using drives::kIdeal;
using drives::measure;
using faults::DrawnCase;
using key::CaseKey;
using key::CaseKind;
using key::programHash;
using key::SealedKey;
using make::CaseRecording;
using make::drawnCase;
using make::recordingsOf;
using world::Truth;

namespace fs = std::filesystem;

std::vector<std::string> caseNames(const fs::path& cases) {
    std::vector<std::string> names = recording::diagnosisFolders(cases);
    if (names.empty()) {
        throw LoadError({{cases.string(), 0, 0, "",
                          "found no case in this folder, expected folders with a diagnosis.yaml each, as `tread blind "
                          "make` writes them"}});
    }
    return names;
}

fs::path answerFile(const fs::path& answers, const std::string& name) {
    return answers / name / "answer.json";
}

fs::path driveFile(const fs::path& answers, const std::string& name, const std::string& recording, const char* kind) {
    return answers / name / (recording + "." + kind + ".csv");
}

// Beside the answer: the hash of the case, so that no other case of this name is taken for it.
fs::path caseFile(const fs::path& answers, const std::string& name) {
    return answers / name / "case.sha256";
}

std::string caseHash(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string hashes;
    for (const fs::path& file : files) hashes += sha256(readBytes(file)) + "  " + file.filename().string() + "\n";
    return sha256(hashes) + "\n";
}

// Whether there is an answer, and not to another case; one that does not say for which case it is counts.
bool isAnswerTo(const std::string& hash, const fs::path& answers, const std::string& name) {
    const fs::path of = caseFile(answers, name);
    return fs::exists(answerFile(answers, name)) && (!fs::exists(of) || readBytes(of) == hash);
}

// The answer is written last and in one step: an existing answer is complete.
void keep(const fs::path& answers, const CaseAnswer& answer, const std::string& hash,
          const std::vector<Overlay>& overlays) {
    makeFolder(answers / answer.name);
    removeResult(answerFile(answers, answer.name));  // to another case
    writeFile(caseFile(answers, answer.name), hash);
    for (const Overlay& overlay : overlays) {
        if (!overlay.hold_out) continue;
        writeLog(driveFile(answers, answer.name, overlay.recording, "nominal"), overlay.nominal);
        writeLog(driveFile(answers, answer.name, overlay.recording, "extended"), overlay.extended);
    }
    writeFile(answerFile(answers, answer.name), answerText(answer));
}

void answerCase(const fs::path& cases, const fs::path& answers, const std::string& name, const Diagnoser& diagnose,
                int threads) {
    CaseAnswer answer;
    std::vector<Overlay> overlays;
    try {
        Diagnosis diagnosis = diagnose(cases / name / "diagnosis.yaml", threads);
        answer = answerOf(name, diagnosis);
        overlays = std::move(diagnosis.overlays);
    } catch (const FileError&) {
        throw;  // of this call, not of the diagnosis
    } catch (const std::exception& error) {
        answer.name = name;
        answer.program = programHash();
        answer.failure = error.what();
    }
    keep(answers, answer, caseHash(cases / name), overlays);
}

// Held-out drives of a case without disturbance and noise, from the same initial speed.
std::map<std::string, Log> cleanDrives(const Truth& truth, const std::vector<Drive>& drives, std::uint64_t seed,
                                       int index) {
    Conditions conditions = kIdeal;
    conditions.speed_scatter = Conditions{}.speed_scatter;
    std::map<std::string, Log> clean;
    for (const CaseRecording& one : recordingsOf(drives, seed, index)) {
        if (one.drive->hold_out) clean[one.name] = measure(truth, *one.drive, one.seed, conditions);
    }
    return clean;
}

std::vector<Overlay> keptOverlays(const fs::path& answers, const std::string& name,
                                  const std::map<std::string, Log>& clean) {
    std::vector<Overlay> overlays;
    for (const auto& [recording, log] : clean) {
        const fs::path nominal = driveFile(answers, name, recording, "nominal");
        if (!fs::exists(nominal)) continue;
        Overlay overlay;
        overlay.recording = recording;
        overlay.hold_out = true;
        overlay.nominal = readLog(nominal);
        overlay.extended = readLog(driveFile(answers, name, recording, "extended"));
        overlays.push_back(std::move(overlay));
    }
    return overlays;
}

}  // namespace

bool answerCases(const fs::path& cases, const fs::path& answers, const Diagnoser& diagnose, int threads,
                 const WorkOptions& options) {
    const std::vector<std::string> names = caseNames(cases);
    makeFolder(answers);
    std::vector<std::string> hashes;
    for (const std::string& name : names) hashes.push_back(caseHash(cases / name));
    const auto isAnswered = [&](std::uint64_t i) { return isAnswerTo(hashes[i], answers, names[i]); };
    const Pieces pieces{.count = names.size(),
                        .isDone = [&](std::uint64_t i, std::string&) { return isAnswered(i); },
                        .compute =
                            [&](std::uint64_t i, std::uint64_t) {
                                answerCase(cases, answers, names[i], diagnose, threads);
                                return true;
                            }};
    workTogether(pieces, answers, options);
    for (std::uint64_t i = 0; i < names.size(); ++i) {
        if (!isAnswered(i)) return false;
    }
    return true;
}

std::vector<CaseAnswer> keptAnswers(const fs::path& cases, const fs::path& answers) {
    std::vector<CaseAnswer> found;
    for (const std::string& name : caseNames(cases)) {
        const fs::path file = answerFile(answers, name);
        found.push_back(parseAnswer(readBytes(file), file.string()));
        if (isAnswerTo(caseHash(cases / name), answers, name)) continue;
        throw LoadError({{file.string(), 0, 0, "",
                          "found the answer to another case of this name, which another call has written; name another "
                          "folder for each set of cases with -o"}});
    }
    return found;
}

void addObtainedClosure(std::vector<CaseAnswer>& found, const SealedKey& key, const fs::path& cases,
                        const fs::path& answers, const std::vector<Effect>& effects) {
    if (key.cases.empty() || !key.generator.empty()) return;
    const VehicleParams nominal = loadVehicle(cases / key.cases.front().name / "vehicle.yaml");
    const std::vector<Drive> drives = caseDrives(key.drives);
    const std::vector<Effect> shown = detectableEffects(nominal, effects, drives);
    for (std::size_t i = 0; i < key.cases.size(); ++i) {
        const CaseKey& made = key.cases[i];
        const auto answer =
            std::find_if(found.begin(), found.end(), [&](const CaseAnswer& a) { return a.name == made.name; });
        if (answer == found.end() || made.kind != CaseKind::one) continue;
        const int index = static_cast<int>(i);
        DrawnCase drawn = drawnCase(key.seed, index, made.kind, nominal, shown, made.draw,
                                    {.world = key.world, .frozen = key.frozen});
        drawn.key.shows = made.shows;  // computed, not drawn
        if (drawn.key != made) continue;
        const std::map<std::string, Log> clean = cleanDrives(drawn.truth, drives, key.seed, index);
        answer->closure_obtained = obtainedClosure(keptOverlays(answers, made.name, clean), clean);
    }
}

}  // namespace tread::blind::answers
