#include "bullet/planned_pose.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <limits>

#include "bullet/convert.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// A velocity is set by two sums and changed by one product; a position is moved by a product and a sum; an attitude
// goes through an exponential map, a product, a matrix and back. Each rounds by half an epsilon per component, at most
// some ten times in all.
constexpr double kRoundings = 16;
constexpr double kRounding = kRoundings * std::numeric_limits<double>::epsilon();

double sizeOf(const Vector3& a) {
    return a.lpNorm<1>();
}
bool isWithin(const Vector3& difference, double rounding) {
    return difference.lpNorm<Eigen::Infinity>() <= rounding;
}

}  // namespace

PlannedPose::PlannedPose(const btRigidBody& body, const ChassisMotion& from, const ChassisMotion& to, double dt)
    : position_W_(to.position_W), orientation_(to.orientation) {
    if (dt > 0) {
        velocity_rounding_ = kRounding * (sizeOf(fromBullet(body.getLinearVelocity())) + sizeOf(to.velocity_W) +
                                          dt * sizeOf(fromBullet(body.getGravity())));
        angular_velocity_rounding_ =
            kRounding * (sizeOf(fromBullet(body.getAngularVelocity())) + sizeOf(to.angular_velocity_W));
    }
    position_rounding_ = kRounding * (sizeOf(from.position_W) + sizeOf(to.position_W)) + dt * velocity_rounding_;
    turn_rounding_ = kRounding + dt * angular_velocity_rounding_;
}

bool PlannedPose::isShownBy(const btRigidBody& body, const ChassisMotion& shown, const BodyLink& link) const {
    const Vector3 half_turn = (shown.orientation * orientation_.conjugate()).vec();
    return isWithin(shown.position_W - position_W_, position_rounding_) && isWithin(2 * half_turn, turn_rounding_) &&
           isWithin(fromBullet(body.getLinearVelocity()) - link.velocity, velocity_rounding_) &&
           isWithin(fromBullet(body.getAngularVelocity()) - link.angular_velocity, angular_velocity_rounding_);
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
