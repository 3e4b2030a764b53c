#include "tread/describe.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/fields/numbers.h"
#include "shared/described_samples.h"
#include "tread/curve.h"
#include "tread/wheels.h"

namespace tread::describe_test {
namespace {

using sample::Damper;

static_assert(describesEveryMember<PerWheel<Damper>>());

// ---- A forgotten member does not compile, whatever its kind ----

template <class Member>
struct Careful {
    double first = 0;
    Member second;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(first), About{"m", "x"});
        field(TREAD_FIELD(second), About{"m", "y"});
    }
};

template <class Member>
struct Forgetful {
    double first = 0;
    Member second;
    static constexpr void describe(auto& self, auto&& field) { field(TREAD_FIELD(first), About{"m", "x"}); }
};

template <class Member>
constexpr bool forgetting_shows = describesEveryMember<Careful<Member>>() && !describesEveryMember<Forgetful<Member>>();

enum class Side { left, right };

static_assert(forgetting_shows<double>);
static_assert(forgetting_shows<int>);
static_assert(forgetting_shows<bool>);
static_assert(forgetting_shows<Side>);
static_assert(forgetting_shows<std::string>);
static_assert(forgetting_shows<Curve>);
static_assert(forgetting_shows<Damper>);
static_assert(forgetting_shows<PerAxle<double>>);
static_assert(forgetting_shows<PerWheel<Damper>>);
static_assert(forgetting_shows<PerWheel<std::optional<Damper>>>);
static_assert(forgetting_shows<std::optional<double>>);
static_assert(forgetting_shows<std::optional<Damper>>);
static_assert(forgetting_shows<std::vector<double>>);
static_assert(forgetting_shows<std::vector<Damper>>);
static_assert(forgetting_shows<std::vector<Careful<std::optional<Damper>>>>);
static_assert(forgetting_shows<std::variant<Damper, Careful<double>>>);
static_assert(forgetting_shows<std::optional<std::variant<Damper, Careful<double>>>>);

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
}  // namespace tread::describe_test
