#include "base/math/lag.h"

#include <gtest/gtest.h>

namespace tread::lag_test {
namespace {

TEST(Lag, RampIsFollowedExactlyWithAnyStep) {
    constexpr double kTimeConstant = 0.08, kSlope = 3;
    for (const double step : {0.0005, 0.004, 0.03}) {
        double value = 0;
        for (int k = 1; k * step < 0.6; ++k) {
            const double t = k * step;
            value = lagged(value, kSlope * (t - step), kSlope * t, kTimeConstant, step);
            EXPECT_NEAR(value, kSlope * (t - kTimeConstant * (1 - std::exp(-t / kTimeConstant))), 1e-12) << step;
        }
    }
}

TEST(Lag, ConstantSignalIsApproachedExponentially) {
    double value = 1;
    for (int k = 0; k < 10; ++k) value = lagged(value, 5, 5, 0.2, 0.01);
    EXPECT_NEAR(value, 5 - 4 * std::exp(-0.5), 1e-12);
}

TEST(Lag, WithoutATimeConstantTheValueIsTheSignal) {
    EXPECT_EQ(lagged(7, 1, 2, 0, 0.001), 2);
}

}  // namespace
}  // namespace tread::lag_test
