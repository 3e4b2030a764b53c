#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/logs.h"
#include "cli/program.h"

namespace tread::compare_test {
namespace {

using cli::stepSteer;
using Json = nlohmann::json;

// Yaw rate and lateral acceleration part from the reference at 2 s and 3 s.
Log changed() {
    Log log = cli::with(stepSteer(), "chassis.yaw_rate", [](double t, double r) { return t >= 2 ? 1.1 * r : r; });
    return cli::with(std::move(log), "chassis.ay", [](double t, double a) { return t >= 3 ? a - 1 : a; });
}

struct Compare : testing::Test {
    Compare() {
        writeLog(reference, stepSteer());
        writeLog(other, changed());
    }
    Scratch scratch;
    std::string reference = scratch.path("reference.csv");
    std::string other = scratch.path("new.csv");
};

TEST_F(Compare, EqualLogsAreTheSameWithStatusZero) {
    const Result result = runProgram({"compare", reference, reference});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(firstLine(result.out), "Same, to the last digit: 4 channels");
    EXPECT_EQ(result.err, "");
}

TEST_F(Compare, DifferentLogsHaveStatusOneAndSayWhereEveryChannelParts) {
    const Result result = runProgram({"compare", reference, other});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(firstLine(result.out).find("Different: 2 of 4 channels; first at t = 2 s, chassis.yaw_rate"), 0u)
        << result.out;
    EXPECT_EQ(result.err, "");

    const Json json = Json::parse(runProgram({"compare", reference, other, "--json"}).out);
    EXPECT_EQ(json["same"], false);
    EXPECT_EQ(json["differing"], 2);
    EXPECT_EQ(json["channels"][2]["channel"], "chassis.yaw_rate");
    EXPECT_EQ(json["channels"][2]["first_difference"]["time"], 2.0);
    EXPECT_EQ(json["channels"][3]["first_difference"]["time"], 3.0);
    EXPECT_EQ(json["channels"][0]["first_difference"], nullptr);
}

TEST_F(Compare, ListsEveryDifferingChannelHoweverMany) {
    Log many = stepSteer();
    for (int i = 0; i < 15; ++i) {
        many.channels.push_back(many.channels[3]);
        many.channels.back().name = "extra.n" + std::to_string(i);
    }
    Log wrong = many;
    for (int i = 5; i < 20; ++i) wrong.channels[static_cast<std::size_t>(i)].values.back() += 1;
    writeLog(scratch.path("many.csv"), many);
    writeLog(scratch.path("wrong.csv"), wrong);
    const Result result = runProgram({"compare", scratch.path("many.csv"), scratch.path("wrong.csv")});
    EXPECT_EQ(result.status, 1);
    for (int i = 0; i < 15; ++i) {
        EXPECT_NE(result.out.find("extra.n" + std::to_string(i) + " "), std::string::npos) << i;
    }
}

TEST_F(Compare, ToleranceFileDecides) {
    const std::string wide = scratch.file("wide.yaml", "relative: 0.3\n");
    EXPECT_EQ(runProgram({"compare", reference, other, "--tolerances", wide}).status, 0);
    const std::string own = scratch.file("own.yaml",
                                         "channels:\n"
                                         "  - {channel: chassis.yaw_rate, ignore: true}\n"
                                         "  - {channel: chassis.ay, absolute: 0.9}\n");
    const Result result = runProgram({"compare", reference, other, "--tolerances", own});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(firstLine(result.out).find("Different: 1 of 3 channels; first at t = 3 s, chassis.ay"), 0u) << result.out;
}

TEST_F(Compare, BadInputIsOneSentenceWithStatusTwo) {
    const Result missing = runProgram({"compare", reference, scratch.path("none.csv")});
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.out, "");
    EXPECT_EQ(missing.err, "tread: cannot read '" + scratch.path("none.csv") + "': No such file or directory\n");

    const std::string torn = scratch.file("torn.csv", "time [s],chassis.ay [m/s2]\n0,1\n0.01,x\n");
    const Result faulty = runProgram({"compare", reference, torn});
    EXPECT_EQ(faulty.status, 2);
    EXPECT_EQ(faulty.out, "");
    EXPECT_EQ(faulty.err.find(torn + ":3:6: "), 0u) << faulty.err;

    const std::string bad = scratch.file("bad.yaml", "relativ: 0.1\n");
    const Result tolerances = runProgram({"compare", reference, other, "--tolerances", bad});
    EXPECT_EQ(tolerances.status, 2);
    EXPECT_EQ(tolerances.out, "");
    EXPECT_EQ(tolerances.err.find(bad + ":1:1: "), 0u) << tolerances.err;
    EXPECT_NE(tolerances.err.find("did you mean \"relative\"?"), std::string::npos) << tolerances.err;
}

TEST_F(Compare, WritesAnOverlayReportAndNothingElse) {
    const std::string report = scratch.path("overlay.html");
    const Result result = runProgram({"compare", reference, other, "--report", report});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "overlay report: " + report + "\n");
    const std::string page = contentOf(report);
    for (const char* word : {"reference.csv", "new.csv", "chassis.yaw_rate", "Different: 2 of 4 channels", "</html>"}) {
        EXPECT_NE(page.find(word), std::string::npos) << word;
    }
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"new.csv", "overlay.html", "reference.csv"}));
}

