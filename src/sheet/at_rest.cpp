#include "sheet/at_rest.h"

#include "road/plane.h"
#include "tread/equilibrium.h"

namespace tread::sheet {
namespace {

constexpr double kSmallTravel = 1e-4;  // m
constexpr double kDamperSpeed = 0.05;  // m/s

}  // namespace

AtRest atRest(const VehicleParams& params) {
    AtRest rest;
    rest.vehicle = prepare(params);
    const PlaneRoad road;
    const Equilibrium stands = equilibrium(rest.vehicle, {road}, {.input = {.brake = 1, .clutch = 1}});
    rest.height = stands.motion.position_W.z();
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelState& wheel = stands.state.wheels[i];
        const Vehicle::Corner& corner = rest.vehicle.corners[i];
        rest.load[i] = wheel.load;
        rest.travel[i] = wheel.travel;
        rest.radius[i] = wheel.radius;
        const TyreWarmth warm = warmth(corner.temperature, 0);
        TyreParams& tyre = rest.tyre[i] = corner.tyre;
        tyre.lambda.mux *= warm.friction;
        tyre.lambda.muy *= warm.friction;
        tyre.lambda.Kx *= warm.stiffness;
        tyre.lambda.Ky *= warm.stiffness;
    }
    return rest;
}

double wheelRate(const AtRest& rest, std::size_t wheel, double with) {
    const auto force = [&](double travel) {
        return forces(rest.axle(axleOf(wheel)).suspension,
                      {rest.travel[wheel] + travel, 0, rest.travel[wheel] + with * travel,
                       rest.vehicle.corners[wheel].static_force})
            .force;
    };
    return (force(kSmallTravel) - force(-kSmallTravel)) / (2 * kSmallTravel);
}

double wheelDamping(const AtRest& rest, std::size_t wheel) {
    SuspensionParams suspension = rest.axle(axleOf(wheel)).suspension;
    suspension.damper.friction = 0;
    const auto force = [&](double rate) {
        return forces(suspension,
                      {rest.travel[wheel], rate, rest.travel[wheel], rest.vehicle.corners[wheel].static_force})
            .force;
    };
    return (force(kDamperSpeed) - force(-kDamperSpeed)) / (2 * kDamperSpeed);
}

}  // namespace tread::sheet
