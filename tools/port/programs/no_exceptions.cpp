// Compiled with -std=c++17 -fno-exceptions -fno-rtti, as many games are: a raycaster of its own, and on tread a
// function that says where there is ice.
#include "port.h"

#if defined(__cpp_exceptions) || defined(__cpp_rtti) || __cplusplus != 201703L
#error "compile this program as C++17 with -fno-exceptions -fno-rtti"
#endif

namespace {

using namespace port;

// Sees static bodies only.
class StaticOnly : public btVehicleRaycaster {
public:
    explicit StaticOnly(btDynamicsWorld& world) : world_(world) {}
    void* castRay(const btVector3& from, const btVector3& to, btVehicleRaycasterResult& result) override {
        btCollisionWorld::ClosestRayResultCallback hit(from, to);
        hit.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
        world_.rayTest(from, to, hit);
        if (!hit.hasHit()) return nullptr;
        result.m_hitPointInWorld = hit.m_hitPointWorld;
        result.m_hitNormalInWorld = hit.m_hitNormalWorld.normalized();
        result.m_distFraction = hit.m_closestHitFraction;
        return const_cast<btCollisionObject*>(hit.m_collisionObject);
    }

private:
    btDynamicsWorld& world_;
};

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    World world;
    world.addPlane();
    const CarNumbers n;
    btBoxShape shape(n.half);
    btRigidBody chassis(chassisInfo(n.mass, shape, vector(0, n.height(), 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);
    StaticOnly raycaster(world.dynamics);
    Vehicle vehicle(n.tuning(), &chassis, &raycaster);
    world.dynamics.addVehicle(&vehicle);
    addWheels(vehicle, n);
#ifndef PORT_STOCK
    int asked = 0;
    vehicle.setSurface([&asked](const tread::SurfaceQuery& query) {
        ++asked;
        const bool ice = query.point.z() > 20;
        return tread::Surface{ice ? 0.2 : 1.0, 0, ice ? "ice" : "asphalt"};
    });
#endif
    world.run(2);
    report.near("height_m", chassis.getCenterOfMassPosition().y(), 0.02 * n.rest);

    chassis.setLinearVelocity(vector(0, 0, 20));
    world.run(1.5);
    for (int i = 0; i < 4; ++i) vehicle.setBrake(1000, i);
    world.run(0.3);
    const double before = chassis.getLinearVelocity().z();
    world.run(1);
    const double braking = (before - static_cast<double>(chassis.getLinearVelocity().z())) / kGravity;
    // Wheels are locked on ice of 0.2 times the tyre's friction of 1: sliding holds no more than that, and at least
    // half.
    report.within("braking_on_ice_g", braking, 0.1, 0.21);
#ifndef PORT_STOCK
    report.within("asked", asked, 1, 1e9);
    report.within("on_ice", std::strcmp(vehicle.surfaceName(0), "ice") == 0, 1, 1);
#endif

    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    return report.status();
}
