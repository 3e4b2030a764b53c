#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <vector>

#include "base/text/did_you_mean.h"
#include "cli/logs.h"
#include "cli/program.h"
#include "metrics/metrics.h"

namespace tread::metrics_test {
namespace {

using Json = nlohmann::json;

struct Metrics : testing::Test {
    Metrics() { writeLog(log, cli::stepSteer()); }
    Scratch scratch;
    std::string log = scratch.path("log.csv");
};

Json metric(const Json& result, const std::string& name) {
    for (const Json& candidate : result["metrics"]) {
        if (candidate["name"] == name) return candidate;
    }
    return nullptr;
}

TEST_F(Metrics, NamesTheManoeuvreThenEveryMetricWithUnitAndDefinition) {
    const Result result = runProgram({"metrics", log});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(firstLine(result.out).find("step_steer: "), 0u) << result.out;
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("from half the steering input to 90 % of the steady yaw rate"), std::string::npos);
    EXPECT_EQ(runProgram({"metrics", log, "--manoeuvre", "step_steer"}).out, result.out);
}

TEST_F(Metrics, JsonHasTheValuesOfTheClosedFormInTheUnitsOfTheirDefinitions) {
    const Result result = runProgram({"metrics", log, "--json"});
    EXPECT_EQ(result.status, 0);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["manoeuvre"], "step_steer");
    EXPECT_EQ(json["detected"], true);
    EXPECT_NEAR(metric(json, "yaw_rate_response_time")["value"].get<double>(), cli::yawResponseTime(), 2e-3);
    EXPECT_NEAR(metric(json, "yaw_rate_gain")["value"].get<double>(), cli::kYawGain, 1e-3 * cli::kYawGain);
    const Json amplitude = metric(json, "steering_amplitude");
    EXPECT_EQ(amplitude["unit"], "deg");
    EXPECT_NEAR(amplitude["value"].get<double>(), cli::kStepAngle * 180 / std::numbers::pi, 1e-3);
    for (const Json& each : json["metrics"]) {
        EXPECT_FALSE(each["unit"].get<std::string>().empty()) << each;
        EXPECT_FALSE(each["definition"].get<std::string>().empty()) << each;
    }
    EXPECT_EQ(metric(json, "roll_gradient")["value"], nullptr) << "the log has no roll angle";
}

TEST_F(Metrics, UnknownManoeuvreIsAnsweredWithASuggestionAndTheList) {
    const Result result = runProgram({"metrics", log, "--manoeuvre", "stp_steer"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    std::vector<std::string_view> names;
    for (const Manoeuvre& known : manoeuvres()) names.push_back(known.name);
    EXPECT_EQ(result.err,
              "tread: there is no manoeuvre \"stp_steer\", only " + listed(names) + "; did you mean \"step_steer\"?\n");
}

TEST_F(Metrics, LogWithoutTheManoeuvreSaysWhatWasLookedFor) {
    const Result result = runProgram({"metrics", log, "--manoeuvre", "straight_braking"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              log + ": no straight_braking in this log: it needs driver.brake, which the log does not have\n");

    Log quiet = cli::stepSteer();
    quiet.channels.resize(2);
    writeLog(log, quiet);
    const Result none = runProgram({"metrics", log});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err.find(log + ": the log contains none of the known manoeuvres"), 0u) << none.err;
}

TEST_F(Metrics, KnownColumnInAnotherUnitIsRefused) {
    std::string text = contentOf(log);
    text.replace(text.find("chassis.vx [m/s]"), 16, "chassis.vx [km/h]");
    const std::string foreign = scratch.file("foreign.csv", "# a comment\n" + text);
    const Result result = runProgram({"metrics", foreign});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              foreign +
                  ":2:44: chassis.vx: found the unit \"km/h\", expected \"m/s\"; convert the column or give "
                  "it another name\n");
}

TEST_F(Metrics, UnreadableLogIsOneSentence) {
    const Result result = runProgram({"metrics", scratch.path("none.csv")});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "tread: cannot read '" + scratch.path("none.csv") + "': No such file or directory\n");
}

}  // namespace
}  // namespace tread::metrics_test
