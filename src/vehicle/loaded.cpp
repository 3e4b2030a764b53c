// A load as part of the car: a point mass fixed to it, by the parallel-axis theorem. Products of inertia other than
// roll_yaw are left out, as everywhere.

#include <algorithm>

#include "tread/vehicle.h"

namespace tread {
namespace {

// Share of a moment of inertia that is left at least, if a load is taken out of the car at a place where it cannot have
// been.
constexpr double kLeast = 0.1;

// Place of a load of this mass that has this moment, as far as it can lie within the car: a fit may come by a moment
// for which its mass is too small. From such a moment only the centre of gravity follows.
Vector3 placeWithin(const VehicleParams& car, const Vector3& moment, double mass) {
    if (mass == 0) return Vector3::Zero();
    const Vector3 reach(car.wheelbase, 0.5 * std::max(car.front.track, car.rear.track), 0.5 * car.wheelbase);
    return (moment / mass).cwiseMax(-reach).cwiseMin(reach);
}

}  // namespace

VehicleParams loaded(const VehicleParams& params) {
    VehicleParams car = params;
    car.load = {};
    const LoadParams& load = params.load;
    if (load.none()) return car;
    const Vector3 place(load.x, load.y, load.z), moment(load.moment_x, load.moment_y, load.moment_z);
    const Vector3 shift = (load.mass * place + moment) / (params.mass + load.mass);
    car.mass += load.mass;
    car.front_axle_distance -= shift.x();
    car.lateral_offset += shift.y();
    car.centre_of_gravity_height += shift.z();

    // Both about the common centre of gravity: the reduced mass at their distance.
    const Vector3 arm = place + placeWithin(params, moment, load.mass);
    const double reduced = params.mass * load.mass / car.mass;
    const Vector3 squares = reduced * arm.cwiseAbs2();
    const auto grow = [](double& inertia, double by) { inertia = std::max(kLeast * inertia, inertia + by); };
    grow(car.inertia.roll, squares.y() + squares.z());
    grow(car.inertia.pitch, squares.x() + squares.z());
    grow(car.inertia.yaw, squares.x() + squares.y());
    car.inertia.roll_yaw += reduced * arm.x() * arm.z();
    return car;
}

}  // namespace tread
