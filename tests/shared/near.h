// EXPECT_NEAR for long double, which GoogleTest would round to double.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>

namespace reference {

inline ::testing::AssertionResult near(long double value, long double expected, long double tolerance) {
    const long double difference = std::abs(value - expected);
    if (difference <= tolerance) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << std::setprecision(20) << value << " differs from " << expected << " by "
                                         << difference << ", more than " << tolerance;
}

}  // namespace reference
