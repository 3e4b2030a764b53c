#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "report/embedded.h"
#include "report/html.h"
#include "shared/browser.h"
#include "shared/scratch.h"

namespace tread::page_scripts_test {
namespace {

int shell(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str());
}

TEST(PageScripts, EveryScriptParses) {
    if (shell("command -v node") != 0) GTEST_SKIP() << "node is not installed";
    const Scratch scratch;
    for (const std::string_view script :
         {embedded::kValuesScript, embedded::kChartsScript, embedded::kReplayRoadScript, embedded::kReplayCarScript,
          embedded::kReplayScript, embedded::kThreeScript, embedded::kThreeOrbit}) {
        const std::string file = scratch.file("script.js", std::string(script));
        EXPECT_EQ(shell("node --check '" + file + "'"), 0) << script.substr(0, 100);
    }
    EXPECT_NE(shell("node --check '" + scratch.file("broken.js", "const a = ;") + "'"), 0) << "node finds a fault";
}

// What a browser makes of a page: its scripts run under the page's policy, and nothing else does.
TEST(PageScripts, ABrowserRunsThemAndNoOthers) {
    if (!browserIsThere()) GTEST_SKIP() << "chromium is not installed";
    const Scratch scratch;
    const std::string hostile = "<img src=x onerror=\"document.body.id='broken'\">";
    const std::vector<double> time{0, 1, 2}, values{0, 0.04, -0.04};
    HtmlPage page("Page");
    page.section("Charts");
    page.timeCharts({{.title = hostile,
                      .unit = hostile,
                      .time = time,
                      .curves = {{.name = hostile, .values = values, .scale = 100}}}});
    std::string html = page.finish();
    html.insert(html.find("</main>"), "<script>document.body.id = 'foreign';</script>");
    const std::string drawn = openedInBrowser(scratch.file("page.html", html));
    EXPECT_NE(drawn.find("<canvas"), std::string::npos) << "the chart is drawn";
    EXPECT_EQ(drawn.find("<img"), std::string::npos) << "the unit is text";
    EXPECT_EQ(drawn.find("id=\"broken\""), std::string::npos);
    EXPECT_EQ(drawn.find("id=\"foreign\""), std::string::npos) << "a script that the policy does not name";
    for (const char* tick : {">-4<", ">0<", ">4<"}) EXPECT_NE(drawn.find(tick), std::string::npos) << tick;
}

}  // namespace
}  // namespace tread::page_scripts_test
