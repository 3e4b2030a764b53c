#include "base/math/median.h"

#include <gtest/gtest.h>

#include <limits>

namespace tread::median_test {
namespace {

TEST(Median, OfAnEvenCountIsTheMeanOfTheTwoInTheMiddle) {
    EXPECT_EQ(median({5, 1, 9}), 5);
    EXPECT_EQ(median({8, 1, 2, 100}), 5);
    EXPECT_EQ(median({3}), 3);
}

TEST(Median, WhatIsNotFiniteDoesNotCount) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    EXPECT_EQ(median({kNever, 4, std::nan(""), -kNever, 2}), 3);
    EXPECT_EQ(median({}), 0);
    EXPECT_EQ(median({kNever}), 0);
}

TEST(Median, StepOfATimeBaseIsTheUsualOneWhateverItsGaps) {
    const std::vector<double> time{0, 0.5, 1, 1.5, 60, 60.5};
    EXPECT_EQ(medianStep(time), 0.5);
    EXPECT_EQ(medianStep(std::vector<double>{1}), 0);
}

}  // namespace
}  // namespace tread::median_test
