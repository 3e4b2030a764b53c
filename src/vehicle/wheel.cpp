#include "vehicle/wheel.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// Velocity of the contact centre, taken as fixed to the wheel carrier, relative to the ground. `slopes` is how it moves
// over the suspension travel.
Vector3 contactVelocity(const WheelContact& contact, const BodyFrame& body, const Vector3& slopes, double rate) {
    return body.velocity_B + body.angular_velocity_B.cross(contact.point_B) + rate * slopes - contact.ground_velocity_B;
}

}  // namespace

BodyFrame bodyFrame(const ChassisMotion& motion, const VehicleState& state, const Vector3& gravity_W) {
    const auto& [ax, ay, az] = state.acceleration_W;
    const auto& [roll, pitch, yaw] = state.angular_acceleration_W;
    BodyFrame body;
    body.to_world = motion.orientation.toRotationMatrix();
    body.position_W = motion.position_W;
    body.velocity_B = body.to_world.transpose() * motion.velocity_W;
    body.angular_velocity_B = body.to_world.transpose() * motion.angular_velocity_W;
    body.acceleration_B = body.to_world.transpose() * Vector3(ax, ay, az);
    body.angular_acceleration_B = body.to_world.transpose() * Vector3(roll, pitch, yaw);
    body.gravity_B = body.to_world.transpose() * gravity_W;
    return body;
}

WheelContact wheelContact(const BodyFrame& body, const Vehicle::Corner& corner, const Vector3& displacement,
                          double camber, double steer, const Road& road, std::size_t wheel) {
    WheelContact contact;
    contact.hub_B = corner.hub_B + displacement;
    const RoadContact ground = road.contact(body.position_W + body.to_world * contact.hub_B, wheel);
    const Vector3 n = body.to_world.transpose() * ground.normal_W;
    const Vector3 plane_B = body.to_world.transpose() * (ground.point_W - body.position_W);

    // Spin axis: the lateral axis, leant by camber about x, then steered about z.
    const double lean = std::cos(camber);
    const Vector3 axis(-std::sin(steer) * lean, std::cos(steer) * lean, std::sin(camber));
    const double sine = axis.dot(n);
    const double cosine = std::sqrt(std::max(1 - sine * sine, 1e-12));

    // Contact centre: down the wheel plane, onto the road.
    const Vector3 down = (sine * axis - n) / cosine;
    contact.radius = (contact.hub_B - plane_B).dot(n) / cosine;
    contact.point_B = contact.hub_B + contact.radius * down;
    contact.forward_B = axis.cross(n) / cosine;
    contact.left_B = n.cross(contact.forward_B);
    contact.normal_B = n;
    contact.axis_B = axis;
    contact.camber = std::asin(std::clamp(sine, -1.0, 1.0));
    contact.friction = ground.friction;
    contact.exists = ground.exists;
    contact.ground_velocity_B = body.to_world.transpose() * ground.velocity_W;
    return contact;
}

TyreLoad tyreLoad(const TyreParams& tyre, const WheelContact& contact, const BodyFrame& body, double rate) {
    const TyreCoefficients& p = tyre.parameters;
    const double deflection = p.Ro - contact.radius;
    if (!contact.exists || deflection <= 0) return {0, 0, 0};
    const Vector3 hub_velocity = body.velocity_B + body.angular_velocity_B.cross(contact.hub_B) + Vector3(0, 0, rate) -
                                 contact.ground_velocity_B;
    const double closing = -hub_velocity.dot(contact.normal_B);
    const double stiffness = p.pz1 * tyre.lambda.Cz;
    const double damping = p.pz2 * tyre.lambda.Kz;
    const double load = stiffness * deflection + damping * closing;  // (83)
    if (load <= 0) return {0, 0, 0};
    return {load, stiffness, damping};
}

TyreMotion tyreMotion(const WheelContact& contact, const BodyFrame& body, const Vector3& slopes, double rate,
                      double yaw_rate, double load) {
    const Vector3 velocity = contactVelocity(contact, body, slopes, rate);
    TyreMotion motion;
    motion.Vx = velocity.dot(contact.forward_B);
    motion.Vsy = -velocity.dot(contact.left_B);
    motion.psidot = -(body.angular_velocity_B.dot(contact.normal_B) + yaw_rate);
    motion.gamma = contact.camber;
    motion.Fz = load;
    return motion;
}

double turningResistance(const Vehicle::Corner& corner, double spin, double dt) {
    constexpr double kSteps = 3;  // an answer as late as that would still swing
    const TyreCoefficients& p = corner.tyre.parameters;
    const double force = p.cygyr * p.Ro * p.mt * spin;   // over the rate of turning (26)
    const double couple = p.czgyr * p.Ro * p.mt * spin;  // over the speed of the patch (25)
    // What slides in the patch damps it besides; at the limit of grip little does.
    return std::max(couple * force, 0.0) / (p.mc / (kSteps * dt) + p.kFy);
}

TyreForces toIso(const TyreForces& paper) {
    return {paper.Fx, -paper.Fy, paper.Mx, -paper.My, -paper.Mz};
}

}  // namespace tread
