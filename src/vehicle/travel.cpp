// The wheel's own velocity w along the body's z axis obeys m_u dw/dt = tyre + links - suspension + weight, its travel
// dz/dt = w - (velocity of the hub on the body). Trapezoidal rule, linearised at the predicted end of the step: second
// order, stable for any stiffness, and it keeps the energy of an undamped wheel.

#include "vehicle/travel.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

double hubVelocity(const BodyFrame& body, const Vehicle::Corner& corner) {
    return body.velocity_B.z() + body.angular_velocity_B.x() * corner.hub_B.y() -
           body.angular_velocity_B.y() * corner.hub_B.x();
}

// The wheel centre rises by `rise` against the body: the contact slides along the wheel plane.
void raise(WheelContact& contact, double rise) {
    const Vector3 down = (contact.point_B - contact.hub_B) / contact.radius;
    contact.hub_B.z() += rise;
    contact.radius -= rise * contact.normal_B.z() / down.dot(contact.normal_B);
    contact.point_B = contact.hub_B + contact.radius * down;
}

}  // namespace

const SuspensionParams& suspensionOf(const Vehicle& vehicle, std::size_t wheel) {
    return axleOf(wheel) == 0 ? vehicle.params.front.suspension : vehicle.params.rear.suspension;
}

SuspensionForce suspensionForce(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, std::size_t wheel) {
    const std::size_t opposite = wheel ^ 1;
    return forces(suspensionOf(vehicle, wheel), {.travel = wheels[wheel].travel,
                                                 .rate = wheels[wheel].rate,
                                                 .opposite_travel = wheels[opposite].travel,
                                                 .static_force = vehicle.corners[wheel].static_force});
}

LinkSlopes linkSlopes(const Vehicle& vehicle, const WheelState& wheel, std::size_t index) {
    const SuspensionParams& suspension = suspensionOf(vehicle, index);
    const bool locked = wheel.spin == 0 && wheel.brake_torque > 0;
    return {.forward = locked ? suspension.side_view_slope_braking : suspension.side_view_slope_driving,
            .left = vehicle.corners[index].lateral_slope};
}

double linkForce(const Vehicle& vehicle, const WheelState& wheel, std::size_t index) {
    const SuspensionParams& suspension = suspensionOf(vehicle, index);
    const double cosine = std::cos(wheel.steer);
    const double sine = std::sin(wheel.steer);
    const double along = wheel.fx * cosine - wheel.fy * sine;
    const double across = wheel.fx * sine + wheel.fy * cosine;
    double force = vehicle.corners[index].lateral_slope * across + suspension.side_view_slope_driving * along;
    // What the brake holds turns the hub: the contact point follows the braking slope.
    const double by_brake = suspension.side_view_slope_braking - suspension.side_view_slope_driving;
    if (wheel.brake_torque > 0 && wheel.radius > 0) {
        const double capacity = wheel.spin == 0 ? kInfinity : wheel.brake_torque / wheel.radius;
        force += by_brake * std::clamp(along, -capacity, capacity);
    }
    return force;
}

PerWheel<WheelContact> advanceTravel(PerWheel<WheelState>& wheels, const Vehicle& vehicle, const BodyFrame& begin,
                                     const BodyFrame& end, const PerWheel<double>& steer, const Road& road, double dt) {
    // Vertical force on each wheel at the start, with what the horizontal tyre forces add; travel as if its rate
    // stayed.
    PerWheel<double> sideways, force_begin, rate_begin;
    for (std::size_t i = 0; i < kWheels; ++i) {
        sideways[i] = wheels[i].inclined_force + linkForce(vehicle, wheels[i], i);
        force_begin[i] = wheels[i].vertical_force + sideways[i] - suspensionForce(vehicle, wheels, i).force;
        rate_begin[i] = wheels[i].rate;
    }
    for (std::size_t i = 0; i < kWheels; ++i) wheels[i].travel += dt * rate_begin[i];

    // Force and slopes at the predicted end; one Newton step for the change of rate; contact and load at the true end.
    PerWheel<WheelContact> contacts;
    PerWheel<double> change;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        WheelState& wheel = wheels[i];
        const WheelAngles lean = angles(suspensionOf(vehicle, i), wheel.travel, isLeft(i));
        wheel.steer = steer[i] + lean.toe + suspensionOf(vehicle, i).steer_by_lateral_force * wheel.fy;
        contacts[i] = wheelContact(end, corner, wheel.travel, lean.camber, wheel.steer, road, i);
        const TyreLoad tyre = tyreLoad(corner.tyre, contacts[i], end, wheel.rate);
        const SuspensionForce spring = suspensionForce(vehicle, wheels, i);
        const double force_end = tyre.load * contacts[i].normal_B.z() + sideways[i] - spring.force;

        const double mean =
            0.5 * dt * ((force_begin[i] + force_end) / corner.unsprung_mass + begin.gravity_B.z() + end.gravity_B.z());
        const double hub_change = hubVelocity(end, corner) - hubVelocity(begin, corner);
        const double slope = 0.5 * dt * (tyre.by_deflection + spring.by_travel) + tyre.by_rate + spring.by_rate;
        change[i] = (mean - hub_change) / (1 + 0.5 * dt * slope / corner.unsprung_mass);
    }
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = wheels[i];
        wheel.rate = rate_begin[i] + change[i];
        wheel.travel += 0.5 * dt * change[i];
        raise(contacts[i], 0.5 * dt * change[i]);
        wheel.radius = contacts[i].radius;
        wheel.load = tyreLoad(vehicle.corners[i].tyre, contacts[i], end, wheel.rate).load;
        wheel.vertical_force = wheel.load * contacts[i].normal_B.z();
    }
    return contacts;
}

}  // namespace tread
