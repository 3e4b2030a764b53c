// The car as an action in a Bullet world.
//
// The action moves a rigid body with impulses only. Within one Bullet step it advances the car in substeps of at most
// 1 ms on a prediction of the body's motion in double precision, and gives the body the mean velocity of that motion,
// so that Bullet's own step takes it exactly where the prediction ends. The velocity at the end of the step is kept
// here; what others do to the body (collisions, constraints, forces) shows as a change of its velocity and is added to
// it.
//
//     world.addAction(&vehicle);
//     vehicle.setInput({.steering_wheel_angle = 0.3, .throttle = 0.2});
//     world.stepSimulation(...);
//     vehicle.output().chassis.yaw_rate;
#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>
#include <LinearMath/btScalar.h>
#include <LinearMath/btVector3.h>

#include <memory>

#include "tread/api.h"
#include "tread/bullet_precision.h"
#include "tread/vehicle.h"

class btRigidBody;

namespace tread {

// The precision of btScalar is part of every symbol below: a program built for the other one does not link, and the
// linker names what is missing.
inline namespace TREAD_BULLET_PRECISION {

// Which axes of the body (0 x, 1 y, 2 z, as seen by Bullet) point where. The default is ISO 8855; games often have y
// up.
struct BodyAxes {
    btVector3 forward{1, 0, 0};
    btVector3 left{0, 1, 0};
};

class TREAD_API BulletVehicle : public btActionInterface {
public:
    // The body's origin is the centre of gravity of the car with its load; its mass and inertia are set from the
    // parameters. `chassis` and
    // `road` must outlive the vehicle. Bullet's gyroscopic forces on the body are switched off: the vehicle has them.
    BulletVehicle(const VehicleParams& params, btRigidBody& chassis, Road& road, const BodyAxes& axes = {});
    BulletVehicle(const BulletVehicle&) = delete;
    BulletVehicle& operator=(const BulletVehicle&) = delete;
    ~BulletVehicle() override;

    // Driver's input at the end of the next step; within it the input moves linearly from the last one.
    void setInput(const VehicleInput& input);

    // Velocity of the air from the next step on, m/s, in the world. Still air until it is called.
    void setWind(const Vector3& velocity_W);

    // Longest substep, s: 0.001 unless set; between 0.0001 and 0.02. Larger is cheaper and coarser.
    void setSubstep(double longest);

    // Puts the car into a state, for example an equilibrium or a snapshot.
    void restore(const ChassisMotion& motion, const VehicleState& state, const VehicleInput& input);

    const ChassisMotion& motion() const;
    const VehicleState& state() const;
    const Vehicle& vehicle() const;
    VehicleOutput output() const;  // at the time of the last step

    // Called by Bullet at the end of each step: takes the body's motion, then plans the next step of equal length.
    void updateAction(btCollisionWorld* world, btScalar dt) override;
    void debugDraw(btIDebugDraw* drawer) override;

    // The two halves of updateAction, for a runner that steps the world itself and wants the driver to react without a
    // step of delay: plan(dt), stepSimulation(dt, 0), observe(), and again.
    void plan(double dt);
    void observe();

private:
    struct TREAD_INTERNAL Implementation;
    std::unique_ptr<Implementation> self_;
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
