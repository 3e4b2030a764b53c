#include "vehicle/wheel.h"

#include <algorithm>
#include <cmath>

namespace tread {

BodyFrame bodyFrame(const ChassisMotion& motion, const VehicleState& state, const Vector3& gravity_W) {
    const auto& [ax, ay, az] = state.acceleration_W;
    const auto& [roll, pitch, yaw] = state.angular_acceleration_W;
    BodyFrame body;
    body.motion = bodyMotion(motion);
    const auto to_body = body.motion.to_world.transpose();
    body.acceleration_B = to_body * Vector3(ax, ay, az);
    body.angular_acceleration_B = to_body * Vector3(roll, pitch, yaw);
    body.gravity_B = to_body * gravity_W;
    return body;
}

WheelContact wheelContact(const BodyFrame& body, const Vehicle::Corner& corner, const WheelPose& pose, const Road& road,
                          std::size_t wheel) {
    const BodyMotion& motion = body.motion;
    const Vector3 hub_B = corner.hub_B + pose.displacement_B;
    const RoadContact ground = road.contact(motion.position_W + motion.to_world * hub_B, wheel);

    // Spin axis: the lateral axis, leant by camber about x, then steered about z.
    const double lean = std::cos(pose.camber);
    const Vector3 axis_B(-std::sin(pose.steer) * lean, std::cos(pose.steer) * lean, std::sin(pose.camber));
    return wheelContact(hub_B, axis_B, motion, ground);
}

TyreLoad tyreLoad(const Vehicle::Corner& corner, const WheelContact& contact, const BodyFrame& body, double rate) {
    if (!contact.exists) return {0, 0, 0};
    const Vector3 hub_velocity = velocityAt(body.motion, contact.hub_B) + Vector3(0, 0, rate);
    const double closing = deflectionRate(contact, hub_velocity);
    return tyreLoad(corner.tyre, {corner.tyre.parameters.Ro - contact.radius, closing, closing});
}

TyreMotion tyreMotion(const WheelContact& contact, const BodyFrame& body, const Vector3& slopes, double rate,
                      double yaw_rate, double load) {
    const Vector3 velocity = velocityAt(body.motion, contact.point_B) + rate * slopes;
    const Vector3 turning = body.motion.angular_velocity_B + Vector3(0, 0, yaw_rate);
    return tyreMotion(contact, velocity, turning, load);
}

double turningResistance(const Vehicle::Corner& corner, double spin, double dt) {
    constexpr double kSteps = 3;  // an answer as late as that would still swing
    const TyreCoefficients& p = corner.tyre.parameters;
    const double force = p.cygyr * p.Ro * p.mt * spin;   // over the rate of turning (26)
    const double couple = p.czgyr * p.Ro * p.mt * spin;  // over the speed of the patch (25)
    // What slides in the patch damps it besides; at the limit of grip little does.
    return std::max(couple * force, 0.0) / (p.mc / (kSteps * dt) + p.kFy);
}

}  // namespace tread
