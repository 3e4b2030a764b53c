#include "compare/compare.h"
#include "base/text/pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compare/time_shift.h"

namespace tread::compare_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Signal {
    std::string name, unit;
    std::function<double(double)> value;
};

Log sampled(double rate, double from, double to, const std::vector<Signal>& signals) {
    Log log{{{"time", "s", {}}}};
    for (const Signal& signal : signals) log.channels.push_back({signal.name, signal.unit, {}});
    const auto count = static_cast<int>(std::lround((to - from) * rate)) + 1;
    for (int i = 0; i < count; ++i) {
        const double t = from + i / rate;
        log.channels[0].values.push_back(t);
        for (std::size_t s = 0; s < signals.size(); ++s) log.channels[s + 1].values.push_back(signals[s].value(t));
    }
    return log;
}

double yawRate(double t) {
    return 0.3 * std::sin(2 * t) * std::exp(-0.1 * t);
}
const Signal kYawRate{"chassis.yaw_rate", "rad/s", yawRate};
const Signal kLateral{"chassis.ay", "m/s2", [](double t) { return 5 * std::sin(t); }};

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

Tolerances only(double absolute, double relative) {
    Tolerances tolerances;
    tolerances.units.clear();
    tolerances.relative = relative;
    tolerances.channels = {{"*", absolute, relative, false}};
    return tolerances;
}

// ---- Tolerances ----------------------------------------------------------------------------------------------------

