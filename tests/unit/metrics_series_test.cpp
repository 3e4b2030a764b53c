#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "log/resample.h"
#include "metrics/series.h"
#include "metrics/smoothing.h"

namespace tread::metrics_series_test {
namespace {

TimeSeries sampled(double rate, double duration, double (*f)(double)) {
    TimeSeries out;
    for (int i = 0; i <= std::lround(duration * rate); ++i) {
        out.time.push_back(i / rate);
        out.value.push_back(f(i / rate));
    }
    return out;
}

TEST(TimeSeries, ValuesBetweenSamplesAreLinearAndNothingIsInventedOutside) {
    const std::vector<double> time{0, 1, 3}, values{0, 2, std::nan("")};
    EXPECT_DOUBLE_EQ(valueAt(time, values, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(valueAt(time, values, 1), 2) << "a neighbour that is not finite does not spread to a sample";
    EXPECT_TRUE(std::isnan(valueAt(time, values, 1.5)));
    EXPECT_TRUE(std::isnan(valueAt(time, values, -0.1)));
    EXPECT_TRUE(std::isnan(valueAt(time, values, 3.1)));
    const auto all = resample(time, values, std::vector{-1.0, 0.0, 0.5, 1.0, 4.0});
    EXPECT_TRUE(std::isnan(all[0]) && std::isnan(all[4]));
    EXPECT_DOUBLE_EQ(all[2], 1);
}

TEST(TimeSeries, TheIntegralOfAPiecewiseLinearSeriesIsExactBetweenAnyTimes) {
    const TimeSeries v{{0, 1, 4}, {0, 2, 2}};
    EXPECT_DOUBLE_EQ(integral(v, 0, 4), 1 + 6);
    EXPECT_DOUBLE_EQ(integral(v, 0.5, 2.5), 0.75 + 3);
    EXPECT_DOUBLE_EQ(mean(v, 0.5, 2.5), 3.75 / 2);
    EXPECT_DOUBLE_EQ(mean(v, 0.5, 0.5), 1);
    EXPECT_DOUBLE_EQ(integral(part(v, 0.5, 2.5), 0.5, 2.5), 3.75);
}

TEST(TimeSeries, CrossingsAreFoundFromEitherSideAndAtSamples) {
    const TimeSeries v{{0, 1, 2, 3, 4}, {0, 2, 0, 2, 2}};
    EXPECT_DOUBLE_EQ(*firstCrossing(v, 1, 0), 0.5);
    EXPECT_DOUBLE_EQ(*firstCrossing(v, 1, 0.6), 1.5);
    EXPECT_DOUBLE_EQ(*firstCrossing(v, 2, 0), 1);
    EXPECT_DOUBLE_EQ(*lastCrossing(v, 1, 0, 4), 2.5);
    EXPECT_DOUBLE_EQ(*lastCrossing(v, 1, 0, 2), 1.5);
    EXPECT_FALSE(firstCrossing(v, 3, 0));
    EXPECT_FALSE(firstCrossing(v, 1, 2.6));
    EXPECT_FALSE(firstCrossing(v, 1, 0, 0.4));
}

TEST(TimeSeries, TheParabolaFindsAPeakBetweenSamples) {
    const TimeSeries v = sampled(50, 1, [](double t) { return 3 - 4 * (t - 0.513) * (t - 0.513); });
    EXPECT_NEAR(highest(v, 0, 1).time, 0.513, 1e-12);
    EXPECT_NEAR(highest(v, 0, 1).value, 3, 1e-12);
    EXPECT_NEAR(lowest(increments(v, 0, -1), 0, 1).value, -3, 1e-12);
}

TEST(TimeSeries, TheLargestSampleAndTheRangeKnowNoParabola) {
    const TimeSeries v{{0, 1, 2, 3}, {0, 2, 1.9, -4}};
    EXPECT_GT(highest(v, 0, 2).value, 2);
    EXPECT_DOUBLE_EQ(largestSample(v), 4);
    EXPECT_DOUBLE_EQ(range(v).least, -4);
    EXPECT_DOUBLE_EQ(range(v).most, 2);
    EXPECT_DOUBLE_EQ(range(v).width(), 6);
}

TEST(TimeSeries, TurningPointsAreThoseOfASineAndSmallSwingsAreLeftOut) {
    const TimeSeries v =
        sampled(100, 2, [](double t) { return std::sin(2 * std::numbers::pi * t) + 0.1 * std::sin(100 * t); });
    const auto turns = turningPoints(v, 0.5);
    ASSERT_EQ(turns.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(turns[i].time, 0.25 + 0.5 * static_cast<double>(i), 0.04);
    EXPECT_GT(turningPoints(v, 0.001).size(), 20u);
}

TEST(TimeSeries, LocalParabolasKeepAParabolaAndItsSlope) {
    const TimeSeries v = sampled(100, 2, [](double t) { return 1 + 2 * t - 3 * t * t; });
    const TimeSeries smooth = smoothed(v, 0.1), slope = derivative(v, 0.1);
    for (std::size_t i = 0; i < v.size(); ++i) {
        EXPECT_NEAR(smooth.value[i], v.value[i], 1e-9);
        EXPECT_NEAR(slope.value[i], 2 - 6 * v.time[i], 1e-8) << "also at the ends";
    }
}

TEST(TimeSeries, NoiseIsMeasuredThroughAMovingSignal) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 0.02);
    TimeSeries v = sampled(100, 20, [](double t) { return 2 * std::sin(3 * t); });
    EXPECT_LT(noise(v), 1e-5);
    EXPECT_FALSE(isNoisy(v));
    for (double& value : v.value) value += normal(random);
    EXPECT_NEAR(noise(v), 0.02, 0.002);
    EXPECT_TRUE(isNoisy(v));
    // A local parabola over n samples leaves sqrt(9 / (4 n)) of white noise.
    double squares = 0;
    const TimeSeries smooth = smoothed(v, 0.1);
    for (std::size_t i = 0; i < v.size(); ++i) squares += std::pow(smooth.value[i] - 2 * std::sin(3 * v.time[i]), 2);
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(v.size())), 0.02 * std::sqrt(9 / (4 * 21.0)), 0.002);
}

}  // namespace
}  // namespace tread::metrics_series_test