std::string decodeBase64(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(letters.find(c));
        count += 6;
        if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
    }
    return bytes;
}

// The values of the first curve behind a place in the page.
std::vector<float> valuesBehind(const std::string& page, const std::string& place) {
    const std::string key = "\"values\":\"";
    const std::size_t begin = page.find(key, page.find(place)) + key.size();
    const std::string bytes = decodeBase64(page.substr(begin, page.find('"', begin) - begin));
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    return values;
}

// A heading of 179 deg in one log and -178 deg in the other differs by 3 deg, and is drawn so, also where both have
// turned several times.
TEST_F(Compare, OverlayTakesWholeTurnsOutOfAHeading) {
    constexpr double kTurn = 2 * std::numbers::pi, kAhead = 0.05;
    Log turning{{{"time", "s", {}}, {"chassis.yaw", "rad", {}}}};
    for (int i = 0; i <= 100; ++i) {
        turning.channels[0].values.push_back(0.1 * i);
        turning.channels[1].values.push_back(std::remainder(3.1 + 0.1 * i, kTurn));
    }
    writeLog(reference, turning);
    writeLog(other,
             cli::with(turning, "chassis.yaw", [](double, double yaw) { return std::remainder(yaw + kAhead, kTurn); }));
    const std::string report = scratch.path("yaw.html");
    const Result result = runProgram({"compare", reference, other, "--report", report, "--json"});
    EXPECT_NEAR(Json::parse(result.out)["channels"][0]["largest_difference"].get<double>(), kAhead, 1e-9);

    const std::string page = contentOf(report);
    const std::vector<float> differences = valuesBehind(page, "\"title\":\"Difference\"");
    ASSERT_EQ(differences.size(), 101u);
    for (const float value : differences) EXPECT_NEAR(value, kAhead * 360 / kTurn, 1e-3) << "deg";
    const std::vector<float> heading = valuesBehind(page, "\"title\":\"chassis.yaw\"");
    ASSERT_EQ(heading.size(), 101u);
    EXPECT_NEAR(heading.back() - heading.front(), 10 * 360 / kTurn, 1e-3) << "goes on through half a turn";
}

TEST_F(Compare, FurtherLogsAreDrawnInTheReportAndOnlyThere) {
    const Result alone = runProgram({"compare", reference, other, "--repeat", reference});
    EXPECT_EQ(alone.status, 2);
    EXPECT_NE(alone.err.find("found --repeat alone, expected --report"), std::string::npos) << alone.err;

    const std::string third = scratch.path("third.csv"), page = scratch.path("page.html");
    writeLog(third, stepSteer());
    EXPECT_EQ(runProgram({"compare", reference, other, "--repeat", third, "--report", page}).status, 1);
    EXPECT_NE(contentOf(page).find(R"("name":"third.csv")"), std::string::npos);
}

// A comparison that compares nothing is no success.
TEST_F(Compare, NothingComparedIsBadInputAndSaysWhy) {
    const auto refused = [&](const std::vector<std::string>& words) {
        const Result result = runProgram(words);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
        return result.err;
    };
    const std::string all = scratch.file("all.yaml", "channels: [{channel: '*', ignore: true}]\n");
    EXPECT_EQ(refused({"compare", reference, reference, "--tolerances", all}),
              "tread compare: nothing was compared: found that the tolerances ignore all channels in common (4), "
              "expected at least one to compare\n");
    const std::string foreign = scratch.file("foreign.csv", "time [s],a [m]\n0,1\n1,2\n2,3\n");
    EXPECT_NE(refused({"compare", reference, foreign}).find("found no channel in common"), std::string::npos);
    EXPECT_NE(refused({"compare", foreign, reference, "--json"}).find("found no channel in common"), std::string::npos);
    const std::string time = scratch.file("time.csv", "time [s]\n0\n1\n2\n");
    EXPECT_NE(refused({"compare", time, time}).find("no channel but time"), std::string::npos);
}

TEST_F(Compare, TolerancesTakeUnits) {
    const auto with = [&](const std::string& absolute) {
        const std::string file = scratch.file(
            "units.yaml",
            "channels:\n  - {channel: chassis.ay, ignore: true}\n  - {channel: chassis.yaw_rate, absolute: " +
                absolute + ", relative: 0}\n");
        return runProgram({"compare", reference, other, "--tolerances", file});
    };
    // The yaw rates differ by a tenth of 0.2 rad/s: 1.146 deg/s.
    EXPECT_EQ(with("1.2 deg/s").status, 0);
    EXPECT_EQ(with("1.1 deg/s").status, 1);
    const Result wrong = with("5 mm");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(
        wrong.err.find(scratch.path("units.yaml") + ":3:43: channels.1.absolute: found a length (\"mm\"), expected "
                                                    "rad/s"),
        0u)
        << wrong.err;
}

}  // namespace
}  // namespace tread::compare_test
