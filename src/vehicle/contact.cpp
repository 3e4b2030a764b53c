#include "vehicle/contact.h"

#include <algorithm>
#include <cmath>

namespace tread {

BodyMotion bodyMotion(const ChassisMotion& motion) {
    const Eigen::Matrix3d to_world = motion.orientation.toRotationMatrix();
    return {to_world, motion.position_W, to_world.transpose() * motion.velocity_W,
            to_world.transpose() * motion.angular_velocity_W};
}

WheelContact wheelContact(const Vector3& hub_B, const Vector3& axis_B, const BodyMotion& body,
                          const RoadContact& ground) {
    WheelContact contact;
    contact.hub_B = hub_B;
    contact.axis_B = axis_B;
    const Vector3 n = body.to_world.transpose() * ground.normal_W;
    const Vector3 plane_B = body.to_world.transpose() * (ground.point_W - body.position_W);
    const double sine = axis_B.dot(n);
    constexpr double kFlat = 1e-12;  // of the cosine squared: a wheel that lies on its side has no forward direction
    contact.cosine = std::sqrt(std::max(1 - sine * sine, kFlat));

    // Contact centre: down the wheel plane, onto the road.
    contact.to_road_B = (sine * axis_B - n) / contact.cosine;
    contact.radius = (hub_B - plane_B).dot(n) / contact.cosine;
    contact.point_B = hub_B + contact.radius * contact.to_road_B;
    contact.forward_B = axis_B.cross(n) / contact.cosine;
    contact.left_B = n.cross(contact.forward_B);
    contact.normal_B = n;
    contact.camber = std::asin(std::clamp(sine, -1.0, 1.0));
    contact.friction = ground.friction;
    contact.exists = ground.exists;
    contact.ground_velocity_B = body.to_world.transpose() * ground.velocity_W;
    return contact;
}

}  // namespace tread
