#include "tread/delay_line.h"

#include <gtest/gtest.h>

namespace tread {
namespace {

TEST(DelayLine, ReturnsTheInputOfSoManyStepsAgo) {
    DelayLine line;
    for (int k = 1; k <= 500; ++k) EXPECT_EQ(line.advance(k, 0.05, 0.001), k <= 50 ? 0 : k - 50) << k;
}

TEST(DelayLine, WithoutDelayReturnsTheInput) {
    DelayLine line;
    EXPECT_EQ(line.advance(0.7, 0, 0.001), 0.7);
}

TEST(DelayLine, InterpolatesBetweenSteps) {
    DelayLine line;
    double out = 0;
    for (int k = 1; k <= 100; ++k) out = line.advance(0.002 * k, 0.0133, 0.002);
    EXPECT_NEAR(out, 0.2 - 0.0133, 1e-12) << "a ramp of 1/s, 13.3 ms late";
    out = 0;
    DelayLine shorter;
    for (int k = 1; k <= 100; ++k) out = shorter.advance(0.002 * k, 0.0007, 0.002);
    EXPECT_NEAR(out, 0.2 - 0.0007, 1e-12) << "a delay of less than a step";
}

TEST(DelayLine, LongDelayOfAShortStepIsSampledMoreCoarsely) {
    DelayLine line;
    double out = 0;
    for (int k = 1; k <= 5000; ++k) out = line.advance(0.001 * k, 0.8, 0.001);
    EXPECT_NEAR(out, 5 - 0.8, 0.8 / 126);
}

}  // namespace
}  // namespace tread
