#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "blind/answers/collect.h"
#include "blind/answers/diagnose_case.h"
#include "blind/make/make_cases.h"
#include "blind/score/score.h"
#include "commands.h"
#include "diagnose/catalogue/effect.h"
#include "drive.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "output.h"
#include "output_folder.h"
#include "recording/diagnosis_folders.h"
#include "refuse.h"
#include "report/blind_report.h"
#include "shared_work.h"
#include "store/result_folder.h"
#include "store/sha256.h"
#include "terminal.h"
#include "tread/load.h"

namespace tread::program {
namespace {

using blind::answers::addObtainedClosure;
using blind::answers::answerCases;
using blind::answers::CaseAnswer;
using blind::answers::diagnosedCase;
using blind::answers::keptAnswers;
using blind::answers::References;
using blind::drives::driveSetNamed;
using blind::key::caseKindNamed;
using blind::key::keyText;
using blind::key::parseKey;
using blind::key::SealedKey;
using blind::make::makeCases;
using blind::make::Order;
using blind::score::BlindScore;
using blind::score::score;
using blind::score::scoreJson;
using blind::score::scoreText;
using blind::world::worldNamed;
using diagnose::catalogue::effectCatalogue;

std::string withoutSlash(std::string folder) {
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
    return folder;
}

std::string madeOf(const SealedKey& key) {
    const std::string by = key.generator.empty() ? "" : ", driven by " + key.generator;
    return fmt::format("{} cases of seed {}, world {}, {}{}", key.cases.size(), key.seed,
                       enumNames(key.world)[static_cast<std::size_t>(key.world)], key.vehicle, by);
}

void expectNoKey(const Path& file) {
    if (!std::filesystem::exists(file)) return;
    refuse(file.string(),
           "found an existing key file, which may be sealed; expected none: name another file with --key");
}

// What a call that was killed has made.
void removeCases(const Path& folder) {
    std::error_code ignored;
    for (const std::string& name : recording::diagnosisFolders(folder))
        std::filesystem::remove_all(folder / name, ignored);
}

}  // namespace

int blindMake(const BlindMakeOptions& options) {
    expectKind(options.vehicle, {"vehicle"});
    const Path folder = options.output;
    const Path key_file = options.key.empty() ? Path(withoutSlash(options.output) + ".key.json") : Path(options.key);
    std::error_code error;
    removeLeftovers(folder);
    const bool was_killed = isIncomplete(folder);
    if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder, error) && !was_killed)
        refuse(options.output, "found a folder that is not empty, expected a new or empty one for the cases");
    if (!was_killed) expectNoKey(key_file);

    Order order;
    order.cases = options.cases;
    order.seed = options.seed;
    for (const std::string& kind : options.kinds) order.kinds.push_back(caseKindNamed(kind));
    order.drives = driveSetNamed(options.drives);
    order.drawing = {.world = worldNamed(options.world), .frozen = options.frozen};
    order.vehicle = options.vehicle;
    order.tread_version = TREAD_VERSION;
    const OutputFolder output(folder);
    if (was_killed) removeCases(folder);
    Progress progress(options.cases, "cases");
    const SealedKey key =
        makeCases(order, loadVehicle(options.vehicle), effectCatalogue(), folder, [&](int done) { progress.at(done); });
    const std::string sealed = keyText(key), hash = sha256(sealed);
    // The call that was killed may have written the same key.
    if (std::filesystem::exists(key_file) && readBytes(key_file) != sealed) expectNoKey(key_file);
    writeFile(key_file, sealed);
    output.complete();
    if (options.json) {
        printJson(
            {{"cases", options.cases}, {"folder", folder.string()}, {"key", key_file.string()}, {"key_sha256", hash}});
    } else {
        say(fmt::format("{} cases of seed {} in {}; their faults are sealed in {}\nSHA-256 of the key: {}\n",
                        options.cases, options.seed, folder.string(), key_file.string(), hash));
    }
    return kYes;
}

int blindScore(const BlindScoreOptions& options) {
    expectKind(options.cases, {"folder"});
    if (isIncomplete(options.cases))
        refuse(options.cases,
               "found a folder that is marked as incomplete: the call that makes its cases was killed or "
               "has not ended; make them again");
    // The hash is that of the key file as it is; its contents are parsed only when all cases are answered.
    const std::string sealed = readBytes(options.key);
    const References references = options.no_references ? References::left_out : References::used;
    const Path output = options.no_references ? Path(options.output) / "without_references" : Path(options.output);
    const Path answers_folder = output / "answers";
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const int jobs = options.jobs > 0 ? options.jobs : cores;
    const auto diagnose = [&](const Path& file, int threads) { return diagnosedCase(file, references, threads); };
    listenToSignals();
    {
        Progress progress(0, "cases");
        const WorkOptions work = workOptions(jobs, options.shard, progress);
        if (!answerCases(options.cases, answers_folder, diagnose, std::max(1, cores / jobs), work)) {
            if (stopAsked()) {
                note("tread blind score: interrupted; the same call goes on");
                return stoppedStatus();
            }
            say(fmt::format("part {} is answered; the call that finds all cases answered opens the key\n",
                            options.shard));
            return kYes;
        }
    }
    std::vector<CaseAnswer> answers = keptAnswers(options.cases, answers_folder);

    const SealedKey key = parseKey(sealed, options.key);
    addObtainedClosure(answers, key, options.cases, answers_folder, effectCatalogue());
    const BlindScore scored = score(key, answers);
    const std::string json = scoreJson(scored), made_of = madeOf(key), hash = sha256(sealed);
    const std::string page =
        blindReport({.made_of = made_of, .key_sha256 = hash, .version = TREAD_VERSION, .score = scored});
    waitForFolders();  // calls that share the work end at the same moment, and each writes the same for a moment
    const OutputFolder held(output);
    writeFile(output / "score.json", json);
    writeFile(output / "report.html", page);
    held.complete();
    if (options.json) {
        printJson(nlohmann::json::parse(json));
    } else {
        say(fmt::format("{}  {}\n  SHA-256 of the key: {}\n", scoreText(scored), made_of, hash));
    }
    note("report: " + (output / "report.html").string());
    return scored.failed > 0 ? kRunFailed : kYes;
}

}  // namespace tread::program
