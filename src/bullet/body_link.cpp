#include "bullet/body_link.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet/convert.h"
#include "host/mean_velocity.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

void expectWhatBodyHas(BodyLink& link, const btRigidBody& body) {
    link.velocity = fromBullet(body.getLinearVelocity());
    link.angular_velocity = fromBullet(body.getAngularVelocity());
}

void takeMotion(ChassisMotion& motion, BodyLink& link, const btRigidBody& body, const Quaternion& axes) {
    motion.position_W = fromBullet(body.getCenterOfMassPosition());
    motion.orientation = fromBullet(body.getOrientation()) * axes;
    motion.velocity_W += fromBullet(body.getLinearVelocity()) - link.velocity;
    motion.angular_velocity_W += fromBullet(body.getAngularVelocity()) - link.angular_velocity;
    expectWhatBodyHas(link, body);
}

void giveMotion(btRigidBody& body, BodyLink& link, const ChassisMotion& from, const ChassisMotion& to, double dt) {
    link.velocity = (to.position_W - from.position_W) / dt;
    link.angular_velocity = meanAngularVelocity(from.orientation, to.orientation, dt);
    const Vector3 gravity = fromBullet(body.getGravity()).cwiseProduct(fromBullet(body.getLinearFactor()));
    const Vector3 change = link.velocity - dt * gravity - fromBullet(body.getLinearVelocity());
    const Vector3 spin_change = link.angular_velocity - fromBullet(body.getAngularVelocity());
    body.setLinearVelocity(body.getLinearVelocity() + toBullet(change));
    body.setAngularVelocity(body.getAngularVelocity() + toBullet(spin_change));
}

void switchOffGyroscopicForces(btRigidBody& body) {
    body.setFlags(body.getFlags() & ~(BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT | BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                      BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY));
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
