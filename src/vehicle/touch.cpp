#include "vehicle/touch.h"

#include <algorithm>
#include <cmath>

namespace tread {

Frame frameOf(const ChassisMotion& motion) {
    const Eigen::Matrix3d to_world = motion.orientation.toRotationMatrix();
    return {to_world, motion.position_W, to_world.transpose() * motion.velocity_W,
            to_world.transpose() * motion.angular_velocity_W};
}

Touch extended(const BodyWheel& wheel, const Frame& frame, const RoadContact& ground, double steer) {
    Touch t;
    t.hub_B = wheel.top_B + wheel.strut.length * wheel.down_B;
    t.axis_B = wheel.left_B;
    if (steer != 0) t.axis_B = Eigen::AngleAxisd(steer, -wheel.down_B) * wheel.left_B;
    t.normal_B = frame.to_world.transpose() * ground.normal_W;
    const Vector3 plane_B = frame.to_world.transpose() * (ground.point_W - frame.position_W);
    const double sine = t.axis_B.dot(t.normal_B);
    const double cosine = std::sqrt(std::max(1 - sine * sine, 1e-12));

    // Contact centre: down the wheel plane, onto the road.
    t.radius = (t.hub_B - plane_B).dot(t.normal_B) / cosine;
    t.to_road_B = (sine * t.axis_B - t.normal_B) / cosine;
    t.forward_B = t.axis_B.cross(t.normal_B) / cosine;
    t.left_B = t.normal_B.cross(t.forward_B);
    t.camber = std::asin(std::clamp(sine, -1.0, 1.0));
    t.friction = ground.friction;
    t.ground_velocity_B = frame.to_world.transpose() * ground.velocity_W;
    t.cosine = cosine;
    return t;
}

void compress(Touch& t, const BodyWheel& wheel, double compression) {
    t.hub_B -= compression * wheel.down_B;
    t.radius -= compression * wheel.down_B.dot(t.normal_B) / t.cosine;
    t.point_B = t.hub_B + t.radius * t.to_road_B;
    t.side_B = t.point_B - (1 - wheel.roll_share) * t.point_B.dot(wheel.down_B) * wheel.down_B;
}

}  // namespace tread
