// Vertical motion of the wheels between road and body. T is double, or lanes of which each holds another car.
//
// Along the body's z axis a wheel accelerates by (tyre + links - suspension) / m_u + gravity; its travel by that less
// the acceleration of the place where it hangs on the body. Trapezoidal rule, linearised at the predicted end of the
// step: second order, stable for any stiffness, and it keeps the energy of an undamped wheel.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/aligning_compliance.h"
#include "vehicle/suspension_forces.h"
#include "vehicle/wheel.h"

namespace tread {
inline namespace TREAD_ISA {

template <class Car>
const auto& suspensionOf(const Car& vehicle, std::size_t wheel) {
    return axleOf(wheel) == 0 ? vehicle.params.front.suspension : vehicle.params.rear.suspension;
}

// How the contact of a wheel moves in the body over its travel. A wheel that its brake locks turns with its carrier.
template <class T, class Car>
VectorOf<T> contactSlopes(const BasicWheelState<T>& wheel, const Car& vehicle, std::size_t index) {
    const auto& suspension = suspensionOf(vehicle, index);
    const auto locked = (wheel.spin == T(0)) & (wheel.brake_torque > T(0));
    return {select(locked, suspension.side_view_slope_braking, suspension.side_view_slope_driving),
            vehicle.corners[index].lateral_slope, T(1)};
}

// Acceleration along z of the point of the body where the wheel hangs: of the point itself, not of a component in
// turning axes, so that a pitching car does not feel how fast it drives.
template <class T, class Corner>
T hubAcceleration(const BasicBodyFrame<T>& body, const Corner& corner, const T& travel) {
    using Vector = VectorOf<T>;
    const Vector& w = body.motion.angular_velocity_B;
    const Vector hub = corner.hub_B + Vector(0, 0, travel);
    return Vector(body.acceleration_B + body.angular_acceleration_B.cross(hub) + w.cross(w.cross(hub))).z();
}

template <class T, class Car>
BasicSuspensionForce<T> suspensionForce(const Car& vehicle, const PerWheel<BasicWheelState<T>>& wheels,
                                        std::size_t wheel) {
    const std::size_t opposite = wheel ^ 1;
    return suspensionForces<T>(suspensionOf(vehicle, wheel), {.travel = wheels[wheel].travel,
                                                              .rate = wheels[wheel].rate,
                                                              .opposite_travel = wheels[opposite].travel,
                                                              .static_force = vehicle.corners[wheel].static_force});
}

// What a wheel's steer angle yields to its aligning moment.
template <class T, class Corner>
T yieldingSteer(BasicWheelState<T>& wheel, const Corner& corner, const T& compliance, double dt) {
    T angle = 0;
    if (!any(compliance != T(0))) return angle;
    const T resistance = turningResistance(corner, wheel.spin, dt);
    for (std::size_t i = 0; i < kLanesOf<T>; ++i) {
        if (lane(compliance, i) == 0) continue;
        AligningCompliance part{lane(wheel.moment_steer.deflection, i), lane(wheel.moment_steer.rate, i),
                                lane(wheel.moment_steer.moment, i)};
        const AligningLoad load{lane(wheel.mz, i), lane(corner.aligning_stiffness, i), lane(resistance, i)};
        setLane(angle, i, advance(part, lane(compliance, i), load, dt));
        setLane(wheel.moment_steer.deflection, i, part.deflection);
        setLane(wheel.moment_steer.rate, i, part.rate);
        setLane(wheel.moment_steer.moment, i, part.moment);
    }
    return angle;
}

// Advances travel, rate and load of all wheels while the body moves from `begin` to `end`; returns the contacts at the
// end. `steer` is the angle of each wheel at the end, without toe.
template <class T, class Car, class Ground>
PerWheel<BasicWheelContact<T>> advanceTravel(PerWheel<BasicWheelState<T>>& wheels, const Car& vehicle,
                                             const BasicBodyFrame<T>& begin, const BasicBodyFrame<T>& end,
                                             const PerWheel<T>& steer, const Ground& road, double dt) {
    using Vector = VectorOf<T>;
    // Vertical force on each wheel at the start; travel as if its rate stayed.
    PerWheel<T> force_begin, travel_begin, rate_begin;
    for (std::size_t i = 0; i < kWheels; ++i) {
        force_begin[i] =
            wheels[i].vertical_force + wheels[i].link_force + wheels[i].tangent_force - wheels[i].suspension_force;
        travel_begin[i] = wheels[i].travel;
        rate_begin[i] = wheels[i].rate;
    }
    for (std::size_t i = 0; i < kWheels; ++i) wheels[i].travel += dt * rate_begin[i];

    // Force and slopes at the predicted end; one Newton step for the change of rate; contact and load at the true end.
    PerWheel<BasicWheelContact<T>> contacts;
    PerWheel<T> change;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& corner = vehicle.corners[i];
        BasicWheelState<T>& wheel = wheels[i];
        const auto& suspension = suspensionOf(vehicle, i);
        const BasicWheelAngles<T> lean = suspensionAngles(suspension, wheel.travel, isLeft(i));
        const BasicWheelAngles<T> yielding = suspensionCompliance(suspension, T(wheel.fx + dt * wheel.fx_rate),
                                                                  T(wheel.fy + dt * wheel.fy_rate), isLeft(i));
        wheel.steer = steer[i] + lean.toe + yielding.toe;
        wheel.steer += yieldingSteer(wheel, corner, suspension.steer_by_aligning_moment, dt);
        contacts[i] = wheelContactOf<T>(end, corner,
                                        {.displacement_B = Vector(wheel.recession.travel, 0, wheel.travel),
                                         .camber = lean.camber + yielding.camber,
                                         .steer = wheel.steer},
                                        road, i);
        const BasicTyreLoad<T> tyre = tyreLoad(corner, contacts[i], end, wheel.rate);
        const BasicSuspensionForce<T> spring = suspensionForce(vehicle, wheels, i);
        const T force_end =
            tyre.load * contacts[i].normal_B.z() + wheel.link_force + wheel.tangent_force - spring.force;

        const T forces = (force_begin[i] + force_end) / corner.unsprung_mass;
        const T gravity = begin.gravity_B.z() + end.gravity_B.z();
        const T hub = hubAcceleration(begin, corner, travel_begin[i]) + hubAcceleration(end, corner, wheel.travel);
        const T slope = 0.5 * dt * (tyre.by_deflection + spring.by_travel) + tyre.by_rate + spring.by_rate;
        change[i] = 0.5 * dt * (forces + gravity - hub) / (1 + 0.5 * dt * slope / corner.unsprung_mass);
    }
    for (std::size_t i = 0; i < kWheels; ++i) {
        BasicWheelState<T>& wheel = wheels[i];
        wheel.rate = rate_begin[i] + change[i];
        wheel.travel += 0.5 * dt * change[i];
        shift<T>(contacts[i], Vector(0, 0, 0.5 * dt * change[i]));
        wheel.radius = contacts[i].radius;
        wheel.load = tyreLoad(vehicle.corners[i], contacts[i], end, wheel.rate).load;
        wheel.vertical_force = wheel.load * contacts[i].normal_B.z();
    }
    for (std::size_t i = 0; i < kWheels; ++i) wheels[i].suspension_force = suspensionForce(vehicle, wheels, i).force;
    return contacts;
}

// Keeps the tyre forces at the end of the step, and what they push along the wheel's travel: their own share along the
// body's z axis, and the links (roll centre, side-view slopes). The wheel moved under those of the step's beginning and
// takes the change.
template <class T, class Car>
void takeTyreForces(BasicWheelState<T>& wheel, const BasicTyreForces<T>& tyre, const Car& vehicle,
                    const BasicWheelContact<T>& contact, std::size_t index, double dt) {
    using Vector = VectorOf<T>;
    wheel.fx_rate = (tyre.Fx - wheel.fx) / dt;
    wheel.fx = tyre.Fx;
    wheel.fy_rate = (tyre.Fy - wheel.fy) / dt;
    wheel.fy = tyre.Fy;
    wheel.mz = tyre.Mz;

    // The links let the contact move along (slope, lateral slope, 1) times the travel: what the road does along x and y
    // there, it does along the travel.
    const auto& suspension = suspensionOf(vehicle, index);
    const Vector tangent = wheel.fx * contact.forward_B + wheel.fy * contact.left_B;
    const Vector road = tangent + wheel.load * contact.normal_B;
    const T capacity = wheel.brake_torque / wheel.radius;
    const T braking = select(wheel.radius > T(0), larger(smaller(T(road.x()), capacity), T(-capacity)), T(0));
    const T link = vehicle.corners[index].lateral_slope * road.y() + suspension.side_view_slope_driving * road.x() +
                   (suspension.side_view_slope_braking - suspension.side_view_slope_driving) * braking;

    const T change = link - wheel.link_force + tangent.z() - wheel.tangent_force;
    wheel.rate += 0.5 * dt * change / vehicle.corners[index].unsprung_mass;
    wheel.link_force = link;
    wheel.tangent_force = tangent.z();
}

}  // namespace TREAD_ISA
}  // namespace tread
