// A wheel of a body on the plane of the road: where it touches, and its axes there.
#pragma once

#include "vehicle/wheeled_body.h"

namespace tread {

// A wheel on the plane of the road, body axes.
struct Touch {
    Vector3 hub_B;
    Vector3 point_B;    // m, contact centre
    Vector3 side_B;     // m, where the side force acts
    Vector3 forward_B;  // unit vectors of the ISO 8855 wheel axes at the contact
    Vector3 left_B;
    Vector3 normal_B;
    Vector3 axis_B;
    Vector3 ground_velocity_B;
    Vector3 to_road_B;  // unit vector from the hub to the contact centre
    double radius;
    double camber;
    double cosine;  // of the camber
    double friction;
};

// The body's pose and velocities, as its wheels need them.
struct Frame {
    Eigen::Matrix3d to_world;
    Vector3 position_W, velocity_B, angular_velocity_B;
};
Frame frameOf(const ChassisMotion& motion);
inline Vector3 velocityAt(const Frame& frame, const Vector3& point_B) {
    return frame.velocity_B + frame.angular_velocity_B.cross(point_B);
}

// The wheel with its strut extended: all but where it touches, which the compression decides.
Touch extended(const BodyWheel& wheel, const Frame& frame, const RoadContact& ground, double steer);
void compress(Touch& touch, const BodyWheel& wheel, double compression);

}  // namespace tread
