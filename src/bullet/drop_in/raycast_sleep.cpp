// When a RaycastVehicle sleeps, and what wakes it.
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cmath>

#include "bullet/drop_in/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// Below these a vehicle may fall asleep; Bullet alone would stop one that rolls at walking pace.
constexpr double kRestSpeed = 0.01;  // m/s
constexpr double kRestSpin = 0.05;   // rad/s

}  // namespace

// A sleeping car costs a look at its inputs and at the ground that it stands on.
bool RaycastVehicle::Implementation::staysAsleep(const btCollisionWorld* in) {
    if (chassis.getActivationState() != ISLAND_SLEEPING) return true;  // the game switched its simulation off
    bool wakes = !asleep || wheelCount() != car->wheel_count;
    if (!asleep) {
        // Bullet has just stopped the chassis, wherever it stood.
        wakes = !made;
        asleep = true;
        motion.velocity_W.setZero();
        motion.angular_velocity_W.setZero();
        link = {};
        planned = 0;
        state.acceleration_W = state.angular_acceleration_W = {};
        for (std::size_t i = 0; i < wheelCount(); ++i) info(i).m_deltaRotation = 0;
    }
    for (std::size_t i = 0; i < wheelCount() && !wakes; ++i) {
        wakes = demand(i) != demands[i] || !(tuningOf(info(i)) == recipe.wheels[i]);
        if (in && !wakes) wakes = !isThere(grounds[i], *in);
    }
    if (!wakes) return true;
    chassis.activate(true);
    chassis.applyGravity();  // for what is left of this call of stepSimulation
    asleep = false;
    return false;
}

// Bullet stops what has been slow for two seconds; what still rolls, or stands on what still moves, is kept awake.
void RaycastVehicle::Implementation::fallAsleepOrNot() {
    bool rests = motion.velocity_W.norm() < kRestSpeed && motion.angular_velocity_W.norm() < kRestSpeed;
    for (std::size_t i = 0; i < car->wheel_count; ++i) {
        rests &= std::abs(state.wheels[i].spin) < kRestSpin;
        const btRigidBody* body = bodyUnder(grounds[i]);
        rests &= !body || body->isStaticOrKinematicObject() || !body->isActive();
    }
    if (!rests) chassis.setDeactivationTime(0);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
