#include "tread/delay_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread {
namespace {

// A ramp of 1/s, so that the answer tells the time that it is late.
double rampAfter(double delay, double dt, int steps) {
    DelayLine line;
    double out = 0;
    for (int k = 1; k <= steps; ++k) out = line.advance(dt * (k - 1), dt * k, delay, dt);
    return out;
}

TEST(DelayLine, JumpComesAfterTheDelay) {
    DelayLine line;
    EXPECT_EQ(line.advance(0.2, 0.7, 0, 0.001), 0.7);
}

TEST(DelayLine, RampIsLateByTheDelay) {
    EXPECT_NEAR(rampAfter(0.05, 0.001, 500), 0.5 - 0.05, 1e-12);
    EXPECT_NEAR(rampAfter(0.0133, 0.002, 100), 0.2 - 0.0133, 1e-12);
    EXPECT_NEAR(rampAfter(0.0007, 0.002, 100), 0.2 - 0.0007, 1e-12) << "a delay of less than a step";
    EXPECT_NEAR(rampAfter(0.8, 0.001, 5000), 5 - 0.8, 1e-12) << "a delay of many steps";
}

TEST(DelayLine, BeginsWithWhatItIsFilledWith) {
    DelayLine line;
    line.fill(3);
    EXPECT_EQ(line.advance(5, 5, 0.01, 0.001), 3);
}

}  // namespace
}  // namespace tread
