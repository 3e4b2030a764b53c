// `tread compare` on folders of runs.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/logs.h"
#include "cli/program.h"

namespace tread::compare_folders_test {
namespace {

using cli::stepSteer;
using Json = nlohmann::json;

// Two folders with the runs "a" and "series/01", equal at first.
struct CompareFolders : testing::Test {
    CompareFolders() {
        for (const char* root : {"base", "new"}) {
            put(root, "a", 10);
            put(root, "series/01", 20);
        }
    }
    void put(const std::string& root, const std::string& run, double distance, const Log& log = stepSteer()) const {
        const std::string folder = root + "/" + run;
        std::filesystem::create_directories(scratch.path(folder));
        writeLog(scratch.path(folder + "/log.csv"), log);
        const Json metrics = {{"metrics",
                               {{{"name", "distance"}, {"value", distance}, {"unit", "m"}},
                                {{"name", "lag"}, {"value", nullptr}, {"unit", "s"}}}}};
        scratch.file(folder + "/metrics.json", metrics.dump());
    }
    Result compare(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"compare", scratch.path("base"), scratch.path("new")};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }
    Scratch scratch;
};

TEST_F(CompareFolders, EqualFoldersAreTheSame) {
    const Result result = compare();
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(firstLine(result.out), "Same within tolerance: 2 runs, 8 channels, 4 metrics");
}

TEST_F(CompareFolders, MetricsAndChannelsThatDifferAreSaidEverywhere) {
    put("new", "a", 10.2);
    put("new", "series/01", 20, cli::with(stepSteer(), "chassis.ay", [](double t, double a) { return t < 3 ? a : 0; }));
    const std::string page = scratch.path("page.html"), xml = scratch.path("j.xml");
    const Result result = compare({"--report", page, "--junit", xml});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(firstLine(result.out), "Different: 2 of 2 runs");
    EXPECT_NE(result.out.find("distance 10.2 m instead of 10 m, 0.051 m allowed"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("first at t = 3 s, chassis.ay 0 instead of 4.99998 m/s2"), std::string::npos)
        << result.out;
    EXPECT_NE(contentOf(page).find("class=\"alarm\">different"), std::string::npos);
    EXPECT_NE(contentOf(page).find("distance 10.2 m instead of 10 m"), std::string::npos);
    EXPECT_NE(contentOf(xml).find("tests=\"2\" failures=\"2\" errors=\"0\""), std::string::npos);
    const Json json = Json::parse(compare({"--json"}).out);
    EXPECT_EQ(json["same"], false);
    EXPECT_EQ(json["runs"][0]["run"], "a");
    EXPECT_EQ(json["runs"][0]["metrics"][0]["same"], false);
    EXPECT_EQ(json["runs"][0]["channels"]["same"], true);
    EXPECT_EQ(json["runs"][1]["run"], "series/01");
    EXPECT_EQ(json["runs"][1]["channels"]["differing"], 1);
}

TEST_F(CompareFolders, MetricTolerancesTakeUnits) {
    put("new", "a", 10.2);
    const auto with = [&](const std::string& absolute) {
        return compare({"--tolerances", scratch.file("t.yaml", "metrics:\n  - {metric: dist*, absolute: " + absolute +
                                                                   ", relative: 0}\n")});
    };
    EXPECT_EQ(with("21 cm").status, 0);
    EXPECT_EQ(with("19 cm").status, 1);
    const Result wrong = with("3 s");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.out, "");
    EXPECT_EQ(wrong.err.find(scratch.path("t.yaml") + ":2:31: metrics.0.absolute: found a time"), 0u) << wrong.err;
}

TEST_F(CompareFolders, AMetricThatCanNoLongerBeComputedDiffers) {
    scratch.file("base/a/metrics.json", R"({"metrics": [{"name": "lag", "value": 1, "unit": "s"}]})");
    const Result result = compare();
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.out.find("lag undefined instead of 1 s"), std::string::npos) << result.out;
}

TEST_F(CompareFolders, ARunOnOneSideOnlyIsADifferenceAndNamed) {
    put("new", "b", 1);
    std::filesystem::remove_all(scratch.path("new/a"));
    const Result result = compare();
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(firstLine(result.out), "Different: 2 of 3 runs");
    EXPECT_NE(result.out.find("a                            different\n    The run is only in the reference."),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("b                            different\n    The run is only in the new folder."),
              std::string::npos)
        << result.out;
}

TEST_F(CompareFolders, NothingComparedIsBadInput) {
    const auto refused = [&](const std::vector<std::string>& more) {
        const Result result = compare(more);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    const std::string ignored =
        scratch.file("t.yaml", "channels: [{channel: '*', ignore: true}]\nmetrics: [{metric: '*', ignore: true}]\n");
    EXPECT_NE(refused({"--tolerances", ignored}).find("nothing was compared: none of 2 runs"), std::string::npos);
    std::filesystem::remove_all(scratch.path("new"));
    EXPECT_NE(refused({}).find("which is not a folder"), std::string::npos);
    std::filesystem::create_directory(scratch.path("new"));
    EXPECT_NE(refused({}).find("The run is only in the reference."), std::string::npos);
    std::filesystem::remove_all(scratch.path("base"));
    std::filesystem::create_directory(scratch.path("base"));
    EXPECT_NE(refused({}).find("found no run in"), std::string::npos);
}

TEST_F(CompareFolders, UpdateListsWhatChangesAndMakesTheNewBaseline) {
    put("new", "a", 12);
    put("new", "b", 1);
    std::filesystem::remove_all(scratch.path("new/series"));
    scratch.file("new/a/report.html", "page");
    const Result result = compare({"--update"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("distance 12 m instead of 10 m"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("3 of 3 runs"), std::string::npos) << result.err;
    EXPECT_EQ(compare().status, 0) << compare().out;
    EXPECT_FALSE(std::filesystem::exists(scratch.path("base/series/01")));
    EXPECT_FALSE(std::filesystem::exists(scratch.path("base/a/report.html"))) << "a baseline keeps no pages";

    std::filesystem::remove_all(scratch.path("base"));
    EXPECT_EQ(compare({"--update"}).status, 0) << "the first baseline";
    EXPECT_EQ(compare().status, 0);
}

TEST_F(CompareFolders, OptionsOfLogsAndOfFoldersAreToldApart) {
    const Result score = compare({"--score", "iso18571"});
    EXPECT_EQ(score.status, 2);
    EXPECT_NE(score.err.find("expected two logs"), std::string::npos) << score.err;
    const std::string log = scratch.path("base/a/log.csv");
    const Result update = runProgram({"compare", log, log, "--update"});
    EXPECT_EQ(update.status, 2);
    EXPECT_NE(update.err.find("expected two folders of runs"), std::string::npos) << update.err;
}

}  // namespace
}  // namespace tread::compare_folders_test
