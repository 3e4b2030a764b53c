// A Bullet world with a plane ground and one car on it: tread's or Bullet's own, for tests and benchmarks.
#pragma once

#include <BulletDynamics/Vehicle/btRaycastVehicle.h>
#include <btBulletDynamicsCommon.h>

#include <memory>

#include "shared/vehicle_run.h"
#include "tread/bullet_road.h"
#include "tread/bullet_vehicle.h"
#include "tread/equilibrium.h"

namespace tread::shared {

class PlaneWorld {
public:
    PlaneWorld() : ground_shape_(btVector3(0, 0, 1), 0), ground_(0, nullptr, &ground_shape_) {
        dynamics.setGravity(btVector3(0, 0, -kStandardGravity));
        dynamics.addRigidBody(&ground_);
    }
    ~PlaneWorld() { dynamics.removeRigidBody(&ground_); }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btStaticPlaneShape ground_shape_;
    btRigidBody ground_;

public:
    btDiscreteDynamicsWorld dynamics{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

// tread's car on Bullet's ground, in equilibrium at a speed.
class TreadCar {
public:
    TreadCar(btDiscreteDynamicsWorld& world, const VehicleParams& params, double speed)
        : shape_(btVector3(2, 0.8, 0.25)),
          chassis_(params.mass, nullptr, &shape_),
          road_(world, chassis_),
          world_(world) {
        chassis_.setActivationState(DISABLE_DEACTIVATION);
        world.addRigidBody(&chassis_);
        vehicle = std::make_unique<BulletVehicle>(params, chassis_, road_);
        const Equilibrium rest = equilibrium(vehicle->vehicle(), {road_}, {.speed = speed, .input = {}});
        vehicle->restore(rest.motion, rest.state, rest.input);
        world.addAction(vehicle.get());
    }
    ~TreadCar() {
        world_.removeAction(vehicle.get());
        world_.removeRigidBody(&chassis_);
    }
    TreadCar(const TreadCar&) = delete;
    TreadCar& operator=(const TreadCar&) = delete;

    btRigidBody& chassis() { return chassis_; }
    std::unique_ptr<BulletVehicle> vehicle;

private:
    btBoxShape shape_;
    btRigidBody chassis_;
    BulletRoad road_;
    btDiscreteDynamicsWorld& world_;
};

// Bullet's stock vehicle of the same size, as its demos set it up.
class StockCar {
public:
    StockCar(btDiscreteDynamicsWorld& world, const VehicleParams& params, double speed)
        : shape_(btVector3(2, 0.8, 0.25)), raycaster_(&world), world_(world) {
        btVector3 inertia;
        shape_.calculateLocalInertia(params.mass, inertia);
        chassis_ = std::make_unique<btRigidBody>(params.mass, nullptr, &shape_, inertia);
        chassis_->setActivationState(DISABLE_DEACTIVATION);
        chassis_->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 0.54)));
        chassis_->setLinearVelocity(btVector3(speed, 0, 0));
        world.addRigidBody(chassis_.get());

        btRaycastVehicle::btVehicleTuning tuning;
        tuning.m_suspensionStiffness = 40;
        tuning.m_frictionSlip = 1;
        tuning.m_maxSuspensionForce = 1e5;
        vehicle = std::make_unique<btRaycastVehicle>(tuning, chassis_.get(), &raycaster_);
        vehicle->setCoordinateSystem(1, 2, 0);
        constexpr btScalar kRestLength = 0.3, kRadius = 0.3;
        for (const double x : {1.3, -1.3}) {
            for (const double y : {0.75, -0.75}) {
                vehicle->addWheel(btVector3(x, y, 0.05), btVector3(0, 0, -1), btVector3(0, 1, 0), kRestLength, kRadius,
                                  tuning, x > 0);
            }
        }
        world.addVehicle(vehicle.get());
    }
    ~StockCar() {
        world_.removeVehicle(vehicle.get());
        world_.removeRigidBody(chassis_.get());
    }
    StockCar(const StockCar&) = delete;
    StockCar& operator=(const StockCar&) = delete;

    btRigidBody& chassis() { return *chassis_; }
    std::unique_ptr<btRaycastVehicle> vehicle;

private:
    btBoxShape shape_;
    std::unique_ptr<btRigidBody> chassis_;
    btDefaultVehicleRaycaster raycaster_;
    btDiscreteDynamicsWorld& world_;
};

}  // namespace tread::shared
