// Effects beside an unknown cause: the probability against the closed form of a share that is known exactly, and where
// noise hides it (D32a).
#include "diagnose/select/beside_unknown.h"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/settings.h"

namespace tread {
namespace {

using diagnose::kSettings;
using diagnose::select::actsBesideUnknown;
using diagnose::select::closedShare;

double oddsAgainst(double with, double without, double scatter, std::size_t named = 1) {
    const double p = actsBesideUnknown(closedShare(with, without, scatter), named);
    return (1 - p) / p;
}

double prior(std::size_t named) {
    return kSettings.prior(named - 1) / (kSettings.prior(named) * static_cast<double>(named));
}

// A share counts as known to within 1/101. That changes the ratio by up to a third of its square over that of c (1 -
// c), 0.4 % at c = 0.1.
TEST(BesideUnknown, HasTheRatioOfTheDensitiesOfAShareThatIsKnown) {
    for (const std::size_t named : {1, 2, 3}) {
        for (const double share : {0.1, 0.4, 0.5, 0.9}) {
            const double expected = prior(named) * 4 * std::log(10) * share * (1 - share);
            EXPECT_NEAR(oddsAgainst(1e6 * (1 - share), 1e6, 1, named), expected, 0.004 * expected);
        }
    }
}

TEST(BesideUnknown, HasThePriorOddsWhereNoiseHidesTheShare) {
    EXPECT_DOUBLE_EQ(oddsAgainst(0, 90, 100), prior(1));
    EXPECT_DOUBLE_EQ(oddsAgainst(50, 100, 100), prior(1));
}

// An effect that closes all that can be seen may still be what an unknown cause is most like.
TEST(BesideUnknown, IsNotCertainOfAnEffectThatClosesAll) {
    const double at_the_limit = 2 * std::log(100) * (2 / 101.0) / (std::log(100) - std::log(99.0 / 2)) * prior(1);
    EXPECT_NEAR(oddsAgainst(0, 1e9, 1), at_the_limit, 1e-9);
    EXPECT_GT(oddsAgainst(0, 1000, 100), oddsAgainst(0, 1e9, 1)) << "a tenth may remain";
    EXPECT_LT(oddsAgainst(0, 1000, 100), oddsAgainst(500, 1000, 1)) << "half remains";
}

}  // namespace
}  // namespace tread
