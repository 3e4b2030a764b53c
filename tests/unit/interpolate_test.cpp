#include "base/math/interpolate.h"

#include <gtest/gtest.h>

#include "base/fields/numbers.h"
#include "tread/vehicle_output.h"

namespace tread::interpolate_test {
namespace {

TEST(Interpolate, EveryFieldLiesBetween) {
    VehicleInput begin, end, middle;
    const auto from = numbers(begin), to = numbers(end);
    for (std::size_t i = 0; i < from.size(); ++i) {
        *from[i].value = static_cast<double>(i);
        *to[i].value = 2.0 * static_cast<double>(i) + 1;
    }
    middle = interpolated(begin, end, 0.25);
    const auto found = numbers(middle);
    ASSERT_GE(found.size(), 6u);
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(*found[i].value, 0.75 * *from[i].value + 0.25 * *to[i].value) << found[i].path;
}

TEST(Interpolate, EndsAreHit) {
    const VehicleInput begin{.throttle = 0.25, .brake = 1}, end{.steering_wheel_angle = 2, .throttle = 0.5};
    EXPECT_EQ(interpolated(begin, end, 0).brake, 1);
    EXPECT_EQ(interpolated(begin, end, 1).steering_wheel_angle, 2);
    EXPECT_EQ(interpolated(begin, end, 1).throttle, 0.5);
}

}  // namespace
}  // namespace tread::interpolate_test
