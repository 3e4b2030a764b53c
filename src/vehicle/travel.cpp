// Along the body's z axis a wheel accelerates by (tyre + links - suspension) / m_u + gravity; its travel by that less
// the acceleration of the place where it hangs on the body. Trapezoidal rule, linearised at the predicted end of the
// step: second order, stable for any stiffness, and it keeps the energy of an undamped wheel.

#include "vehicle/travel.h"

#include "vehicle/aligning_compliance.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// Acceleration along z of the point of the body where the wheel hangs: of the point itself, not of a component in
// turning axes, so that a pitching car does not feel how fast it drives.
double hubAcceleration(const BodyFrame& body, const Vehicle::Corner& corner, double travel) {
    const Vector3& w = body.motion.angular_velocity_B;
    const Vector3 hub = corner.hub_B + Vector3(0, 0, travel);
    return (body.acceleration_B + body.angular_acceleration_B.cross(hub) + w.cross(w.cross(hub))).z();
}

SuspensionForce suspensionForce(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, std::size_t wheel) {
    const std::size_t opposite = wheel ^ 1;
    return forces(suspensionOf(vehicle, wheel), {.travel = wheels[wheel].travel,
                                                 .rate = wheels[wheel].rate,
                                                 .opposite_travel = wheels[opposite].travel,
                                                 .static_force = vehicle.corners[wheel].static_force});
}

}  // namespace

const SuspensionParams& suspensionOf(const Vehicle& vehicle, std::size_t wheel) {
    return axleOf(wheel) == 0 ? vehicle.params.front.suspension : vehicle.params.rear.suspension;
}

Vector3 contactSlopes(const WheelState& wheel, const Vehicle& vehicle, std::size_t index) {
    const SuspensionParams& suspension = suspensionOf(vehicle, index);
    const bool locked = wheel.spin == 0 && wheel.brake_torque > 0;
    return {locked ? suspension.side_view_slope_braking : suspension.side_view_slope_driving,
            vehicle.corners[index].lateral_slope, 1};
}

PerWheel<WheelContact> advanceTravel(PerWheel<WheelState>& wheels, const Vehicle& vehicle, const BodyFrame& begin,
                                     const BodyFrame& end, const PerWheel<double>& steer, const Road& road, double dt) {
    // Vertical force on each wheel at the start; travel as if its rate stayed.
    PerWheel<double> force_begin, travel_begin, rate_begin;
    for (std::size_t i = 0; i < kWheels; ++i) {
        force_begin[i] =
            wheels[i].vertical_force + wheels[i].link_force + wheels[i].tangent_force - wheels[i].suspension_force;
        travel_begin[i] = wheels[i].travel;
        rate_begin[i] = wheels[i].rate;
    }
    for (std::size_t i = 0; i < kWheels; ++i) wheels[i].travel += dt * rate_begin[i];

    // Force and slopes at the predicted end; one Newton step for the change of rate; contact and load at the true end.
    PerWheel<WheelContact> contacts;
    PerWheel<double> change;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        WheelState& wheel = wheels[i];
        const SuspensionParams& suspension = suspensionOf(vehicle, i);
        const WheelAngles lean = angles(suspension, wheel.travel, isLeft(i));
        const WheelAngles yielding =
            compliance(suspension, wheel.fx + dt * wheel.fx_rate, wheel.fy + dt * wheel.fy_rate, isLeft(i));
        wheel.steer = steer[i] + lean.toe + yielding.toe;
        if (suspension.steer_by_aligning_moment != 0) {
            const AligningLoad load{wheel.mz, corner.aligning_stiffness, turningResistance(corner, wheel.spin, dt)};
            wheel.steer += advance(wheel.moment_steer, suspension.steer_by_aligning_moment, load, dt);
        }
        contacts[i] = wheelContact(end, corner,
                                   {.displacement_B = {wheel.recession.travel, 0, wheel.travel},
                                    .camber = lean.camber + yielding.camber,
                                    .steer = wheel.steer},
                                   road, i);
        const TyreLoad tyre = tyreLoad(corner, contacts[i], end, wheel.rate);
        const SuspensionForce spring = suspensionForce(vehicle, wheels, i);
        const double force_end =
            tyre.load * contacts[i].normal_B.z() + wheel.link_force + wheel.tangent_force - spring.force;

        const double forces = (force_begin[i] + force_end) / corner.unsprung_mass;
        const double gravity = begin.gravity_B.z() + end.gravity_B.z();
        const double hub = hubAcceleration(begin, corner, travel_begin[i]) + hubAcceleration(end, corner, wheel.travel);
        const double slope = 0.5 * dt * (tyre.by_deflection + spring.by_travel) + tyre.by_rate + spring.by_rate;
        change[i] = 0.5 * dt * (forces + gravity - hub) / (1 + 0.5 * dt * slope / corner.unsprung_mass);
    }
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = wheels[i];
        wheel.rate = rate_begin[i] + change[i];
        wheel.travel += 0.5 * dt * change[i];
        shift(contacts[i], {0, 0, 0.5 * dt * change[i]});
        wheel.radius = contacts[i].radius;
        wheel.load = tyreLoad(vehicle.corners[i], contacts[i], end, wheel.rate).load;
        wheel.vertical_force = wheel.load * contacts[i].normal_B.z();
    }
    for (std::size_t i = 0; i < kWheels; ++i) wheels[i].suspension_force = suspensionForce(vehicle, wheels, i).force;
    return contacts;
}

void takeTyreForces(WheelState& wheel, const TyreForces& tyre, const Vehicle& vehicle, const WheelContact& contact,
                    std::size_t index, double dt) {
    wheel.fx_rate = (tyre.Fx - wheel.fx) / dt;
    wheel.fx = tyre.Fx;
    wheel.fy_rate = (tyre.Fy - wheel.fy) / dt;
    wheel.fy = tyre.Fy;
    wheel.mz = tyre.Mz;

    // The links let the contact move along (slope, lateral slope, 1) times the travel: what the road does along x and y
    // there, it does along the travel.
    const SuspensionParams& suspension = suspensionOf(vehicle, index);
    const Vector3 tangent = wheel.fx * contact.forward_B + wheel.fy * contact.left_B;
    const Vector3 road = tangent + wheel.load * contact.normal_B;
    double link = vehicle.corners[index].lateral_slope * road.y() + suspension.side_view_slope_driving * road.x();
    if (wheel.radius > 0) {
        const double capacity = wheel.brake_torque / wheel.radius;
        const double braking = std::clamp(road.x(), -capacity, capacity);
        link += (suspension.side_view_slope_braking - suspension.side_view_slope_driving) * braking;
    }

    const double change = link - wheel.link_force + tangent.z() - wheel.tangent_force;
    wheel.rate += 0.5 * dt * change / vehicle.corners[index].unsprung_mass;
    wheel.link_force = link;
    wheel.tangent_force = tangent.z();
}

}  // namespace tread
