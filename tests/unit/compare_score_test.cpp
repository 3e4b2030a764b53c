#include "compare/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace tread::compare_score_test {
namespace {

using Curve1 = std::vector<double>;

constexpr int kSamples = 1000;

// A bell that is flat at both ends, `late` samples late.
Curve1 bell(double height = 1, int late = 0) {
    Curve1 curve;
    for (int i = 0; i < kSamples; ++i) {
        const double x = (i - 500 - late) / 60.0;
        curve.push_back(height * std::exp(-x * x));
    }
    return curve;
}

Curve1 line(double slope) {
    Curve1 curve;
    for (int i = 0; i < kSamples; ++i) curve.push_back(slope * (i + 1) / kSamples);
    return curve;
}

void expectScore(const Score& found, double corridor, double phase, double magnitude, double slope, double tolerance) {
    EXPECT_NEAR(found.corridor, corridor, tolerance);
    EXPECT_NEAR(found.phase, phase, tolerance);
    EXPECT_NEAR(found.magnitude, magnitude, tolerance);
    EXPECT_NEAR(found.slope, slope, tolerance);
    EXPECT_NEAR(found.total, 0.4 * corridor + 0.2 * (phase + magnitude + slope), tolerance);
}

TEST(Score, OfEqualCurvesIsOne) {
    expectScore(score(bell(), bell()), 1, 1, 1, 1, 0);
    expectScore(score(line(0), line(0)), 1, 1, 1, 1, 0);
}

// (0.2 * 1000 - 50) / (0.2 * 1000) and nothing else but the corridor: the rest is taken after the shift.
TEST(Score, OfAPureShiftLosesPhaseInProportion) {
    for (const int late : {50, -50, 20}) {
        const Score found = score(bell(), bell(1, late));
        EXPECT_EQ(found.shift, late);
        EXPECT_NEAR(found.phase, (200 - std::abs(late)) / 200.0, 1e-12);
        EXPECT_NEAR(found.magnitude, 1, 1e-9);
        EXPECT_NEAR(found.slope, 1, 1e-9);
        EXPECT_LT(found.corridor, 1);
    }
}

// Constants s apart: every sample scores ((0.5 - s) / 0.45)^2, every path of warping has the error s.
TEST(Score, OfAConstantTooHighIsTheClosedForm) {
    for (const double away : {0.03, 0.1, 0.3, 0.49}) {
        const double corridor = away <= 0.05 ? 1 : std::pow((0.5 - away) / 0.45, 2);
        expectScore(score(Curve1(kSamples, 2.0), Curve1(kSamples, 2 * (1 + away))), corridor, 1, (0.5 - away) / 0.5, 1,
                    1e-9);
    }
    const Score far = score(Curve1(kSamples, 2.0), Curve1(kSamples, 3.2));
    EXPECT_EQ(far.corridor, 0);
    EXPECT_EQ(far.magnitude, 0);
}

// A line 1.4 times as steep: slope error 0.4 of 2; the corridor score is the integral of ((0.5 - 0.4 x) / 0.45)^2 from
// the x = 0.125 at which the inner corridor is left, and 1 before.
TEST(Score, OfAPureScaleLosesSlopeInProportion) {
    const Score found = score(line(1), line(1.4));
    EXPECT_EQ(found.shift, 0);
    EXPECT_NEAR(found.slope, (2 - 0.4) / 2, 1e-9);
    const auto integral = [](double x) { return -std::pow(0.5 - 0.4 * x, 3) / (3 * 0.4 * 0.45 * 0.45); };
    EXPECT_NEAR(found.corridor, 0.125 + integral(1) - integral(0.125), 2e-3);
    EXPECT_NEAR(score(bell(), bell(1.4)).slope, (2 - 0.4) / 2, 1e-9);
}

TEST(Score, OfNothingAgainstSomethingIsPoor) {
    const Score found = score(line(0), bell());
    EXPECT_EQ(found.magnitude, 0);
    EXPECT_EQ(found.slope, 0);
    EXPECT_LT(found.total, 0.58);
}

// Warping takes out what one part of the curve is late by, within its window; the phase cannot.
TEST(Score, WarpingFollowsALocalDelay) {
    Curve1 late;
    for (int i = 0; i < kSamples; ++i) {
        const double x = (i - 500 - 20 * std::sin(i * 0.0062831853)) / 60.0;
        late.push_back(std::exp(-x * x));
    }
    ScoreParams narrow;
    narrow.warping_window = 0;
    EXPECT_GT(score(bell(), late).magnitude, 0.98) << "the samples of the two do not coincide";
    EXPECT_LT(score(bell(), late, narrow).magnitude, 0.9);
}

TEST(Score, HasWordsForItsGrades) {
    EXPECT_EQ(gradeOf(0.95), "excellent");
    EXPECT_EQ(gradeOf(0.94), "good");
    EXPECT_EQ(gradeOf(0.8), "fair");
    EXPECT_EQ(gradeOf(0.58), "poor");
}

Log logOf(const Curve1& yaw_rate, double step = 0.01) {
    Log log{{{"time", "s", {}}, {"chassis.yaw_rate", "rad/s", yaw_rate}, {"chassis.vx", "m/s", yaw_rate}}};
    for (std::size_t i = 0; i < yaw_rate.size(); ++i) log.channels[0].values.push_back(step * static_cast<double>(i));
    return log;
}

TEST(ScoreLogs, JudgesTheChosenChannelsOfEveryMeasurement) {
    const std::vector<NamedLog> measured{{"a.csv", logOf(bell())}, {"b.csv", logOf(bell(1, 10))}};
    const Scores same = scoreLogs(measured, logOf(bell()), {});
    ASSERT_EQ(same.channels.size(), 2u) << "vx is not among the channels";
    EXPECT_TRUE(same.passed);
    EXPECT_NEAR(same.channels[1].shift, -0.1, 1e-9) << "early against b";
    EXPECT_EQ(text(same).find("Good agreement: lowest ISO 18571 score 0."), 0u) << text(same);

    const Scores wrong = scoreLogs(measured, logOf(bell(-1)), {});
    EXPECT_FALSE(wrong.passed);
    EXPECT_EQ(text(wrong).find("Poor agreement: lowest ISO 18571 score"), 0u) << text(wrong);
    EXPECT_EQ(json(wrong)["channels"][0]["channel"], "chassis.yaw_rate");
}

TEST(ScoreLogs, SaysWhatItCouldNotScore) {
    Log other = logOf(bell());
    other.channels[1].unit = "deg/s";
    const Scores units = scoreLogs({{"a.csv", logOf(bell())}}, other, {});
    EXPECT_FALSE(units.passed);
    EXPECT_EQ(units.notes.at(0), "chassis.yaw_rate of a.csv was not scored: its unit is deg/s in the simulation.");
    Log later = logOf(bell());
    for (double& t : later.channels[0].values) t += 100;
    EXPECT_EQ(scoreLogs({{"a.csv", logOf(bell())}}, later, {}).notes.at(0),
              "The simulation and a.csv have fewer than ten samples in common.");
}

}  // namespace
}  // namespace tread::compare_score_test
