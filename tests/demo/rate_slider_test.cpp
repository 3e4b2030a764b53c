// The slider for the steps per second, by its geometry.
#include "tools/demo/rate_slider.h"

#include <gtest/gtest.h>

namespace tread::demo {
namespace {

TEST(RateSlider, HandleLiesWhereItsRateIsTaken) {
    const RateSlider slider(1280);
    for (double rate = RateSlider::kLowest; rate <= RateSlider::kHighest; ++rate)
        EXPECT_EQ(slider.rateAt(static_cast<double>(slider.placeOf(rate))), rate);
    EXPECT_EQ(slider.placeOf(RateSlider::kLowest), slider.left());
    EXPECT_EQ(slider.placeOf(RateSlider::kHighest), slider.right());
}

TEST(RateSlider, DoublingIsTheSameWayEverywhere) {
    const RateSlider slider(1280);
    EXPECT_NEAR(slider.placeOf(60) - slider.placeOf(30), slider.placeOf(240) - slider.placeOf(120), 1e-3);
}

TEST(RateSlider, EndsHoldHoweverFarTheHandIs) {
    const RateSlider slider(640);
    EXPECT_EQ(slider.rateAt(-1e4), RateSlider::kLowest);
    EXPECT_EQ(slider.rateAt(1e4), RateSlider::kHighest);
    EXPECT_EQ(slider.placeOf(1000), slider.right());
}

TEST(RateSlider, IsTakenOnItAndNotElsewhere) {
    const RateSlider slider(1280);
    const double middle = static_cast<double>(RateSlider::kMiddle), at = static_cast<double>(slider.placeOf(60));
    EXPECT_TRUE(slider.holds(at, middle));
    EXPECT_FALSE(slider.holds(at, middle + 100));
    EXPECT_FALSE(slider.holds(static_cast<double>(slider.left()) - 60, middle));
}

}  // namespace
}  // namespace tread::demo
