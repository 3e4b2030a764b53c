// Two to eight calls write into one folder, or one file, at the same moment, round after round: the result is whole and
// of one call that says so by its status; the others are refused, or have shared the work.

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/answered_check.h"
#include "cli/kept_files.h"
#include "cli/logs.h"
#include "cli/tread_run.h"
#include "log/csv.h"
#include "store/result_folder.h"

namespace tread::at_once_test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;  // "@" stands for the folder

struct Kind {
    std::string name;
    std::vector<Words> calls;                   // that differ in what they write
    std::set<std::string> volatile_files = {};  // the ends of their names: they hold times, or are nobody's result
    std::set<int> statuses = {0};               // of a call that ends well
    bool takes_long = false;
};
std::ostream& operator<<(std::ostream& out, const Kind& kind) {
    return out << kind.name;
}

// Rounds of each kind of call; TREAD_SOAK_ROUNDS for all kinds together.
int rounds(std::size_t kinds) {
    const char* const asked = std::getenv("TREAD_SOAK_ROUNDS");
    return asked ? (std::atoi(asked) + static_cast<int>(kinds) - 1) / static_cast<int>(kinds) : 2;
}

class AtOnce : public TreadRun, public testing::WithParamInterface<Kind> {
protected:
    void SetUp() override {
        fs::create_directory(place());
        const std::string stop = kShortStop + "log: {rate: 50, channels: [chassis.*, driver.*]}\n";
        const std::string campaign =
            "title: Stops\nvehicles: [car.yaml]\nscenarios: [short.yaml]\nfactors:\n"
            "  - {path: scenario.road.friction, uniform: {from: 0.6, to: 1}}\n"
            "samples: 4\nruns_per_piece: 1\nseed: ";
        const std::string diagnosis =
            "vehicle: car.yaml\neffects: [steering_delay]\nrecordings:\n"
            "  - {speed: followed, log: ";
        putBack({{"car.yaml", carText()},
                 {"short.yaml", stop},
                 {"one.campaign.yaml", campaign + "1\n"},
                 {"two.campaign.yaml", campaign + "2\n"},
                 {"one.diagnosis.yaml", diagnosis + "one.csv}\n"},
                 {"two.diagnosis.yaml", diagnosis + "two.csv}\n"}},
                place());
        for (const double factor : {1.0, 1.1}) {
            Log drive = cli::with(cli::stepSteer(), "chassis.yaw_rate", [&](double, double v) { return factor * v; });
            for (Channel& channel : drive.channels) channel.values.resize(150);
            writeLog(place(factor == 1 ? "one.csv" : "two.csv"), drive);
        }
        for (const std::string cause : {"mass", "drag_area"})
            AnsweredCheck(cause).write(place("check"), place("score/answers"), place(cause + ".key.json"));
        for (const char* const mass : {"1400", "1500"})
            ASSERT_EQ(runProgram({"run", place("car.yaml"), place("short.yaml"), "-o", place(mass), "--set",
                                  std::string("mass=") + mass})
                          .status,
                      0);
    }

    std::string place(const std::string& name = "") const {
        return scratch.path("place") + (name.empty() ? "" : "/" + name);
    }
    Words placed(Words words) const {
        for (std::string& word : words)
            if (word.starts_with("@")) word = place(word.substr(1));
        return words;
    }

    // What counts as the result.
    Files results() const {
        Files files = filesIn(place());
        std::erase_if(files, [](const auto& file) {
            for (const std::string& end : GetParam().volatile_files)
                if (file.first.ends_with(end)) return true;
            return file.first.ends_with("claims");
        });
        return files;
    }
};

TEST_P(AtOnce, ResultIsWholeAndOfOneCall) {
    const Kind& kind = GetParam();
    if (kind.takes_long && !std::getenv("TREAD_SOAK_ROUNDS")) GTEST_SKIP() << "only with TREAD_SOAK_ROUNDS";
    const Files before = filesIn(place());
    std::vector<Files> alone;
    for (const Words& words : kind.calls) {
        putBack(before, place());
        const Result result = runProgram(placed(words));
        ASSERT_TRUE(kind.statuses.contains(result.status)) << result.status << " " << result.err;
        alone.push_back(results());
    }
    ASSERT_NE(alone.front(), alone.back()) << "the calls could not be told apart";
    int refused = 0;
    for (int round = 0; round < rounds(7); ++round) {
        putBack(before, place());
        const std::size_t count = 2 + static_cast<std::size_t>(round) % 7;
        SCOPED_TRACE("round " + std::to_string(round) + " with " + std::to_string(count) + " calls");
        std::vector<std::unique_ptr<Running>> calls;
        for (std::size_t i = 0; i < count; ++i) {
            const std::string number = std::to_string(i);
            calls.push_back(std::make_unique<Running>(placed(kind.calls[i % kind.calls.size()]),
                                                      scratch.path("out" + number), scratch.path("err" + number)));
        }
        std::vector<bool> well(kind.calls.size());
        std::string words;
        for (std::size_t i = 0; i < count; ++i) {
            const int status = calls[i]->waitForStatus();
            const std::string said = contentOf(scratch.path("err" + std::to_string(i)));
            words += std::to_string(status) + ": " + said;
            if (kind.statuses.contains(status)) well[i % well.size()] = true;
            else EXPECT_EQ(status, 2) << said;
            refused += status == 2;
        }
        const Files after = results();
        bool of_one = false;
        for (std::size_t i = 0; i < alone.size(); ++i) of_one |= well[i] && after == alone[i];
        EXPECT_TRUE(of_one) << words << namesOf(after) << "\n" << namesOf(alone.front());
        if (HasFailure()) return;
    }
    RecordProperty("refused", refused);
}

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}
const Words kRun{"run", "@car.yaml", "@short.yaml", "-o", "@out"};
const Words kMake{"blind",    "make",        "--cases",   "1",         "--kinds", "none",
                  "--drives", "step_steers", "--vehicle", "@car.yaml", "-o",      "@cases"};
const Words kScore{"blind", "score", "@check", "-o", "@score"};

INSTANTIATE_TEST_SUITE_P(
    Of, AtOnce,
    testing::Values(
        Kind{"Run", {kRun, with(kRun, {"--set", "mass=1400"})}},
        Kind{"Update", {{"compare", "@base", "@1400", "--update"}, {"compare", "@base", "@1500", "--update"}}},
        Kind{"Import", {{"import", "@one.csv", "-o", "@drive.csv"}, {"import", "@two.csv", "-o", "@drive.csv"}}},
        Kind{"Campaign",
             {{"campaign", "@one.campaign.yaml", "-o", "@out", "--threads", "1"},
              {"campaign", "@two.campaign.yaml", "-o", "@out", "--threads", "1"}},
             {"timings.csv", "report.html", ".piece"}},
        Kind{"Diagnosis",
             {{"diagnose", "@one.diagnosis.yaml", "-o", "@out", "--threads", "1"},
              {"diagnose", "@two.diagnosis.yaml", "-o", "@out", "--threads", "1"}},
             {"diagnosis.json", "report.html"},
             {0, 1},
             true},
        Kind{"Cases", {with(kMake, {"--seed", "3"}), with(kMake, {"--seed", "4"})}, {}, {0}, true},
        Kind{"Score", {with(kScore, {"@mass.key.json"}), with(kScore, {"@drag_area.key.json"})}}),
    [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace tread::at_once_test