TEST(Compare, PatternsMatchWholeNamesWithStars) {
    EXPECT_TRUE(matches("wheel.*.load", "wheel.front_left.load"));
    EXPECT_FALSE(matches("wheel.*.load", "wheel.front_left.loads"));
    EXPECT_FALSE(matches("wheel.*.load", "my.wheel.front_left.load"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("*a*b*", "xxaxxaxbx"));
    EXPECT_FALSE(matches("*a*b", "xxaxxbc"));
    EXPECT_FALSE(matches("a", ""));
    EXPECT_TRUE(matches("chassis.ay", "chassis.ay"));
}

TEST(Compare, TheLastFittingPatternCountsAndFallsBackToUnitAndFile) {
    Tolerances tolerances;
    tolerances.relative = 0.25;
    tolerances.units = {{"N", 7}};
    tolerances.channels = {{"wheel.*", 1.0, 0.5, true}, {"wheel.*.load", {}, 0.75, false}};
    const auto load = allowedDifference(tolerances, {"wheel.a.load", "N", {}});
    EXPECT_EQ(load.absolute, 7);
    EXPECT_EQ(load.relative, 0.75);
    EXPECT_FALSE(load.ignore);
    EXPECT_TRUE(allowedDifference(tolerances, {"wheel.a.fx", "N", {}}).ignore);
    EXPECT_EQ(allowedDifference(tolerances, {"chassis.x", "m", {}}).relative, 0.25);
    EXPECT_EQ(allowedDifference(tolerances, {"chassis.x", "m", {}}).absolute, 0);
}

TEST(Compare, ADifferenceOfExactlyTheToleranceIsAllowedAndOneStepMoreIsNot) {
    const auto constant = [](double value) {
        return sampled(10, 0, 1, {{"a", "m", [value](double) { return value; }}});
    };
    EXPECT_TRUE(compare(constant(8), constant(8.5), only(0.25, 0.03125)).same) << "0.25 + 8 / 32 = 0.5";
    EXPECT_FALSE(compare(constant(8), constant(std::nextafter(8.5, 9)), only(0.25, 0.03125)).same);
    EXPECT_FALSE(compare(constant(8), constant(std::nextafter(7.5, 7)), only(0.25, 0.03125)).same);
}

// ---- What is found -------------------------------------------------------------------------------------------------

TEST(Compare, ALogIsTheSameAsItself) {
    const Log log = sampled(100, 0, 5, {kYawRate, kLateral});
    const Comparison result = compare(log, log);
    EXPECT_TRUE(result.same);
    EXPECT_EQ(firstLine(text(result)), "Same, to the last digit: 2 channels");
}

TEST(Compare, LargestRmsAndFirstDifferenceAreThoseThatWereMade) {
    const Log reference = sampled(100, 0, 10, {kLateral, kYawRate});
    Log candidate = reference;
    // A bump of 1 from sample 300 on, of 2 at sample 700 only.
    for (std::size_t i = 300; i < 1001; ++i) candidate.channels[1].values[i] += i == 700 ? 2 : 1;
    const Comparison result = compare(reference, candidate, only(0.5, 0));
    ASSERT_EQ(result.channels.size(), 2u);
    const ChannelComparison& lateral = result.channels[0];
    EXPECT_FALSE(result.same);
    EXPECT_EQ(result.differing(), 1u);
    EXPECT_DOUBLE_EQ(lateral.largest, 2);
    EXPECT_DOUBLE_EQ(lateral.largest_time, 7);
    EXPECT_NEAR(lateral.rms, std::sqrt((700 * 1.0 + 4.0) / 1001), 1e-12);
    ASSERT_TRUE(lateral.first);
    EXPECT_DOUBLE_EQ(lateral.first->time, 3);
    EXPECT_DOUBLE_EQ(lateral.first->candidate - lateral.first->reference, 1);
    EXPECT_EQ(firstLine(text(result)),
              "Different: 1 of 2 channels; first at t = 3 s, chassis.ay 1.7056 instead of 0.7056 m/s2");
}

TEST(Compare, RSquaredIsTheShareOfTheVarianceThatIsExplained) {
    // Over whole periods a sine has the variance 1/2, and 0.9 of it leaves 0.1^2 / 2, an offset of 0.2 leaves 0.04.
    const auto sine = [](double gain, double offset) {
        const auto value = [=](double t) { return 100 + offset + gain * std::sin(std::numbers::pi / 2 * (t + 0.005)); };
        return sampled(100, 0, 3.99, {{"chassis.ay", "m/s2", value}});
    };
    EXPECT_NEAR(compare(sine(1, 0), sine(0.9, 0)).channels[0].r_squared.value(), 0.99, 1e-9);
    EXPECT_NEAR(compare(sine(1, 0), sine(1, 0.2)).channels[0].r_squared.value(), 1 - 0.04 / 0.5, 1e-9);
    EXPECT_DOUBLE_EQ(compare(sine(1, 0), sine(1, 0)).channels[0].r_squared.value(), 1);
    EXPECT_FALSE(compare(sine(0, 0), sine(1, 0)).channels[0].r_squared) << "nothing varies that could be explained";
    EXPECT_FALSE(compare(sine(0, 0), sine(1, 0)).channels[0].no_fit);
}

// An offset of 50 standard deviations: the formula would give -2499.
TEST(Compare, ACandidateWorseThanTheMeanOfTheReferenceIsNoFit) {
    const auto sine = [](double offset) {
        const auto value = [=](double t) { return offset + std::sin(std::numbers::pi / 2 * (t + 0.005)); };
        return sampled(100, 0, 3.99, {{"chassis.ay", "-", value}});
    };
    const Comparison result = compare(sine(0), sine(50 * std::sqrt(0.5)));
    EXPECT_TRUE(result.channels[0].no_fit);
    EXPECT_FALSE(result.channels[0].r_squared);
    EXPECT_NE(text(result).find("  no-fit  "), std::string::npos) << text(result);
    EXPECT_NE(text(result).find("no fit: the mean of the reference is closer"), std::string::npos);
    EXPECT_EQ(json(result)["channels"][0]["no_fit"], true);
    EXPECT_TRUE(json(result)["channels"][0]["r_squared"].is_null());
    EXPECT_FALSE(firstLine(text(result)).ends_with(" -")) << "a pure number has no unit in a sentence";
}

TEST(Compare, AnotherSamplingRateIsTheSameUpToInterpolation) {
    const Log slow = sampled(100, 0, 10, {kLateral});
    const Log fast = sampled(999, 0, 10, {kLateral});
    // Linear interpolation is off by at most h^2 / 8 max |f''|.
    EXPECT_LT(compare(slow, fast).channels[0].largest, 5 * std::pow(1.0 / 999, 2) / 8 * 1.0001);
    EXPECT_LT(compare(fast, slow).channels[0].largest, 5 * std::pow(0.01, 2) / 8 * 1.0001);
    EXPECT_GT(compare(fast, slow).channels[0].largest, 0);
}

TEST(Compare, MissingChannelsAreADifferenceExtraOnesAreNot) {
    const Log both = sampled(100, 0, 1, {kYawRate, kLateral}), one = sampled(100, 0, 1, {kYawRate});
    const Comparison lost = compare(both, one), gained = compare(one, both);
    EXPECT_FALSE(lost.same);
    EXPECT_EQ(lost.missing, std::vector<std::string>{"chassis.ay"});
    EXPECT_EQ(firstLine(text(lost)), "Different: 1 channel missing (chassis.ay)");
    EXPECT_TRUE(gained.same);
    EXPECT_EQ(gained.extra, std::vector<std::string>{"chassis.ay"});
    Tolerances tolerances;
    tolerances.channels = {{"chassis.ay", {}, {}, true}};
    EXPECT_TRUE(compare(both, one, tolerances).same) << "ignored channels may be missing";
}

TEST(Compare, AnotherUnitIsADifference) {
    const Log reference = sampled(100, 0, 1, {kYawRate});
    Log candidate = reference;
    candidate.channels[1].unit = "deg/s";
    const Comparison result = compare(reference, candidate);
    EXPECT_FALSE(result.same);
    EXPECT_EQ(firstLine(text(result)),
              "Different: chassis.yaw_rate is in rad/s in the reference, but in deg/s in the candidate.");
}

TEST(Compare, ANaNInOneLogIsADifferenceInBothItIsNot) {
    const Log reference = sampled(100, 0, 1, {kYawRate});
    Log candidate = reference;
    candidate.channels[1].values[50] = kNan;
    for (const auto& result : {compare(reference, candidate), compare(candidate, reference)}) {
        EXPECT_FALSE(result.same);
        ASSERT_TRUE(result.channels[0].first);
        EXPECT_DOUBLE_EQ(result.channels[0].first->time, 0.5);
        EXPECT_EQ(result.channels[0].reference_not_finite + result.channels[0].candidate_not_finite, 1u);
        EXPECT_NE(text(result).find("not finite: "), std::string::npos);
        EXPECT_TRUE(json(result)["channels"][0]["largest_difference"].is_number_float());
        EXPECT_NO_THROW(json(result).dump());
    }
    EXPECT_TRUE(compare(candidate, candidate).same);
}

TEST(Compare, ALogThatEndsEarlyIsADifference) {
    const Log whole = sampled(100, 0, 10, {kYawRate}), cut = sampled(100, 0, 4, {kYawRate});
    const Comparison result = compare(whole, cut);
    EXPECT_FALSE(result.same);
    EXPECT_EQ(result.differing(), 0u);
    EXPECT_EQ(firstLine(text(result)), "Different: The candidate ends 6 s early (at 4 s).");
    EXPECT_FALSE(compare(cut, whole).same);
    Tolerances tolerances;
    tolerances.time_span = 6.5;
    EXPECT_TRUE(compare(whole, cut, tolerances).same);
    EXPECT_FALSE(compare(whole, sampled(100, 20, 30, {kYawRate}), tolerances).same) << "no common time";
}

TEST(Compare, AHeadingThatWrapsIsComparedAsAnAngle) {
    const auto heading = [](double offset) {
        return Signal{"chassis.yaw", "rad",
                      [offset](double t) { return std::remainder(t + offset, 2 * std::numbers::pi); }};
    };
    const Log reference = sampled(100, 0, 20, {heading(0)});
    const Comparison near = compare(reference, sampled(100, 0, 20, {heading(0.003)}), only(0.01, 0));
    EXPECT_TRUE(near.same);
    EXPECT_NEAR(near.channels[0].largest, 0.003, 1e-9);
    EXPECT_NEAR(compare(reference, sampled(130, 0, 20, {heading(0)})).channels[0].largest, 0, 1e-9);
    EXPECT_FALSE(compare(reference, sampled(100, 0, 20, {heading(0.02)}), only(0.01, 0)).same);
}

TEST(Compare, AnEmptyLogIsADifference) {
    const Log log = sampled(100, 0, 1, {kYawRate});
    EXPECT_FALSE(compare(log, Log{}).same);
    EXPECT_FALSE(compare(Log{}, log).same);
}

// ---- Time shift ----------------------------------------------------------------------------------------------------

TEST(Compare, AKnownDelayIsFoundToAFractionOfASample) {
    for (const double delay : {0.0, 0.0137, -0.0437, 0.2}) {
        const Log reference = sampled(100, 0, 10, {kYawRate});
        const Log late =
            sampled(250, 0, 10, {{"chassis.yaw_rate", "rad/s", [=](double t) { return yawRate(t - delay); }}});
        const auto found = estimateTimeShift(reference, late, "chassis.yaw_rate", 0.5);
        ASSERT_TRUE(found) << delay;
        EXPECT_NEAR(*found, delay, 1e-4);
    }
}

TEST(Compare, TheDelayIsTakenOutOnlyWhenAskedFor) {
    const Log reference = sampled(100, 0, 10, {kYawRate, kLateral});
    const Log late = sampled(100, 0.03, 10.03,
                             {{"chassis.yaw_rate", "rad/s", [](double t) { return yawRate(t - 0.03); }},
                              {"chassis.ay", "m/s2", [](double t) { return 5 * std::sin(t - 0.03); }}});
    EXPECT_FALSE(compare(reference, late).same);
    Tolerances tolerances;
    tolerances.time_shift_max = 0.2;
    const Comparison result = compare(reference, late, tolerances);
    EXPECT_TRUE(result.same) << text(result);
    EXPECT_NEAR(result.time_shift, 0.03, 1e-4);
    EXPECT_NE(text(result).find("The candidate is 0.03 s late (chassis.yaw_rate)"), std::string::npos) << text(result);
}

TEST(Compare, WithoutAClearPeakNoDelayIsClaimed) {
    const Log constant = sampled(100, 0, 10, {{"chassis.yaw_rate", "rad/s", [](double) { return 1.0; }}});
    EXPECT_FALSE(estimateTimeShift(constant, constant, "chassis.yaw_rate", 0.5));
    const Log log = sampled(100, 0, 10, {kYawRate});
    EXPECT_FALSE(estimateTimeShift(log, log, "no.such.channel", 0.5));
    EXPECT_FALSE(estimateTimeShift(log, log, "chassis.yaw_rate", 6)) << "more shift than common time";
    const Log far = sampled(100, 0, 10, {{"chassis.yaw_rate", "rad/s", [](double t) { return yawRate(t - 0.6); }}});
    EXPECT_FALSE(estimateTimeShift(log, far, "chassis.yaw_rate", 0.3)) << "the peak is beyond the limit";
    Tolerances tolerances;
    tolerances.time_shift_max = 0.5;
    EXPECT_NE(text(compare(constant, constant, tolerances)).find("No time shift within 0.5 s"), std::string::npos);
}

// ---- Rendering -----------------------------------------------------------------------------------------------------

TEST(Compare, TheFirstLineSaysHowCloseTheWorstChannelIs) {
    const Log reference = sampled(100, 0, std::numbers::pi, {kYawRate, kLateral});
    Log candidate = reference;
    for (double& value : candidate.channels[2].values) value += 0.015;
    EXPECT_EQ(firstLine(text(compare(reference, candidate))),
              "Same within tolerance: 2 channels, largest difference 0.3 % of peak (chassis.ay)");
}

TEST(Compare, TheTableShowsTheWorstChannelsOnly) {
    std::vector<Signal> many, other;
    for (int i = 0; i < 12; ++i) {
        const std::string name = std::string("a").append(std::to_string(i));
        many.push_back({name, "m", [](double) { return 0.0; }});
        other.push_back({name, "m", [i](double) { return 0.001 * i; }});
    }
    const std::string out = text(compare(sampled(10, 0, 1, many), sampled(10, 0, 1, other)), 3);
    EXPECT_NE(out.find("\na11 "), std::string::npos) << out;
    EXPECT_NE(out.find("\na9 "), std::string::npos);
    EXPECT_EQ(out.find("\na8 "), std::string::npos);
    EXPECT_NE(out.find("and 9 more"), std::string::npos);
}

TEST(Compare, ATolerancePatternThatFitsNothingIsNamed) {
    Tolerances tolerances;
    tolerances.channels = {{"wheel.*.lod", 1.0, {}, false}};
    const Log log = sampled(100, 0, 1, {kYawRate});
    EXPECT_NE(text(compare(log, log, tolerances)).find("'wheel.*.lod' matches no channel"), std::string::npos);
}

TEST(Compare, JsonCarriesTheVerdictAndTheFirstDifference) {
    const Log reference = sampled(100, 0, 1, {kLateral});
    Log candidate = reference;
    candidate.channels[1].values[20] += 1;
    const nlohmann::json out = json(compare(reference, candidate));
    EXPECT_EQ(out["same"], false);
    EXPECT_EQ(out["differing"], 1);
    EXPECT_EQ(out["channels"][0]["channel"], "chassis.ay");
    EXPECT_NEAR(out["channels"][0]["first_difference"]["time"].get<double>(), 0.2, 1e-12);
    EXPECT_NEAR(out["channels"][0]["largest_difference"].get<double>(), 1.0, 1e-12);
}

}  // namespace
}  // namespace tread::compare_test
