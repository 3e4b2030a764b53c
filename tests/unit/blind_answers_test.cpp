// Obtaining answers: every case is diagnosed once, also after an interruption, and never with the key.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "blind/answers/collect.h"
#include "blind/answers/diagnose_case.h"
#include "blind/make/make_cases.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "log/csv.h"
#include "recording/diagnosis_file.h"
#include "report/blind_report.h"
#include "shared/scratch.h"
#include "shared/vehicles.h"
#include "tread/problem.h"

namespace tread::blind_answers_test {
namespace {

using blind::answers::addObtainedClosure;
using blind::answers::answerCases;
using blind::answers::answerOf;
using blind::answers::answerText;
using blind::answers::askedOf;
using blind::answers::CaseAnswer;
using blind::answers::References;
using blind::drives::caseDrives;
using blind::drives::Drive;
using blind::drives::DriveSet;
using blind::drives::measure;
using blind::key::CaseKey;
using blind::key::CaseKind;
using blind::key::programHash;
using blind::key::SealedKey;
using blind::make::CaseRecording;
using blind::make::makeCases;
using blind::make::Order;
using blind::make::recordingsOf;
using blind::make::writeCase;
using blind::score::score;
using blind::world::Truth;
using diagnose::answer::Diagnosis;
using diagnose::answer::Overlay;
using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using recording::DiagnosisFile;
using recording::readRecordings;

const std::vector<Effect> kEffects{
    {"heavier", "", "", {{.paths = {"mass"}, .typical = 0.1, .relative = true, .direction = Direction::up}}},
};

SealedKey made(const Scratch& scratch, int cases) {
    Order order;
    order.cases = cases;
    order.seed = 5;
    order.kinds = {CaseKind::one};
    order.drives = DriveSet::coast_and_accelerate;
    return makeCases(order, reference::compact(), kEffects, scratch.path("cases"));
}

std::vector<CaseAnswer> answersOf(const Scratch& scratch, const blind::answers::Diagnoser& diagnose,
                                  const WorkOptions& options = {.threads = 1}) {
    EXPECT_TRUE(answerCases(scratch.path("cases"), scratch.path("answers"), diagnose, 1, options));
    return blind::answers::keptAnswers(scratch.path("cases"), scratch.path("answers"));
}

Diagnosis blamed(const std::string& cause) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::explained;
    diagnosis.causes = {cause};
    RankedEffect effect;
    effect.name = cause;
    effect.probability = 0.97;
    diagnosis.effects = {effect};
    diagnosis.expected_evidence[cause] = 40;
    return diagnosis;
}

TEST(BlindAnswers, EveryCaseIsDiagnosedOnceAlsoWhenItGoesOn) {
    const Scratch scratch;
    made(scratch, 3);
    std::atomic<int> asked = 0;
    const auto diagnose = [&](const std::filesystem::path& file, int) {
        EXPECT_EQ(file.filename(), "diagnosis.yaml");
        ++asked;
        return blamed("heavier");
    };
    const auto first = answersOf(scratch, diagnose, {.threads = 2});
    EXPECT_EQ(asked, 3);
    std::filesystem::remove_all(scratch.path("answers/case_002"));
    const auto second = answersOf(scratch, diagnose);
    EXPECT_EQ(asked, 4);
    ASSERT_EQ(first.size(), 3u);
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(answerText(first[i]), answerText(second[i]));
    EXPECT_EQ(first[1].name, "case_002");
}

TEST(BlindAnswers, AnswerToAnotherCaseOfTheSameNameIsMadeAgain) {
    const Scratch scratch;
    made(scratch, 1);
    EXPECT_EQ(answersOf(scratch, [](const auto&, int) { return blamed("heavier"); }).front().causes.front(), "heavier");
    std::ofstream(scratch.path("cases/case_001/diagnosis.yaml"), std::ios::app) << "# another case\n";
    EXPECT_THROW(blind::answers::keptAnswers(scratch.path("cases"), scratch.path("answers")), LoadError);
    EXPECT_EQ(answersOf(scratch, [](const auto&, int) { return blamed("lighter"); }).front().causes.front(), "lighter");
}

TEST(BlindAnswers, ShardsAnswerTheirCasesAndTheLastOneHasAll) {
    const Scratch scratch;
    made(scratch, 3);
    std::atomic<int> asked = 0;
    const auto diagnose = [&](const std::filesystem::path&, int) {
        ++asked;
        return blamed("heavier");
    };
    const auto part = [&](std::uint64_t which) {
        return answerCases(scratch.path("cases"), scratch.path("answers"), diagnose, 1, {.shard = {which, 2}});
    };
    EXPECT_FALSE(part(0));
    EXPECT_EQ(asked, 2);
    EXPECT_TRUE(part(1));
    EXPECT_EQ(asked, 3);
}

TEST(BlindAnswers, CaseThatCannotBeDiagnosedSaysWhy) {
    const Scratch scratch;
    made(scratch, 1);
    const auto answers =
        answersOf(scratch, [](const auto&, int) -> Diagnosis { throw std::runtime_error("no steering angle"); });
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0].failure, "no steering angle");
}

