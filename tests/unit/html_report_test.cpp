#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/embedded.h"
#include "report/html.h"
#include "report/overlay_report.h"
#include "report/pack.h"
#include "report/run_report.h"
#include "report/series_figures.h"
#include "report/series_report.h"
#include "shared/markup.h"
#include "shared/page_charts.h"

namespace tread::html_report_test {
namespace {

constexpr const char* kHostile = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&<!--";
constexpr std::array kWheels = {"front_left", "front_right", "rear_left", "rear_right"};

// A step steer: only the shape of the signals matters here, not the car.
Log stepSteer(std::size_t samples, double dt) {
    Log log;
    const auto add = [&](const std::string& name, const std::string& unit, auto value) {
        Channel channel{name, unit, {}};
        for (std::size_t i = 0; i < samples; ++i) channel.values.push_back(value(static_cast<double>(i) * dt));
        log.channels.push_back(std::move(channel));
    };
    const auto rise = [](double t) { return t < 1 ? 0.0 : 1 - std::exp(-5 * (t - 1)) * std::cos(8 * (t - 1)); };
    add("time", "s", [](double t) { return t; });
    add("driver.steering_wheel_angle", "rad", [](double t) { return t < 1 ? 0.0 : 1.0; });
    add("driver.throttle", "-", [](double) { return 0.25; });
    add("driver.brake", "-", [](double) { return 0.0; });
    add("chassis.x", "m", [](double t) { return 20 * t; });
    add("chassis.y", "m", [](double t) { return 0.1 * t * t; });
    for (const char* angle : {"roll", "pitch", "yaw", "sideslip"}) {
        add(std::string("chassis.") + angle, "rad", [&](double t) { return 0.05 * rise(t); });
    }
    add("chassis.vx", "m/s", [](double t) { return 20 + std::sin(900 * t); });
    add("chassis.yaw_rate", "rad/s", [&](double t) { return 0.4 * rise(t); });
    add("chassis.ax", "m/s2", [](double t) { return std::sin(400 * t); });
    add("chassis.ay", "m/s2", [&](double t) { return 8 * rise(t) + 0.3 * std::sin(700 * t); });
    for (const char* wheel : kWheels) {
        const std::string prefix = std::string("wheel.") + wheel + ".";
        for (const auto& [quantity, unit] : std::vector<std::pair<const char*, const char*>>{{"load", "N"},
                                                                                             {"fx", "N"},
                                                                                             {"fy", "N"},
                                                                                             {"mz", "N m"},
                                                                                             {"slip_ratio", "-"},
                                                                                             {"slip_angle", "rad"},
                                                                                             {"camber", "rad"},
                                                                                             {"steer", "rad"},
                                                                                             {"spin", "rad/s"},
                                                                                             {"travel", "m"},
                                                                                             {"patch_u", "m"},
                                                                                             {"patch_v", "m"}}) {
            // Rough on purpose: a curve that decimation cannot thin out for free.
            add(prefix + quantity, unit, [&](double t) { return 3000 + 500 * rise(t) + 100 * std::sin(1000 * t * t); });
        }
    }
    add("driveline.engine_speed", "rad/s", [](double) { return 300.0; });
    add("driveline.gear", "-", [](double) { return 3.0; });
    return log;
}

RunReport reportOf(const Log& log) {
    return {.title = "Step steer",
            .answer = "It turns.",
            .vehicle = "compact",
            .scenario = "step_steer",
            .version = "1",
            .log = log};
}

const nlohmann::json* chartNamed(const nlohmann::json& charts, const std::string& title) {
    for (const auto& chart : charts) {
        if (chart["title"] == title) return &chart;
    }
    return nullptr;
}

std::vector<float> curve(const nlohmann::json& chart, std::size_t index) {
    return unpacked<float>(chart["curves"][index]["values"].get<std::string>());
}

const std::array kOwnScripts{embedded::kValuesScript, embedded::kChartsScript, embedded::kReplayRoadScript,
                             embedded::kReplayCarScript, embedded::kReplayScript};

// What a browser would read as markup of ours: the page without scripts and the embedded library files.
std::string withoutLibrary(std::string page) {
    const auto cut = [&page](std::string_view part) {
        const auto at = page.find(part);
        if (at != std::string::npos) page.erase(at, part.size());
        return at != std::string::npos;
    };
    const auto untilMap = [](std::string_view text, std::string_view map) { return text.substr(0, text.find(map)); };
    EXPECT_TRUE(cut(untilMap(embedded::kDygraphsScript, "//# sourceMappingURL=")));
    EXPECT_TRUE(cut(untilMap(embedded::kDygraphsStyle, "/*# sourceMappingURL=")));
    EXPECT_TRUE(cut(untilMap(embedded::kDygraphsSynchronizer, "//# sourceMappingURL=")));
    EXPECT_TRUE(cut(embedded::kDygraphsLicence));
    if (page.find("id=\"replay-data\"") != std::string::npos) {
        for (const std::string_view part : {embedded::kThreeScript, embedded::kThreeOrbit, embedded::kThreeLicence})
            EXPECT_TRUE(cut(part));
    }
    for (const std::string_view script : kOwnScripts) cut(script);
    return page;
}

void expectSelfContained(const std::string& page) {
    const auto tags = readTags(page);
    ASSERT_TRUE(tags) << "a < that does not begin a tag of ours";
    EXPECT_EQ(unclosed(*tags), "");
    for (const Tag& tag : *tags) {
        for (const char* loads : {"link", "iframe", "object", "embed", "base", "img", "image", "use"})
            EXPECT_NE(tag.name, loads);
        for (const auto& [attribute, value] : tag.attributes) {
            for (const char* loads : {"src", "srcset", "data", "poster", "action"}) EXPECT_NE(attribute, loads);
            EXPECT_NE(attribute.substr(0, 2), "on") << "an event handler";
            if (attribute == "href") {
                EXPECT_EQ(value.substr(0, 1), "#") << value;
            }
        }
    }
    for (const char* reference : {"http://", "https://", "url(", "@import", "//#"}) {
        EXPECT_EQ(page.find(reference), std::string::npos) << reference;
    }
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

// Of a page that links one other page.
void expectSelfContainedBut(std::string page, const std::string& link) {
    const std::string address = "href=\"" + link + "\"";
    for (auto at = page.find(address); at != std::string::npos; at = page.find(address))
        page.replace(at, address.size(), "href=\"#\"");
    expectSelfContained(page);
}

TEST(HtmlReport, LibraryFilesCanStandInsideAScriptElement) {
    std::vector<std::string_view> files{kOwnScripts.begin(), kOwnScripts.end()};
    for (const std::string_view file :
         {embedded::kDygraphsScript, embedded::kDygraphsSynchronizer, embedded::kThreeScript, embedded::kThreeOrbit,
          embedded::kDygraphsLicence, embedded::kThreeLicence})
        files.push_back(file);
    for (const std::string_view file : files) {
        EXPECT_GT(file.size(), 1000u);
        EXPECT_EQ(file.find("</script"), std::string_view::npos);
        EXPECT_EQ(file.find("<!--"), std::string_view::npos);
    }
    EXPECT_NE(embedded::kDygraphsScript.find("Dygraph"), std::string_view::npos);
}

TEST(HtmlReport, NothingIsLoadedFromAnywhere) {
    const Log log = stepSteer(500, 0.01);
    RunReport content = reportOf(log);
    content.metrics = {{"Overshoot", 0.1, "-", "peak over steady value"}};
    content.resolved_yaml = "speed: 80 km/h";
    expectSelfContained(withoutLibrary(runReport(content)));

    for (const std::string_view script : kOwnScripts) EXPECT_EQ(script.find("://"), std::string_view::npos);
    // Of the library only comments may name an address.
    const std::string library = std::string(embedded::kDygraphsScript);
    EXPECT_EQ(count(library, "://"), count(library, "@license https://github.com/danvk/dygraphs/"));
}

TEST(HtmlReport, HostileTextIsHarmlessWhereverItStands) {
    const Log log = stepSteer(300, 0.01);
    RunReport run{.title = kHostile,
                  .answer = kHostile,
                  .vehicle = kHostile,
                  .scenario = kHostile,
                  .scenario_description = kHostile,
                  .version = kHostile,
                  .log = log,
                  .metrics = {{kHostile, 1, kHostile, kHostile}},
                  .resolved_yaml = kHostile,
                  .warnings = {kHostile}};
    const ChannelOverlay channel{.name = kHostile,
                                 .unit = kHostile,
                                 .time = {0, 1},
                                 .reference = {0, 1},
                                 .candidate = {0, 2},
                                 .tolerance = 0.5,
                                 .largest = 1,
                                 .rms = 0.7,
                                 .first_time_out = 1,
                                 .ok = false};
    const OverlayReport overlay{.title = kHostile,
                                .answer = kHostile,
                                .reference_name = kHostile,
                                .candidate_name = kHostile,
                                .version = kHostile,
                                .ok = false,
                                .channels = {channel},
                                .warnings = {kHostile}};
    Chart chart{.title = kHostile, .x = {kHostile, kHostile}, .y = {kHostile, kHostile}, .series = {}};
    chart.series = {{.name = kHostile, .x = {0, 1}, .y = {0, 1}}};
    chart.note = kHostile;
    HtmlPage figures(kHostile);
    figures.answer(kHostile);
    figures.section(kHostile);
    figures.text(kHostile);
    figures.figures({chart});

    // Charts: values, common script, library, synchronizer, script, licence. Replay: values, two libraries, three
    // scripts, licence.
    const std::array<std::pair<std::string, std::size_t>, 3> pages = {
        {{runReport(run), 13}, {overlayReport(overlay), 6}, {figures.finish(), 0}}};
    for (const auto& [page, scripts] : pages) {
        EXPECT_EQ(count(page, "<script"), scripts);
        EXPECT_EQ(count(page, "</script"), scripts);
        EXPECT_EQ(page.find("<img"), std::string::npos);
        EXPECT_EQ(count(page, "</title>"), 1u);
        expectSelfContained(scripts > 0 ? withoutLibrary(page) : page);
        EXPECT_GE(count(page, "&lt;/script&gt;&lt;script&gt;alert(1)"), 4u) << "shown as it was written";
    }
    const auto charts = chartsOf(overlayReport(overlay));
    ASSERT_EQ(charts.size(), 2u);
    EXPECT_EQ(charts[0]["title"], kHostile) << "the script gets the text unchanged and sets it as text";
}

TEST(HtmlReport, TextThatIsNotUnicodeDoesNotStopTheReport) {
    const Log log = stepSteer(10, 0.1);
    const ChannelOverlay channel{
        .name = "a\xff\xfe", .unit = "N", .time = {0, 1}, .reference = {0, 1}, .candidate = {0, 1}};
    const OverlayReport overlay{.title = "\xc3",
                                .answer = "",
                                .reference_name = "r",
                                .candidate_name = "c",
                                .version = "1",
                                .channels = {channel}};
    EXPECT_EQ(chartsOf(overlayReport(overlay)).size(), 2u);
}

TEST(RunReport, TenSecondsAtOneKilohertzStayUnderFourMegabytes) {
    Log log = stepSteer(10000, 0.001);
    for (int i = 0; log.channels.size() < 100; ++i) {
        log.channels.push_back({"extra." + std::to_string(i), "N", log.channels[1].values});
    }
    const std::string page = runReport(reportOf(log));
    EXPECT_LT(page.size(), 4'000'000u);
    EXPECT_GE(chartsOf(page).size(), 19u);
    RecordProperty("bytes", static_cast<int>(page.size()));
}

TEST(RunReport, QuantitiesAreShownInTheUnitsOfTheTrade) {
    Log log = stepSteer(300, 0.01);
    const auto set = [&log](std::string_view name, double value) {
        for (Channel& channel : log.channels) {
            if (channel.name == name) channel.values.assign(channel.values.size(), value);
        }
    };
    set("driver.steering_wheel_angle", 1.0);
    set("chassis.vx", 10);
    set("chassis.yaw_rate", -0.5);
    set("chassis.ay", 7);
    set("wheel.rear_left.slip_angle", 0.1);
    set("wheel.rear_left.load", 3100);
    set("driveline.engine_speed", 314.1592653589793);
    const auto charts = chartsOf(runReport(reportOf(log)));

    struct Expected {
        const char* title;
        std::size_t curve;
        const char* unit;
        double value;
    };
    for (const Expected& expected : {Expected{"Steering-wheel angle", 0, "deg", 57.29577951},
                                     {"Speed", 0, "km/h", 36},
                                     {"Yaw rate", 0, "deg/s", -28.64788976},
                                     {"Acceleration", 0, "m/s²", 7},
                                     {"Pedals", 0, "%", 25},
                                     {"Slip angle", 2, "deg", 5.729577951},
                                     {"Wheel load", 2, "N", 3100},
                                     {"Engine speed", 0, "rev/min", 3000}}) {
        const auto* chart = chartNamed(charts, expected.title);
        ASSERT_NE(chart, nullptr) << expected.title;
        EXPECT_EQ((*chart)["unit"], expected.unit);
        const auto values = curve(*chart, expected.curve);
        ASSERT_EQ(values.size(), 300u);
        EXPECT_NEAR(values[150], expected.value, 1e-6 * std::abs(expected.value)) << expected.title;
    }
}

TEST(RunReport, PeaksOfALongLogAreStillThere) {
    Log log = stepSteer(60000, 0.001);
    for (Channel& channel : log.channels) {
        if (channel.name == "wheel.rear_right.load") channel.values[43210] = 9876;
    }
    const auto charts = chartsOf(runReport(reportOf(log)));
    const auto* chart = chartNamed(charts, "Wheel load");
    ASSERT_NE(chart, nullptr);
    const auto time = unpacked<double>((*chart)["time"].get<std::string>());
    const auto values = curve(*chart, 3);
    ASSERT_EQ(time.size(), values.size());
    EXPECT_LE(values.size(), 4002u);
    const auto peak = std::max_element(values.begin(), values.end());
    EXPECT_EQ(*peak, 9876.0f);
    EXPECT_DOUBLE_EQ(time[static_cast<std::size_t>(peak - values.begin())], 43.210);
    EXPECT_DOUBLE_EQ(time.front(), 0);
    EXPECT_DOUBLE_EQ(time.back(), 59.999);
}

TEST(RunReport, AWheelLooksTheSameInEveryChartAndRearWheelsAreDashed) {
    const Log log = stepSteer(100, 0.01);
    std::array<std::string, 4> colours;
    std::size_t seen = 0;
    for (const auto& chart : chartsOf(runReport(reportOf(log)))) {
        if (chart["curves"].size() != 4) continue;
        ++seen;
        for (std::size_t wheel = 0; wheel < 4; ++wheel) {
            const auto& drawn = chart["curves"][wheel];
            if (colours[wheel].empty()) colours[wheel] = drawn["colour"];
            EXPECT_EQ(drawn["colour"], colours[wheel]);
            EXPECT_EQ(drawn["dashed"], wheel >= 2);
        }
    }
    EXPECT_EQ(seen, 10u);
    std::sort(colours.begin(), colours.end());
    EXPECT_EQ(std::unique(colours.begin(), colours.end()), colours.end()) << "four wheels, four colours";
}

TEST(RunReport, MissingChannelsAreLeftOut) {
    Log log{{{"time", "s", {0, 1, 2}}, {"chassis.vx", "m/s", {10, 11, 12}}, {"chassis.yaw_rate", "rad/s", {0, 0.1}}}};
    const std::string page = runReport(reportOf(log));
    const auto charts = chartsOf(page);
    ASSERT_EQ(charts.size(), 1u) << "the yaw rate breaks off before the log ends";
    EXPECT_EQ(charts[0]["title"], "Speed");
    for (const char* absent : {"Yaw rate", "Wheel load", "Path from above", "Used friction", "Driveline", "Metrics"}) {
        EXPECT_EQ(page.find(absent), std::string::npos) << absent;
    }
}

TEST(RunReport, AnEmptyLogStillGivesAnAnswer) {
    for (const Log& log : {Log{}, Log{{{"time", "s", {}}}},
                           Log{{{"time", "s", {0}},
                                {"chassis.x", "m", {1}},
                                {"chassis.y", "m", {1}},
                                {"chassis.yaw", "rad", {std::nan("")}}}}}) {
        const std::string page = runReport(reportOf(log));
        EXPECT_NE(page.find("It turns."), std::string::npos);
        EXPECT_EQ(count(page, "<script"), 0u) << "no charts, no library";
    }
}

TEST(RunReport, TheFirstSixMetricsAreCardsAndAllAreInTheTable) {
    const Log log;
    RunReport content = reportOf(log);
    for (int i = 0; i < 8; ++i)
        content.metrics.push_back({"metric " + std::to_string(i), 0.1 * i, "rad/s", "definition"});
    content.metrics.push_back({"time to stop", std::nan(""), "s", "not reached"});
    const std::string page = runReport(content);
    EXPECT_EQ(count(page, "class=\"card\""), 6u);
    EXPECT_EQ(count(page, "<td class=\"\">definition</td>"), 8u);
    EXPECT_NE(page.find("<td class=\"number \">5.7296</td><td class=\"\">deg/s</td>"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"number \">–</td><td class=\"\">s</td>"), std::string::npos);
}

TEST(RunReport, AWheelInTheAirHasNoWorkingPoint) {
    Log log{{{"time", "s", {0, 1, 2}},
             {"wheel.front_left.fx", "N", {0, 0, 5}},
             {"wheel.front_left.fy", "N", {1000, 2000, 9}},
             {"wheel.front_left.load", "N", {4000, 4000, 1}}}};
    const std::string page = runReport(reportOf(log));
    const auto figure = page.find("Used friction");
    ASSERT_NE(figure, std::string::npos);
    // 9 N over 1 N would be drawn far outside; the circle of radius 1 sets the range instead.
    EXPECT_EQ(page.find(">5.0</text>", figure), std::string::npos);
    EXPECT_NE(page.find(">1.0</text>", figure), std::string::npos);
}

TEST(OverlayReport, WorstChannelComesFirstAndTheVerdictIsInWords) {
    OverlayReport content{.title = "Compare",
                          .answer = "One channel differs.",
                          .reference_name = "a.csv",
                          .candidate_name = "b.csv",
                          .version = "1",
                          .ok = false,
                          .channels = {}};
    content.channels = {
        {.name = "fine", .unit = "N", .time = {0, 1}, .reference = {0, 1}, .candidate = {0, 1}, .tolerance = 1},
        {.name = "close",
         .unit = "N",
         .time = {0, 1},
         .reference = {0, 1},
         .candidate = {0, 1.9},
         .tolerance = 1,
         .largest = 0.9,
         .rms = 0.6},
        {.name = "bad",
         .unit = "rad",
         .time = {0, 1},
         .reference = {0, 1},
         .candidate = {0, 3},
         .tolerance = 1,
         .largest = 2,
         .rms = 1.4,
         .first_time_out = 1,
         .ok = false}};
    const std::string page = overlayReport(content);
    EXPECT_NE(page.find("✗ out of tolerance"), std::string::npos);
    EXPECT_LT(page.find("<td class=\"\">bad</td>"), page.find("<td class=\"\">close</td>"));
    EXPECT_LT(page.find("<td class=\"\">close</td>"), page.find("<td class=\"\">fine</td>"));
    EXPECT_NE(page.find("<td class=\"number \">114.6</td>"), std::string::npos) << "2 rad in degrees";
    EXPECT_NE(page.find("<td class=\"number alarm\">200</td>"), std::string::npos) << "per cent of the tolerance";

    const auto charts = chartsOf(page);
    ASSERT_EQ(charts.size(), 6u);
    EXPECT_EQ(charts[0]["title"], "bad");
    EXPECT_GT(charts[0]["curves"][0]["width"].get<double>(), charts[0]["curves"][1]["width"].get<double>());
    EXPECT_NEAR(curve(charts[1], 0)[1], 114.591559, 1e-4) << "candidate minus reference, in degrees";
    EXPECT_NEAR(charts[1]["band"].get<double>(), 57.29577951, 1e-6);
    EXPECT_EQ(charts[1]["marks"], nlohmann::json::parse("[1.0]"));

    content.ok = true;
    EXPECT_NE(overlayReport(content).find("✓ within tolerance"), std::string::npos);
}

TEST(OverlayReport, ManyChannelsAreListedInFullAndTheWorstAreDrawn) {
    OverlayReport content{
        .title = "c", .answer = "", .reference_name = "a", .candidate_name = "b", .version = "1", .channels = {}};
    for (int i = 0; i < 60; ++i) {
        content.channels.push_back({.name = "channel " + std::to_string(i),
                                    .unit = "N",
                                    .time = {0, 1},
                                    .reference = {0, 1},
                                    .candidate = {0, 1},
                                    .tolerance = 1,
                                    .largest = 0.01 * i});
    }
    const std::string page = overlayReport(content);
    EXPECT_EQ(count(page, "<td class=\"\">channel "), 60u);
    const auto charts = chartsOf(page);
    ASSERT_EQ(charts.size(), 48u);
    EXPECT_EQ(charts[0]["title"], "channel 59");
    EXPECT_NE(page.find("of 60"), std::string::npos) << "says that not all are drawn";
}

TEST(OverlayReport, CurvesComeFirstAndAPoorFitIsSaid) {
    OverlayReport content{.title = "Compare",
                          .answer = "Different.",
                          .reference_name = "compact",
                          .candidate_name = "sedan",
                          .version = "1",
                          .channels = {},
                          .reference_file = "out/a/log.csv",
                          .candidate_file = "out/b/log.csv"};
    content.channels = {{.name = "far",
                         .unit = "N",
                         .time = {0, 1},
                         .reference = {0, 1},
                         .candidate = {90, 91},
                         .tolerance = 1,
                         .largest = 90,
                         .no_fit = true,
                         .ok = false}};
    const std::string page = overlayReport(content);
    EXPECT_LT(page.find("<h2>Curves, worst first</h2>"), page.find("<h2>Channels</h2>"));
    EXPECT_NE(page.find("<td class=\"number \">no fit</td>"), std::string::npos);
    EXPECT_NE(page.find("no fit: the mean of the reference is closer"), std::string::npos);
    EXPECT_NE(page.find("<dd>compact (out/a/log.csv)</dd>"), std::string::npos);
    EXPECT_NE(page.find("<dd>sedan (out/b/log.csv)</dd>"), std::string::npos);
    EXPECT_EQ(chartsOf(page)[0]["curves"][1]["name"], "sedan");
}

// A browser runs only scripts whose hashes the page names.
TEST(HtmlReport, ThePolicyNamesEveryScriptThatThePageRuns) {
    const Log log = stepSteer(100, 0.01);
    const std::string page = runReport(reportOf(log));
    const auto policy = page.substr(page.find("script-src"), page.find("style-src") - page.find("script-src"));
    EXPECT_EQ(policy.find("unsafe"), std::string::npos);
    std::size_t programs = 0;
    const std::string begin = "<script>";
    for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
        const auto from = at + begin.size();
        const std::string content = page.substr(from, page.find("</script>", from) - from);
        EXPECT_NE(policy.find("'sha256-" + sha256Base64(content) + "'"), std::string::npos);
        ++programs;
    }
    EXPECT_EQ(count(policy, "'sha256-"), programs);
    // FIPS 180-4: the hash of "abc".
    EXPECT_EQ(sha256Base64("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

TEST(HtmlReport, ChartsAndTablesAreReadableWithoutSeeingThem) {
    const Log log = stepSteer(100, 0.01);
    RunReport content = reportOf(log);
    content.metrics = {{"yaw_rate", 0.1, "rad/s", "largest"}};
    const std::string page = runReport(content);
    EXPECT_NE(page.find("<th scope=\"col\">Metric</th>"), std::string::npos);
    EXPECT_EQ(page.find("<th>"), std::string::npos);
    EXPECT_NE(page.find("role=\"img\" aria-label=\"Chart of Steering-wheel angle [deg] over time: steering wheel\""),
              std::string::npos);
    EXPECT_EQ(count(page, "class=\"canvas\" role=\"img\""), chartsOf(page).size());
}

TEST(RunReport, CardsAreInWordsWithUnitsAndResultsFirst) {
    const Log log;
    RunReport content = reportOf(log);
    content.metrics = {{"initial_speed", 27.8, "m/s", "at the pedal", {}, "Initial speed"},
                       {"mfdd", 9.1, "m/s2", "mean", {1, "{}"}, "Deceleration, mean fully developed"}};
    content.files = {{"log.csv", "log.csv"}, {"run.yaml", "run.yaml"}};
    const std::string page = runReport(content);
    const auto mean = page.find("<span>Deceleration, mean fully developed</span><b>9.1<small> m/s²</small></b>");
    ASSERT_NE(mean, std::string::npos);
    EXPECT_LT(mean, page.find("<span>Initial speed</span>"));
    EXPECT_NE(page.find("<td class=\"\">Deceleration, mean fully developed<small>mfdd</small></td>"), std::string::npos)
        << "the name, for conditions";
    EXPECT_NE(page.find("<a href=\"log.csv\">log.csv</a> · <a href=\"run.yaml\">run.yaml</a>"), std::string::npos);
}

TEST(RunReport, MarginsOfVerdictsAreLarge) {
    const Log log;
    RunReport content = reportOf(log);
    content.verdicts = {{"", "distance", 36.2, "m", "< 40 m", true, "Stopping distance", 3.8},
                        {"", "cones", 2, "-", "= 0", false, "Cones hit", {}}};
    const std::string page = runReport(content);
    EXPECT_NE(
        page.find("<span>Stopping distance</span><b class=\"good\">✓ 3.8 m<small> to spare</small></b><em>36.2 m, "
                  "required &lt; 40 m</em>"),
        std::string::npos);
    EXPECT_NE(page.find("<span>Cones hit</span><b class=\"bad\">✗ missed<small> </small></b>"), std::string::npos);
}

SeriesReport::Run runOf(double value, bool passed, double ratio) {
    return {value,
            passed,
            "",
            {{"ratio", ratio, "-", "yaw rate left", {1, "{}"}, "Yaw rate left", "<= 35 %"},
             {"flag", passed ? 1.0 : 0.0, "-", "1 when passed"},
             {"held", 7, "m", "always the same"}},
            "01/report.html"};
}

TEST(SeriesReport, DrawsTheMetricsOverWhatIsVariedWithTheirLimits) {
    SeriesReport content{.title = "Series",
                         .answer = "2 of 3 runs pass",
                         .vehicle = "compact",
                         .scenario_description = "",
                         .version = "1",
                         .number = "phases.1.steering.amplitude",
                         .unit = "rad",
                         .runs = {runOf(3, false, 0.5), runOf(1, true, 0.1), runOf(2, true, 0.2)},
                         .resolved_yaml = ""};
    auto charts = seriesFigures(content);
    ASSERT_EQ(charts.size(), 1u) << "neither a flag nor what does not change";
    EXPECT_EQ(charts[0].title, "Yaw rate left");
    EXPECT_EQ(charts[0].x.label, "amplitude");
    EXPECT_EQ(charts[0].x.unit, "deg");
    EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{0.1, 0.2, 0.5})) << "in the order of the varied number";
    EXPECT_EQ(charts[0].series[1].name, "passed");
    EXPECT_EQ(charts[0].series[2].name, "not passed");
    EXPECT_EQ(charts[0].series[2].y, std::vector<double>{0.5});
    EXPECT_EQ(charts[0].series[3].name, "standard: <= 35 %");
    EXPECT_EQ(charts[0].series[3].y, (std::vector<double>{0.35, 0.35}));

    content.verdicts = {{"01", "ratio", 0.5, "-", "<= 30 %", false, "Yaw rate left", -0.2}};
    charts = seriesFigures(content);
    EXPECT_EQ(charts[0].series[3].name, "accepted: <= 30 %") << "the user's condition in place of the standard";
    EXPECT_EQ(charts[0].series[3].y.front(), 0.3);
    const std::string page = seriesReport(content);
    EXPECT_NE(page.find("<h2>Results over amplitude</h2>"), std::string::npos);
    EXPECT_NE(page.find("<b class=\"bad\">✗ 20 %<small> beyond"), std::string::npos);
    EXPECT_NE(page.find("✗ no"), std::string::npos);
    expectSelfContainedBut(page, "01/report.html");
}

TEST(Overview, MarksFailuresInWordsAndColourAndShowsResults) {
    Overview content{.title = "All", .answer = "2 of 3 driven", .vehicle = "compact", .version = "1", .entries = {}};
    const std::vector<Metric> metrics{{"speed", 20, "m/s", "", {}, "Speed"},
                                      {"distance", 40, "m", "", {1, "{} m"}, "Stopping distance"}};
    content.entries = {{"a", "A", "stops", metrics, {}, "a/report.html", true},
                       {"b",
                        "B",
                        "stops",
                        metrics,
                        {},
                        "b/report.html",
                        true,
                        {{"", "distance", 40, "m", "< 30 m", false, "Stopping distance", -10}}},
                       {"c", "C", "failed: it never ends", {}, {}, "", false}};
    const std::string page = overviewReport(content);
    EXPECT_NE(page.find("verdict bad\">✗ not all driven"), std::string::npos);
    EXPECT_NE(page.find("<b class=\"bad\">✗ 2 of 3"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"\">✓ driven</td>"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"alarm\">✗ not accepted, missed</td>"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"alarm\">✗ failed</td>"), std::string::npos);
    EXPECT_NE(page.find("<small>Stopping distance: 40 m</small>"), std::string::npos);
}

TEST(HtmlReport, FiguresNeedNoScript) {
    Chart chart{.title = "Lateral force", .x = {"slip angle", "deg"}, .y = {"Fy", "N"}, .series = {}};
    chart.series = {{.name = "4000 N", .x = {-1, 0, 1}, .y = {-900, 0, 900}}};
    HtmlPage figures("Tyre");
    figures.figures({chart, chart});
    const std::string page = figures.finish();
    EXPECT_EQ(count(page, "<svg class=\"tread-chart\""), 2u);
    EXPECT_EQ(count(page, "<script"), 0u);
    EXPECT_LT(page.size(), 20000u);
    expectSelfContained(page);
}

}  // namespace
}  // namespace tread::html_report_test
