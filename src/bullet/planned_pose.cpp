#include "bullet/planned_pose.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <limits>

#include "bullet/convert.h"
#include "host/mean_velocity.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// A velocity is set by two sums and changed by one product; a position is moved by a product and a sum; an attitude
// goes through an exponential map, a product, a matrix and back. Each rounds by half an epsilon per component, at most
// some ten times in all.
constexpr double kRoundings = 16;
constexpr double kRounding = kRoundings * std::numeric_limits<double>::epsilon();

}  // namespace

PlannedPose::PlannedPose(const btRigidBody& body, const ChassisMotion& from, const ChassisMotion& to, double dt)
    : position_W_(to.position_W), orientation_(to.orientation) {
    if (dt > 0) {
        velocity_rounding_ =
            kRounding * ((to.position_W - from.position_W).norm() / dt + fromBullet(body.getLinearVelocity()).norm() +
                         dt * fromBullet(body.getGravity()).norm());
        angular_velocity_rounding_ = kRounding * (meanAngularVelocity(from.orientation, to.orientation, dt).norm() +
                                                  fromBullet(body.getAngularVelocity()).norm());
    }
    position_rounding_ = kRounding * (from.position_W.norm() + to.position_W.norm()) + dt * velocity_rounding_;
    turn_rounding_ = kRounding + dt * angular_velocity_rounding_;
}

bool PlannedPose::isShownBy(const btRigidBody& body, const BodyLink& link, const Quaternion& axes) const {
    const auto within = [](const Vector3& difference, double rounding) { return difference.norm() <= rounding; };
    const ChassisMotion shown = poseOf(body, axes);
    const Vector3 half_turn = (shown.orientation * orientation_.conjugate()).vec();
    return within(shown.position_W - position_W_, position_rounding_) && within(2 * half_turn, turn_rounding_) &&
           within(fromBullet(body.getLinearVelocity()) - link.velocity, velocity_rounding_) &&
           within(fromBullet(body.getAngularVelocity()) - link.angular_velocity, angular_velocity_rounding_);
}

void PlannedPose::giveTo(ChassisMotion& motion) const {
    motion.position_W = position_W_;
    motion.orientation = orientation_;
}

ChassisMotion poseOf(const btRigidBody& body, const Quaternion& axes) {
    return {.position_W = fromBullet(body.getCenterOfMassPosition()),
            .orientation = fromBullet(body.getOrientation()) * axes};
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
