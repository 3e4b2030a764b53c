// Where a body comes to be in Bullet's step if nobody else moves it, and whether it did.
#pragma once

#include "bullet/body_link.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// A body in double precision shows its plan but for rounding: then the plan itself is taken, so that a car that nobody
// touches moves exactly as it does without Bullet. A body in single precision never shows its plan that exactly.
class PlannedPose {
public:
    PlannedPose() = default;
    // Before the body is given its motion from its own pose to another over dt; `dt` of 0: it is there and stays.
    PlannedPose(const btRigidBody& body, const ChassisMotion& from, const ChassisMotion& to, double dt);

    // Whether the body moved as planned; velocities are those of the link. `shown`: its own pose.
    bool isShownBy(const btRigidBody& body, const ChassisMotion& shown, const BodyLink& link) const;

    void giveTo(ChassisMotion& motion) const;

private:
    Vector3 position_W_ = Vector3::Zero();
    Quaternion orientation_ = Quaternion::Identity();
    double position_rounding_ = 0;          // m
    double turn_rounding_ = 0;              // rad
    double velocity_rounding_ = 0;          // m/s
    double angular_velocity_rounding_ = 0;  // rad/s
};

// The body's own pose; no velocities. `axes` turns the motion's axes into the body's.
ChassisMotion poseOf(const btRigidBody& body, const Quaternion& axes);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
