// What a good `tread run` leaves and says, and that it answers the same every time.

#include <sched.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/tread_run.h"
#include "log/csv.h"

namespace tread::run_test {
namespace {

TEST_F(TreadRun, WritesLogInputsMetricsAndReport) {
    car();
    scenario();
    const Result result = run();
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(results(), kAllResults);
    EXPECT_EQ(result.out,
              "A short way, compact front-drive hatchback: drove 0.2 s\nReport: " + out("report.html") + "\n");
    EXPECT_EQ(readLog(out("log.csv")).samples(), 21u);
}

TEST_F(TreadRun, JsonIsAllThatItPrints) {
    car();
    scenario();
    const Result result = run({"--json"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["answer"], "A short way, compact front-drive hatchback: drove 0.2 s");
    EXPECT_EQ(json, nlohmann::json::parse(contentOf(out("metrics.json"))));
}

TEST_F(TreadRun, JsonOfAFailureIsNoHalfAnswer) {
    car();
    scenario();
    const Result result = run({"--json", "--set", "scenario.start.speed=250 km/h"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
}

TEST_F(TreadRun, WarningsGoToStandardErrorAndIntoTheResults) {
    car();
    scenario("manoeuvre: step_steer\n" + kScenario);
    const Result result = run({"--json"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err.rfind("warning: no metrics of step_steer: ", 0), 0u) << result.err;
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_EQ("warning: " + json["warnings"][0].get<std::string>() + "\n", result.err);
    EXPECT_TRUE(json["metrics"].empty());
}

TEST_F(TreadRun, SameRunGivesTheSameBytesOnEveryProcessor) {
    car();
    scenario(
        "title: step\nstart: {speed: 80 km/h}\nphases:\n"
        "  - {steering: {ramp: {to: 60 deg, rate: 500 deg/s}}, until: {duration: 1 s}}\n");
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    ASSERT_EQ(run().status, 0);
    const std::string first = contentOf(out("log.csv"));
    ASSERT_GT(first.size(), 10'000u);
    ASSERT_EQ(run().status, 0);
    EXPECT_EQ(contentOf(out("log.csv")), first);

    int pinned = 0;
    for (int processor = 0; processor < CPU_SETSIZE && pinned < 2; ++processor) {
        if (!CPU_ISSET(processor, &allowed)) continue;
        ++pinned;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(processor, &one);
        ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
        const int status = run().status;
        ASSERT_EQ(sched_setaffinity(0, sizeof allowed, &allowed), 0);
        EXPECT_EQ(status, 0);
        EXPECT_EQ(contentOf(out("log.csv")), first) << "processor " << processor;
    }
    EXPECT_GE(pinned, 1);
}

// The lines of a top-level key, less their indentation.
std::string sectionOf(const std::string& yaml, const std::string& key) {
    std::istringstream lines(yaml);
    std::string line, section;
    bool inside = false;
    while (std::getline(lines, line)) {
        if (!line.empty() && line.front() != ' ') inside = line == key + ":";
        else if (inside) section += (line.size() > 2 ? line.substr(2) : "") + "\n";
    }
    return section;
}

TEST_F(TreadRun, ResolvedInputsGiveTheSameRunAgain) {
    car();
    scenario(
        "title: step\nstart: {speed: 80 km/h}\nphases:\n  - {throttle: {hold_speed: {}}, until: {duration: 0.1 s}}\n"
        "  - {steering: {ramp: {to: 60 deg, rate: 500 deg/s}}, until: {duration: 0.3 s}}\n");
    ASSERT_EQ(run({"--set", "mass=1401.7", "--set", "front.tyre.lambda.mux=0.93"}).status, 0);
    const std::string first = contentOf(out("log.csv"));
    const std::string resolved = contentOf(out("run.yaml"));

    car(sectionOf(resolved, "vehicle"));
    scenario(sectionOf(resolved, "scenario"));
    const Result again = run();
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(contentOf(out("log.csv")), first);
    EXPECT_EQ(contentOf(out("run.yaml")), resolved);
}

// ---- The first line of the answer ----------------------------------------------------------------------------------

// Words with # for every number; a number that ends in useless zeros stays.
std::string withoutNumbers(const std::string& text) {
    std::istringstream words(text);
    std::string word, result;
    while (words >> word) {
        const std::string comma = word.ends_with(',') ? "," : "";
        const std::string number = word.substr(0, word.size() - comma.size());
        const bool is_number = number.find_first_not_of("-0123456789.") == std::string::npos;
        const bool is_short = number.find('.') == std::string::npos || !number.ends_with('0');
        result += (result.empty() ? "" : " ") + (is_number && is_short ? "#" + comma : word);
    }
    return result;
}

// The scenario files with the compact car. How many digits are right is for other tests; here the words count.
struct Answer {
    std::string scenario;
    std::string words;  // # stands for a number
};
// What gtest and ctest show of a parameter.
std::ostream& operator<<(std::ostream& out, const Answer& answer) {
    return out << answer.scenario;
}
class TreadRunAnswer : public TreadRun, public testing::WithParamInterface<Answer> {};

TEST_P(TreadRunAnswer, FirstLineTellsTheManoeuvreInWords) {
    const Result result = runProgram({"run", kSource + "/vehicles/compact.yaml",
                                      kSource + "/scenarios/" + GetParam().scenario + ".yaml", "-o", out()});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::string answer = firstLine(result.out);
    const std::string words = answer.substr(answer.rfind(": ") + 2);
    EXPECT_EQ(withoutNumbers(words), GetParam().words) << answer;
}

INSTANTIATE_TEST_SUITE_P(
    Of, TreadRunAnswer,
    testing::Values(
        Answer{"drop_and_settle", "settles within # s, bounces at # Hz, damping ratio #"},
        Answer{"straight_braking_100_part",
               "stops within # m, mean fully developed deceleration # m/s2, front left wheel locked for # % "
               "of the time"},
        Answer{"step_steer_80",
               "yaw rate responds within # ms, overshoots by # %, settles at # m/s2 of lateral acceleration"},
        Answer{"sine_steer", "yaw rate gain # 1/s, yaw rate lags by # deg, lateral acceleration by # deg"},
        Answer{"steady_circle",
               "understeer gradient # deg/g, roll gradient # deg/g, up to # m/s2 of lateral acceleration"},
        Answer{"coast_down", "coasts for # s, rolls # m, rolling resistance coefficient #"},
        Answer{"parked_on_slope", "creeps by # mm in a minute, moves by at most # mm, turns by # deg in a minute"}),
    [](const auto& answer) { return answer.param.scenario; });

}  // namespace
}  // namespace tread::run_test
