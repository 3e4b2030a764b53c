// Cars of one make share what was made of their numbers: of a thousand equal cars in a world one stays in the
// processor's cache.
#pragma once

#include <functional>
#include <memory>

#include "bullet/drop_in/stock_tuning.h"
#include "tread/bullet_precision.h"
#include "vehicle/wheeled_body.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// All that a car is made of, unless it has a vehicle file or tyres of its own.
struct CarRecipe {
    // Of the chassis: mass, inverse inertia, linear and angular factor, gravity, wheel reaction.
    using Body = std::array<double, 12>;
    Body body{};
    std::size_t wheel_count = 0;
    std::array<WheelTuning, kMostWheels> wheels{};

    // By their bits, as WheelTuning is; wheels that are not there do not count.
    bool operator==(const CarRecipe& other) const;
    std::size_t hash() const;
};

using MadeCar = std::shared_ptr<const WheeledBody>;

// The car of this recipe that somebody has, or one made now. For any thread; the bits are the same either way.
MadeCar sharedCar(const CarRecipe& recipe, const std::function<WheeledBody()>& make);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