TEST(BlindAnswers, FolderWithoutCasesIsAFault) {
    const Scratch scratch;
    EXPECT_THROW(answerCases(scratch.folder(), scratch.path("answers"), {}, 1, {}), LoadError);
}

TEST(BlindAnswers, ClosureObtainedIsLookedUpInTheCarThatWasDriven) {
    // A diagnosis whose extended model is the measured drive itself closes all but the noise.
    const Scratch scratch;
    const SealedKey key = made(scratch, 1);
    const auto diagnose = [&](const std::filesystem::path& file, int) {
        Diagnosis diagnosis = blamed("heavier");
        for (const char* name : {"sine_with_dwell_80", "power_on_in_turn_75"}) {
            Overlay overlay;
            overlay.recording = name;
            overlay.hold_out = true;
            overlay.extended = readLog(file.parent_path() / (std::string(name) + ".csv"));
            overlay.nominal = overlay.extended;
            for (Channel& channel : overlay.nominal.channels) {
                if (channel.name != "chassis.yaw_rate") continue;
                for (double& value : channel.values) value += 1;
            }
            diagnosis.overlays.push_back(overlay);
        }
        return diagnosis;
    };
    auto answers = answersOf(scratch, diagnose);
    EXPECT_EQ(answers[0].program, programHash());
    EXPECT_TRUE(std::isnan(answers[0].closure_obtained));
    addObtainedClosure(answers, key, scratch.path("cases"), scratch.path("answers"), kEffects);
    EXPECT_GT(answers[0].closure_obtained, 0);
    EXPECT_LT(answers[0].closure_obtained, 1);
}

TEST(BlindAnswers, CarsOfAnotherSimulatorAreNotDrawnAgain) {
    const Scratch scratch;
    SealedKey key = made(scratch, 1);
    key.generator = "another simulator";
    CaseAnswer answer;
    answer.name = "case_001";
    answer.closure_obtained = 0.5;
    std::vector<CaseAnswer> answers{answer};
    addObtainedClosure(answers, key, scratch.path("cases"), scratch.path("answers"), kEffects);
    EXPECT_EQ(answers[0].closure_obtained, 0.5);
}

TEST(BlindAnswers, ReferencesAreLeftOutWhereAsked) {
    const Scratch scratch;
    const std::vector<Drive> drives = caseDrives(DriveSet::step_steers);
    Truth truth;
    truth.car.vehicle = reference::compact();
    const auto driven = [&](const CaseRecording& one) { return measure(truth, *one.drive, one.seed); };
    writeCase(scratch.path("case"), reference::compact(), recordingsOf(drives, 1, 0), driven, driven);
    const DiagnosisFile used = askedOf(scratch.path("case/diagnosis.yaml"), References::used);
    const DiagnosisFile without = askedOf(scratch.path("case/diagnosis.yaml"), References::left_out);
    ASSERT_EQ(used.recordings.size(), without.recordings.size());
    for (std::size_t i = 0; i < used.recordings.size(); ++i) {
        EXPECT_FALSE(used.recordings[i].reference.empty());
        EXPECT_TRUE(without.recordings[i].reference.empty());
        EXPECT_EQ(used.recordings[i].log, without.recordings[i].log);
    }
    for (const Log& log : readRecordings(used).references) EXPECT_FALSE(log.channels.empty());
    for (const Log& log : readRecordings(without).references) EXPECT_TRUE(log.channels.empty());
}

SealedKey keyOf(const CaseKey& one) {
    SealedKey key;
    key.cases = {one};
    return key;
}

TEST(BlindReport, SaysTheFiguresAndTheHashOfTheKey) {
    CaseKey key;
    key.name = "case_001";
    key.kind = CaseKind::one;
    key.effects = {"heavier"};
    key.shows["heavier"] = {.nats = 30, .rival = "", .separation = 30};
    BlindReport report;
    report.key_sha256 = "0123abcd";
    report.made_of = "1 cases of seed 7";
    report.score = score(keyOf(key), {answerOf("case_001", blamed("heavier"))});
    const std::string page = blindReport(report);
    for (const char* word : {"0123abcd", "1 cases of seed 7", "ranked first", "alibration", "heavier", "Wilson",
                             "NOT frozen", "22 nats and more, distinguishable", "22-100"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST(BlindReport, SaysWhatNoCaseCanAnswerInsteadOfZeros) {
    CaseKey key;
    key.name = "case_001";
    BlindReport report;
    report.score = score(keyOf(key), {});
    const std::string page = blindReport(report);
    for (const char* word :
         {"No case for: ", "one effect: ranked first", "no such case", "1 of 1 cases have no answer"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace tread::blind_answers_test
