#include "report/car_shape.h"

#include <algorithm>

namespace tread {
namespace {

// Of passenger cars.
constexpr double kOverhang = 0.31;  // over the wheelbase, in front of the front axle and behind the rear one
constexpr double kWidthOverTrack = 1.17;
constexpr double kRoofOverHeight = 2.65;  // of the roof over the centre of gravity

CarShape aroundWheels(CarShape shape, double front_distance, double rear_distance, double track) {
    const double overhang = kOverhang * (front_distance + rear_distance);
    shape.ahead = front_distance + overhang;
    shape.behind = rear_distance + overhang;
    shape.width = kWidthOverTrack * track;
    shape.roof = kRoofOverHeight * shape.height;
    return shape;
}

}  // namespace

CarShape carShape(const VehicleParams& vehicle, const CarOutline& outline) {
    const Vehicle prepared = prepare(vehicle);
    CarShape shape;
    for (std::size_t i = 0; i < kWheels; ++i) {
        shape.hubs[i] = prepared.corners[i].hub_B - prepared.reference_B;
        shape.wheel_radius[i] = prepared.corners[i].tyre.parameters.Ro;
    }
    shape.height = vehicle.centre_of_gravity_height;
    shape = aroundWheels(shape, vehicle.front_axle_distance, vehicle.wheelbase - vehicle.front_axle_distance,
                         std::max(vehicle.front.track, vehicle.rear.track));
    if (outline.width > 0) {
        shape.width = outline.width;
        shape.ahead = outline.ahead;
        shape.behind = outline.behind;
    }
    return shape;
}

CarShape typicalCarShape() {
    constexpr double kFront = 1.2, kRear = 1.45, kTrack = 1.52, kHeight = 0.54, kRadius = 0.315, kDeflection = 0.015;
    CarShape shape;
    shape.height = kHeight;
    for (std::size_t i = 0; i < kWheels; ++i) {
        shape.hubs[i] = {axleOf(i) == 0 ? kFront : -kRear, sideSign(i) * 0.5 * kTrack, kRadius - kDeflection - kHeight};
        shape.wheel_radius[i] = kRadius;
    }
    return aroundWheels(shape, kFront, kRear, kTrack);
}

}  // namespace tread
