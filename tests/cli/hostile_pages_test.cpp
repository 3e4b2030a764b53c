// Every kind of page, written by the program for files whose names, titles and units are markup, and opened in a
// browser.
#include "cli/answered_check.h"
#include "cli/logs.h"
#include "cli/tread_run.h"
#include "log/csv.h"
#include "shared/browser.h"

namespace tread::hostile_pages_test {
namespace {

namespace fs = std::filesystem;

// What marks the body of a page if a browser takes it for markup: also as the name of a file, which has no slash.
const std::string kName = "<img src=x onerror=document.body.id='ran'>";
const std::string kText = "</script><script>document.body.id='ran'</script>" + kName;

bool ranIn(const std::string& dom) {
    return dom.find("id=\"ran\"") != std::string::npos || dom.find("<img") != std::string::npos;
}

class HostilePage : public TreadRun {
protected:
    void SetUp() override {
        scratch.file(kName + ".yaml", carText("name: compact front-drive hatchback", "name: \"" + kText + "\""));
        scratch.file("stop.yaml", stop());
    }
    static std::string stop(const std::string& more = "") {
        std::string text = replaced(kShortStop, "A short stop", "\"" + kText + "\"");
        return replaced(text, "name: straight", "name: \"" + kText + "\"") + more;
    }
    std::string hostileCar() const { return scratch.path(kName + ".yaml"); }

    // The program writes the page, on which the text is to be read.
    void expectHarmless(Names words, const std::string& page) const {
        const Result result = runProgram(words);
        ASSERT_LE(result.status, 1) << result.err;
        const std::string html = contentOf(scratch.path(page));
        EXPECT_NE(html.find("onerror"), std::string::npos) << "the text is on the page";
        EXPECT_EQ(html.find("<img src=x"), std::string::npos);
        EXPECT_EQ(html.find("</script><script>document"), std::string::npos);
        if (!browserIsThere()) return;
        const std::string dom = openedInBrowser(scratch.path(page));
        EXPECT_NE(dom.find("</main>"), std::string::npos) << "the browser shows the page";
        EXPECT_FALSE(ranIn(dom)) << page;
    }
};

TEST_F(HostilePage, WouldRunInABrowserIfItWereMarkup) {
    if (!browserIsThere()) GTEST_SKIP() << "chromium is not installed";
    for (const std::string& text : {kName, kText})
        EXPECT_TRUE(ranIn(openedInBrowser(scratch.file("page.html", "<body><main>" + text + "</main></body>"))));
}

TEST_F(HostilePage, OfARun) {
    expectHarmless({"run", hostileCar(), scratch.path("stop.yaml"), "-o", out(), "--set", "name=" + kText, "--set",
                    "scenario.title=" + kText},
                   "out/report.html");
}

TEST_F(HostilePage, OfASeriesAndOfAllScenariosOfAFolder) {
    fs::create_directory(scratch.path("all"));
    scratch.file("all/" + kName + ".yaml", stop());
    scratch.file("all/series.yaml", stop("series: {vary: {number: start.speed, values: [15 km/h, 20 km/h]}}\n"));
    expectHarmless({"run", hostileCar(), scratch.path("all/series.yaml"), "-o", out()}, "out/report.html");
    expectHarmless({"run", hostileCar(), "--all", scratch.path("all"), "-o", out("all")}, "out/all/index.html");
}

TEST_F(HostilePage, OfACar) {
    expectHarmless({"describe", hostileCar(), "--report", scratch.path("sheet.html")}, "sheet.html");
}

TEST_F(HostilePage, OfATyre) {
    scratch.file(kName + " tyre.yaml", replaced(contentOf(kSource + "/vehicles/tyres/car_205_60R15.yaml"),
                                                "name: car_205_60R15", "name: \"" + kText + "\""));
    expectHarmless({"tyre", scratch.path(kName + " tyre.yaml"), "--plot", scratch.path("tyre.html")}, "tyre.html");
}

TEST_F(HostilePage, OfTwoLogs) {
    Log log = cli::stepSteer();
    log.channels.push_back({kName, kText, log.channels.back().values});
    writeLog(scratch.path(kName + ".csv"), log);
    for (double& value : log.channels.back().values) value *= 2;
    writeLog(scratch.path("other.csv"), log);
    expectHarmless(
        {"compare", scratch.path(kName + ".csv"), scratch.path("other.csv"), "--report", scratch.path("compare.html")},
        "compare.html");
}

TEST_F(HostilePage, OfTwoFolders) {
    for (const std::string folder : {"old", "new"}) {
        ASSERT_EQ(runProgram({"run", hostileCar(), scratch.path("stop.yaml"), "-o", scratch.path(folder + "/" + kName)})
                      .status,
                  0);
    }
    expectHarmless({"compare", scratch.path("old"), scratch.path("new"), "--report", scratch.path("folders.html")},
                   "folders.html");
}

TEST_F(HostilePage, OfACampaign) {
    const std::string file = scratch.file("campaign.yaml", "title: \"" + kText + "\"\nvehicles: [\"" + kName +
                                                               ".yaml\"]\nscenarios: [stop.yaml]\nfactors:\n  - {path: "
                                                               "load.mass, list: [0, 100 kg]}\n");
    expectHarmless({"campaign", file, "-o", out()}, "out/report.html");
}

TEST_F(HostilePage, OfDiagnosesAndOfAnIdentification) {
    fs::create_directories(scratch.path("cars/" + kName));
    const std::string folder = "cars/" + kName + "/";
    writeLog(scratch.path(folder + kName + ".csv"), cli::stepSteer());
    const std::string file = scratch.file(folder + "diagnosis.yaml", "vehicle: \"../../" + kName +
                                                                         ".yaml\"\nrecordings:\n  - {log: \"" + kName +
                                                                         ".csv\", speed: followed}\neffects: "
                                                                         "[steering_ratio]\n");
    expectHarmless({"diagnose", file, "-o", out()}, "out/report.html");
    expectHarmless({"diagnose", "--all", scratch.path("cars"), "-o", out("all")}, "out/all/index.html");
    expectHarmless({"identify", file, "--fit", "steering.ratio", "-o", out("fit")}, "out/fit/report.html");
}

TEST_F(HostilePage, OfABlindCheck) {
    AnsweredCheck check(kText);
    check.key.generator = kText;
    check.write(scratch.path("cases"), scratch.path("out/answers"), scratch.path("key.json"));
    expectHarmless({"blind", "score", scratch.path("cases"), scratch.path("key.json"), "-o", out()}, "out/report.html");
}

}  // namespace
}  // namespace tread::hostile_pages_test
