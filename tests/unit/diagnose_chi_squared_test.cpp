#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/select/unknown_cause.h"
#include "inference/chi_squared.h"

namespace tread {
namespace {

using inference::chiSquaredTail;

// Closed forms: exp(-x/2) for 2 degrees of freedom, erfc(sqrt(x/2)) for 1, exp(-x/2)(1 + x/2) for 4.
TEST(ChiSquared, TailIsThatOfTheClosedForms) {
    for (const double x : {0.01, 0.5, 1.0, 3.0, 7.0, 30.0}) {
        EXPECT_NEAR(chiSquaredTail(x, 2) / std::exp(-x / 2), 1, 1e-9) << x;
        EXPECT_NEAR(chiSquaredTail(x, 1) / std::erfc(std::sqrt(x / 2)), 1, 1e-9) << x;
        EXPECT_NEAR(chiSquaredTail(x, 4) / (std::exp(-x / 2) * (1 + x / 2)), 1, 1e-9) << x;
    }
    EXPECT_EQ(chiSquaredTail(0, 3), 1);
}

}  // namespace
}  // namespace tread
