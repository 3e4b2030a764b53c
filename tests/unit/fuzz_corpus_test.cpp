// Replays the corpora of the fuzzers: what once was, or could be, a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/answer_entry.h"
#include "fuzz/binary_log_entry.h"
#include "fuzz/campaign_entry.h"
#include "fuzz/car_state_entry.h"
#include "fuzz/csv_entry.h"
#include "fuzz/expression_entry.h"
#include "fuzz/height_field_entry.h"
#include "fuzz/scenario_entry.h"
#include "fuzz/tir_entry.h"
#include "fuzz/yaml_entry.h"
#include "places/places.h"
#include "shared/scratch.h"

namespace tread::fuzz_corpus_test {
namespace {

struct Replay {
    std::size_t files = 0;
    std::vector<std::string> taken;  // sorted
};

Replay replay(const std::string& corpus, bool (*reads)(std::string_view text)) {
    Replay replay;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile("tests/fuzz/corpus/" + corpus))) {
        SCOPED_TRACE(entry.path().string());
        if (reads(contentOf(entry.path()))) replay.taken.push_back(entry.path().filename());
        ++replay.files;
    }
    std::sort(replay.taken.begin(), replay.taken.end());
    return replay;
}

TEST(FuzzCorpus, EveryYamlFileIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("yaml", fuzz::readHostileYaml);
    EXPECT_GE(files, 20u);
    EXPECT_EQ(taken, (std::vector<std::string>{"bom.yaml", "everything.yaml", "tyre.yaml"}));
}

TEST(FuzzCorpus, EveryLogIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("csv", fuzz::readHostileCsv);
    EXPECT_GE(files, 8u);
    EXPECT_EQ(taken, (std::vector<std::string>{"plain.csv", "windows.csv"}));
}

TEST(FuzzCorpus, EveryHeightFieldIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("height_field", fuzz::readHostileHeights);
    EXPECT_GE(files, 9u);
    EXPECT_EQ(taken, (std::vector<std::string>{"plain.csv"}));
}

TEST(FuzzCorpus, EveryTyrePropertyFileIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("tir", fuzz::readHostileTir);
    EXPECT_GE(files, 14u);
    EXPECT_EQ(taken, (std::vector<std::string>{"latin1.tir", "plain.tir", "tables.tir", "units.tir", "windows.tir"}));
}

TEST(FuzzCorpus, EveryBinaryLogIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("binary_log", fuzz::readHostileBinaryLog);
    EXPECT_GE(files, 9u);
    EXPECT_EQ(taken, (std::vector<std::string>{"plain.tlog"}));
}

TEST(FuzzCorpus, EveryExpressionIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("expression", fuzz::readHostileExpression);
    EXPECT_GE(files, 12u);
    EXPECT_EQ(taken, (std::vector<std::string>{"sound.txt", "unit.txt"}));
}

TEST(FuzzCorpus, EveryCampaignAndPieceOfOneIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("campaign", fuzz::readHostileCampaign);
    EXPECT_GE(files, 5u);
    EXPECT_EQ(taken, (std::vector<std::string>{"everything.yaml", "shipped.yaml"}));
    const auto [pieces, read] = replay("piece", fuzz::readHostilePiece);
    EXPECT_GE(pieces, 5u);
    EXPECT_EQ(read, (std::vector<std::string>{"plain.txt", "quotes.txt"}));
}

TEST(FuzzCorpus, EveryScenarioIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("scenario", fuzz::readHostileScenario);
    EXPECT_GE(files, 9u);
    EXPECT_EQ(taken, (std::vector<std::string>{"double_lane_change.yaml", "ride_class_c.yaml", "shipped.yaml",
                                               "sine_with_dwell_series.yaml", "steering_pulse.yaml",
                                               "straight_braking_100_abs.yaml"}));
}

TEST(FuzzCorpus, EveryAnswerToABlindCaseIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("answer", fuzz::readHostileAnswer);
    EXPECT_GE(files, 5u);
    EXPECT_EQ(taken, (std::vector<std::string>{"plain.json"}));
}

TEST(FuzzCorpus, EveryStateOfACarIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("car_state", fuzz::takeHostileState);
    EXPECT_GE(files, 4u);
    EXPECT_EQ(taken, (std::vector<std::string>{"clutch_beyond_its_end.bin", "empty.bin"}));
}

// ---- Whole files, damaged where their structure is ------------------------------------------------------------------

// Calls `take` with the text after each of some hundred blows: lines and bytes that are lost, doubled, exchanged.
void damaged(const std::string& whole, auto&& take) {
    std::mt19937 random(1);
    const auto anywhere = [&](const std::string& text) { return random() % (text.size() + 1); };
    for (int round = 0; round < 300; ++round) {
        std::string text = whole;
        for (int blow = 0; blow <= round % 3; ++blow) {
            const std::size_t at = anywhere(text), end = std::min(text.size(), at + 1 + random() % 20);
            const std::string piece = text.substr(at, end - at);
            const std::size_t kind = random() % 5;
            if (kind == 0) text.erase(at, end - at);
            else if (kind == 1) text.insert(anywhere(text), piece);
            else if (kind == 2) text.resize(at);
            else if (kind == 3 && at < text.size()) text[at] = static_cast<char>(random());
            else text.insert(at, round % 2 ? "18446744073709551616" : "-1e-308");
        }
        take(text);
    }
}

TEST(DamagedFiles, BinaryLogsAreTakenOrRefusedInWords) {
    damaged(contentOf(sourceFile("tests/fuzz/corpus/binary_log/plain.tlog")), fuzz::readHostileBinaryLog);
}

TEST(DamagedFiles, ExpressionsAreTakenOrRefusedInWords) {
    damaged(contentOf(sourceFile("tests/fuzz/corpus/expression/sound.txt")), fuzz::readHostileExpression);
}

TEST(DamagedFiles, PiecesOfCampaignsAreTakenOrTold) {
    const std::string rows = "0,car,stop,0,ok,,\n1,car,stop,0,ok,,\n", timings = "0,0.1\n1,0.1\n";
    const std::string whole = campaign::pieceText(fuzz::planOfTwoRuns(), 0, {rows, timings});
    ASSERT_TRUE(fuzz::readHostilePiece(whole));
    damaged(whole, fuzz::readHostilePiece);
    damaged(rows + timings, fuzz::readHostilePiece);  // with a checksum that fits what is damaged
}

TEST(DamagedFiles, AnswersAreTakenOrRefusedInWords) {
    blind::answers::CaseAnswer answer;
    answer.name = "case";
    answer.causes = {"grip"};
    answer.expected_evidence = {{"grip", 3}};
    damaged(blind::answers::answerText(answer), fuzz::readHostileAnswer);
}

}  // namespace
}  // namespace tread::fuzz_corpus_test
