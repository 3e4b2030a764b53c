// Having blind cases diagnosed: every case once, also after an interruption, and never with the key.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "blind/judge.h"
#include "blind/make.h"
#include "log/csv.h"
#include "report/blind_report.h"
#include "shared/scratch.h"
#include "shared/vehicles.h"
#include "tread/problem.h"

namespace tread {
namespace {

const std::vector<Effect> kEffects{
    {"heavier", "", "", {{.paths = {"mass"}, .typical = 0.1, .relative = true, .direction = Direction::up}}},
};

BlindKey made(const Scratch& scratch, int cases) {
    BlindOrder order;
    order.cases = cases;
    order.seed = 5;
    order.kinds = {CaseKind::one};
    order.drives = DriveSet::coast_and_accelerate;
    return makeCases(order, reference::compact(), kEffects, scratch.path("cases"));
}

Diagnosis blamed(const std::string& cause) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::explained;
    diagnosis.causes = {cause};
    RankedEffect effect;
    effect.name = cause;
    effect.probability = 0.97;
    diagnosis.effects = {effect};
    diagnosis.testable[cause] = 40;
    return diagnosis;
}

TEST(BlindJudge, EveryCaseIsDiagnosedOnceAlsoWhenItGoesOn) {
    const Scratch scratch;
    made(scratch, 3);
    std::atomic<int> asked = 0;
    const auto diagnose = [&](const std::filesystem::path& file, int) {
        EXPECT_EQ(file.filename(), "diagnosis.yaml");
        ++asked;
        return blamed("heavier");
    };
    const auto first = judge(scratch.path("cases"), scratch.path("answers"), diagnose, {.jobs = 2});
    EXPECT_EQ(asked, 3);
    std::filesystem::remove_all(scratch.path("answers/case_002"));
    const auto second = judge(scratch.path("cases"), scratch.path("answers"), diagnose);
    EXPECT_EQ(asked, 4);
    ASSERT_EQ(first.size(), 3u);
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(answerText(first[i]), answerText(second[i]));
    EXPECT_EQ(first[1].name, "case_002");
}

TEST(BlindJudge, CaseThatCannotBeDiagnosedSaysWhy) {
    const Scratch scratch;
    made(scratch, 1);
    const auto answers = judge(scratch.path("cases"), scratch.path("answers"),
                               [](const auto&, int) -> Diagnosis { throw std::runtime_error("no steering angle"); });
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0].failure, "no steering angle");
}

TEST(BlindJudge, FolderWithoutCasesIsAFault) {
    const Scratch scratch;
    EXPECT_THROW(judge(scratch.folder(), scratch.path("answers"), {}), LoadError);
}

TEST(BlindJudge, ClosureObtainedIsLookedUpInTheCarThatWasDriven) {
    // A diagnosis whose extended model is the measured drive itself closes all but the noise.
    const Scratch scratch;
    const BlindKey key = made(scratch, 1);
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
    auto answers = judge(scratch.path("cases"), scratch.path("answers"), diagnose);
    EXPECT_TRUE(std::isnan(answers[0].closure_obtained));
    lookUp(answers, key, scratch.path("cases"), scratch.path("answers"), kEffects);
    EXPECT_GT(answers[0].closure_obtained, 0);
    EXPECT_LT(answers[0].closure_obtained, 1);
}

TEST(BlindJudge, CarsOfAnotherSimulatorAreNotDrawnAgain) {
    const Scratch scratch;
    BlindKey key = made(scratch, 1);
    key.generator = "another simulator";
    CaseAnswer answer;
    answer.name = "case_001";
    answer.closure_obtained = 0.5;
    std::vector<CaseAnswer> answers{answer};
    lookUp(answers, key, scratch.path("cases"), scratch.path("answers"), kEffects);
    EXPECT_EQ(answers[0].closure_obtained, 0.5);
}

TEST(BlindReport, SaysTheFiguresAndTheHashOfTheKey) {
    CaseKey key;
    key.name = "case_001";
    key.kind = CaseKind::one;
    key.effects = {"heavier"};
    BlindReport report;
    report.key_sha256 = "0123abcd";
    report.made_of = "1 cases of seed 7";
    report.score = score({key}, {answerOf("case_001", blamed("heavier"))});
    const std::string page = blindReport(report);
    for (const char* word : {"0123abcd", "1 cases of seed 7", "named first", "calibration", "heavier", "Wilson"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST(BlindReport, SaysWhatNoCaseCanAnswerInsteadOfZeros) {
    CaseKey key;
    key.name = "case_001";
    BlindReport report;
    report.score = score({key}, {});
    const std::string page = blindReport(report);
    for (const char* word : {"No case says anything of: one effect, testable and told apart: named first",
                             "no such case", "none blamed", "1 of 1 cases have no answer"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
    EXPECT_EQ(page.find("0.0 %"), std::string::npos);
}

}  // namespace
}  // namespace tread
