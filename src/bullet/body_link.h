// The link between a motion that is predicted in double precision and the rigid body that Bullet moves.
#pragma once

#include "tread/bullet_precision.h"
#include "tread/bullet_vehicle.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// Velocities that the body will show after Bullet's step if nobody else pushes it.
struct BodyLink {
    Vector3 velocity = Vector3::Zero();
    Vector3 angular_velocity = Vector3::Zero();
};

void expectWhatBodyHas(BodyLink& link, const btRigidBody& body);

// Takes the body's motion: the pose is Bullet's; the velocity is ours, changed by what others did to the body's.
// `axes` turns the motion's axes into the body's.
void takeMotion(ChassisMotion& motion, BodyLink& link, const btRigidBody& body, const Quaternion& axes);

// Gives the body the mean velocity of a motion over dt, less what Bullet will add for gravity.
void giveMotion(btRigidBody& body, BodyLink& link, const ChassisMotion& from, const ChassisMotion& to, double dt);

// The body's gyroscopic moments are in the prediction: Bullet's own would count twice.
void switchOffGyroscopicForces(btRigidBody& body);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
