#include <cmath>

#include "base/math/elementary.h"
#include "tread/vehicle.h"
#include "tyre/four_tyres.h"
#include "vehicle/tyre_load.h"

namespace tread {
namespace {

TyreParams mounted(const TyreParams& tyre, bool left) {
    TyreParams here = (tyre.side == TyreSide::left) == left ? tyre : mirrored(tyre);
    here.name.clear();
    here.notes.clear();  // keeps the step free of allocations when a tyre is copied for a road of other friction
    return here;
}

// The slope of the moment about the steering axis with the steer angle, at small slip.
double aligningStiffness(const TyreParams& tyre, double load, double caster_trail) {
    constexpr double kSmall = 1e-3;  // rad
    constexpr double kSpeed = 20;    // m/s
    const auto at = [&](double slip) {
        return steadyState(tyre, {.Fz = load, .gamma = 0, .Vx = kSpeed, .Vsx = 0, .Vsy = kSpeed * slip});
    };
    const TyreSteadyState more = at(kSmall), less = at(-kSmall);
    const double slope = more.Mz - less.Mz - caster_trail * (more.Fy - less.Fy);
    return std::abs(slope) / (2 * kSmall);
}

// Load of a wheel of the level car at rest.
double staticLoad(const VehicleParams& params, std::size_t wheel, double gravity) {
    const bool front = axleOf(wheel) == 0;
    const double ahead = params.front_axle_distance, behind = params.wheelbase - ahead;
    const double track = (front ? params.front : params.rear).track;
    const double side = 0.5 + sideSign(wheel) * params.lateral_offset / track;
    return side * (front ? behind : ahead) / params.wheelbase * params.mass * gravity;
}

// `level`: the car whose springs and tyres leave it at its design height.
Vehicle::Corner cornerOf(const VehicleParams& params, const VehicleParams& level, std::size_t wheel, double gravity) {
    const AxleParams& axle = axleOf(wheel) == 0 ? params.front : params.rear;
    const double rear_axle_distance = params.wheelbase - params.front_axle_distance;
    const bool front = axleOf(wheel) == 0;
    const double load = staticLoad(params, wheel, gravity), level_load = staticLoad(level, wheel, gravity);
    const WheelParams& own = isLeft(wheel) ? axle.left : axle.right;
    const TyreSurroundingsParams& surroundings =
        own.tyre_surroundings ? *own.tyre_surroundings : axle.tyre_surroundings;
    TyreParams tyre = inflated(mounted(own.tyre ? *own.tyre : axle.tyre, isLeft(wheel)), surroundings.pressure);
    const double grip = own.grip * (1 + 0.5 * sideSign(wheel) * surroundings.grip_difference);
    tyre.lambda.mux *= grip;
    tyre.lambda.muy *= grip;
    tyre.lambda.Kx *= own.slip_stiffness;
    tyre.lambda.Ky *= own.cornering_stiffness;
    const TyreCoefficients& p = tyre.parameters;
    const double radius = p.Ro - level_load / radialStiffness(tyre);

    // The track is measured at the contacts, which lie below the hubs in the plane of the leaning wheels.
    const double camber = axle.suspension.camber;
    const double beside = 0.5 * axle.track + radius * sine(camber);

    Vehicle::Corner corner;
    corner.hub_B = {front ? params.front_axle_distance : -rear_axle_distance,
                    sideSign(wheel) * beside - params.lateral_offset,
                    radius * cosine(camber) - params.centre_of_gravity_height};
    corner.static_force = level_load - axle.unsprung_mass * gravity;
    corner.lateral_slope = sideSign(wheel) * axle.suspension.roll_centre_height / (0.5 * axle.track);
    corner.unsprung_mass = axle.unsprung_mass;
    corner.wheel_inertia = axle.wheel_inertia;
    corner.brake_drag = own.brake_drag;
    corner.tyre = tyre;
    corner.tyre_shift = shiftOf(surroundings, isLeft(wheel));
    corner.temperature = surroundings.temperature;
    corner.aligning_stiffness = aligningStiffness(tyre, load, front ? params.steering.caster_trail : 0);
    return corner;
}

// Of a positive definite matrix, by Gauss and Jordan without a search for pivots; in one order of operations on every
// machine, which Eigen's inverse has not.
Eigen::Matrix<double, 6, 6> inverseOf(const Eigen::Matrix<double, 6, 6>& matrix) {
    Eigen::Matrix<double, 6, 6> m = matrix;
    for (int k = 0; k < 6; ++k) {
        const double pivot = 1 / m(k, k);
        m(k, k) = 1;
        for (int j = 0; j < 6; ++j) m(k, j) *= pivot;
        for (int i = 0; i < 6; ++i) {
            if (i == k) continue;
            const double factor = m(i, k);
            m(i, k) = 0;
            for (int j = 0; j < 6; ++j) m(i, j) -= factor * m(k, j);
        }
    }
    return m;
}

}  // namespace

Vehicle prepare(const VehicleParams& unloaded, double gravity) {
    Vehicle vehicle;
    vehicle.params = loaded(unloaded);
    const VehicleParams &params = vehicle.params, &level = unloaded.load.levelled ? params : unloaded;
    vehicle.reference_B = {params.front_axle_distance - unloaded.front_axle_distance,
                           unloaded.lateral_offset - params.lateral_offset,
                           unloaded.centre_of_gravity_height - params.centre_of_gravity_height};
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i] = cornerOf(params, level, i, gravity);
        vehicle.tyres_shifted |= !corner.tyre_shift.none();
        vehicle.tyres_warm |= warms(corner.temperature);
        vehicle.warmth_felt |= feelsWarmth(corner.temperature);
    }
    vehicle.recedes =
        params.front.suspension.longitudinal_compliance > 0 || params.rear.suspension.longitudinal_compliance > 0;
    vehicle.tyres = std::make_shared<const FourTyres>(
        together({vehicle.corners[0].tyre, vehicle.corners[1].tyre, vehicle.corners[2].tyre, vehicle.corners[3].tyre}));

    // Mass matrix of the body whose unsprung masses move freely along z: the rigid car less m_u J J^T per wheel, where
    // J takes the body's acceleration to the vertical acceleration of a hub.
    Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();
    mass.diagonal() << params.mass, params.mass, params.mass, params.inertia.roll, params.inertia.pitch,
        params.inertia.yaw;
    mass(3, 5) = mass(5, 3) = -params.inertia.roll_yaw;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        Eigen::Vector<double, 6> j;
        j << 0, 0, 1, corner.hub_B.y(), -corner.hub_B.x(), 0;
        mass -= corner.unsprung_mass * j * j.transpose();
    }
    vehicle.inverse_mass = inverseOf(mass);
    return vehicle;
}

}  // namespace tread
