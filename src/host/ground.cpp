#include "host/ground.h"

#include <cmath>
#include <string_view>

#include "base/text/concat.h"
#include "host/failure.h"

namespace tread::host {
namespace {

std::string_view nameOf(std::size_t wheel) {
    std::string_view found;
    std::size_t i = 0;
    PerWheel<double> wheels;
    PerWheel<double>::describe(wheels, [&](std::string_view, const double&, const About& about) {
        if (i++ == wheel) found = about.meaning;
    });
    return found;
}

// With a normal of length 1; false for what is no plane.
bool makeSound(RoadContact& plane) {
    if (!plane.exists) return true;
    const double length = plane.normal_W.norm();
    plane.normal_W /= length;
    return plane.point_W.allFinite() && plane.normal_W.allFinite() && plane.velocity_W.allFinite() &&
           std::isfinite(plane.friction) && plane.friction >= 0 && length > 0;
}

constexpr std::string_view kExpected =
    "expected finite numbers, a normal that is not zero and a friction of at least 0";

}  // namespace

void Ground::use(std::shared_ptr<Road> road) {
    road_ = std::move(road);
    function_ = {};
}

void Ground::use(GroundFunction function) {
    function_ = std::move(function);
    road_ = {};
}

void Ground::setPlane(std::size_t wheel, const RoadContact& plane) {
    if (wheel >= kWheels) refuse("found a wheel that is none of the four, expected 0 to 3");
    RoadContact sound = plane;
    if (!makeSound(sound)) refuse(concat({"the ground of the ", nameOf(wheel), " is no plane: ", kExpected}));
    planes_[wheel] = sound;
    use(std::shared_ptr<Road>());
}

void Ground::beginStep() {
    faulty_wheel_ = -1;
    if (road_) road_->beginStep();
}

RoadContact Ground::contact(const Vector3& centre_W, std::size_t wheel) const {
    if (road_) return road_->contact(centre_W, wheel);
    if (!function_) return planes_[wheel];
    RoadContact plane = function_(centre_W, wheel);
    if (makeSound(plane)) return plane;
    if (faulty_wheel_ < 0) faulty_wheel_ = static_cast<int>(wheel);
    return {.exists = false};
}

void Ground::throwIfFaulty() const {
    if (faulty_wheel_ < 0) return;
    refuse(concat({"the ground function gave the ", nameOf(static_cast<std::size_t>(faulty_wheel_)),
                   " what is no plane: ", kExpected}));
}

}  // namespace tread::host
