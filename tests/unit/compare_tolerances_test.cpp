#include <gtest/gtest.h>

#include "base/read_yaml.h"
#include "compare/tolerances.h"

namespace tread {
namespace {

TEST(Tolerances, AFileChangesWhatItNamesAndLeavesTheDefaults) {
    const auto read = readYamlText<Tolerances>(
        "relative: 2 %\n"
        "channels:\n"
        "  - {channel: 'wheel.*.load', absolute: 50}\n"
        "  - {channel: chassis.x, ignore: true}\n",
        "tolerances.yaml");
    EXPECT_DOUBLE_EQ(read.relative, 0.02);
    EXPECT_EQ(read.units.size(), defaultUnitTolerances().size());
    ASSERT_EQ(read.channels.size(), 2u);
    EXPECT_EQ(read.channels[0].absolute, 50);
    EXPECT_FALSE(read.channels[0].relative);
    EXPECT_EQ(allowedDifference(read, {"wheel.front_left.load", "N", {}}).absolute, 50);
    EXPECT_EQ(allowedDifference(read, {"wheel.front_left.load", "N", {}}).relative, 0.02);
    EXPECT_TRUE(allowedDifference(read, {"chassis.x", "m", {}}).ignore);
}

TEST(Tolerances, NegativeTolerancesAndUnknownKeysAreRefused) {
    EXPECT_THROW(readYamlText<Tolerances>("relative: -1\n", "tolerances.yaml"), LoadError);
    EXPECT_THROW(readYamlText<Tolerances>("channels: [{channel: a, absolut: 1}]\n", "tolerances.yaml"), LoadError);
}

}  // namespace
}  // namespace tread
