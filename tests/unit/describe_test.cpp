#include "tread/describe.h"

#include <gtest/gtest.h>

#include <string>

#include "base/numbers.h"
#include "shared/described_samples.h"
#include "tread/wheels.h"

namespace tread {
namespace {

using sample::Damper;

static_assert(describesEveryMember<PerWheel<Damper>>());

struct Forgetful {
    double described = 0;
    std::string forgotten;
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(described), About{"m", "x"}); }
};
static_assert(!describesEveryMember<Forgetful>());

TEST(Describe, NumbersAreFlattenedToPathsInOrderOfDescription) {
    PerAxle<Damper> dampers;
    const auto flat = numbers(dampers, "suspension");
    ASSERT_EQ(flat.size(), 4u);
    EXPECT_EQ(flat[0].path, "suspension.front.bump");
    EXPECT_EQ(flat[3].path, "suspension.rear.friction");
    EXPECT_EQ(flat[3].about.unit, "N");
    *flat[3].value = 12;
    EXPECT_EQ(dampers.rear.friction, 12);
}

TEST(Describe, OpenEndsOfLimitsExcludeTheEnd) {
    EXPECT_FALSE(kPositive.allow(0));
    EXPECT_TRUE(kNonNegative.allow(0));
    EXPECT_FALSE(kPositive.allow(kInfinity));
    EXPECT_FALSE(kFraction.allow(1.5));
    EXPECT_FALSE(kAny.allow(kRequired)) << "NaN is outside every range";
}

}  // namespace
}  // namespace tread
