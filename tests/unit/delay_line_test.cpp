#include "base/math/delay_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::delay_line_test {
namespace {

TEST(DelayLine, ReturnsWhatTheSignalWasBefore) {
    for (const double delay : {0.0007, 0.0133, 0.05, 0.2}) {
        for (const double step : {0.0005, 0.001, 0.002}) {
            DelayLine line;
            const auto signal = [](double t) { return 3 * t; };
            for (int k = 1; k <= 600; ++k) {
                const double t = k * step;
                const double out = advance(line, signal(t - step), signal(t), delay, step);
                if (t > delay + step) {
                    EXPECT_NEAR(out, signal(t - delay), 1e-9) << delay << " " << step;
                } else if (t < delay) {
                    EXPECT_EQ(out, 0);
                }
            }
        }
    }
}

TEST(DelayLine, JumpComesAfterTheDelay) {
    DelayLine line;
    for (int k = 1; k <= 200; ++k) EXPECT_NEAR(advance(line, 1, 1, 0.05, 0.001), k <= 50 ? 0 : 1, 1e-12) << k;
}

TEST(DelayLine, LongDelayIsSampledMoreCoarsely) {
    DelayLine line;
    double out = 0;
    for (int k = 1; k <= 5000; ++k) out = advance(line, std::sin((k - 1) * 0.001), std::sin(k * 0.001), 0.8, 0.001);
    EXPECT_NEAR(out, std::sin(5 - 0.8), 1e-5);
}

TEST(DelayLine, FilledLineStays) {
    DelayLine line;
    line.past.fill(0.7);
    for (int k = 0; k < 100; ++k) EXPECT_EQ(advance(line, 0.7, 0.7, 0.02, 0.001), 0.7);
}

}  // namespace
}  // namespace tread::delay_line_test
