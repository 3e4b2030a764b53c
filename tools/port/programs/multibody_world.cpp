// A vehicle in a world of Featherstone multibodies: it drives past a gate that swings, and pushes open another one.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "port.h"

namespace {

using namespace port;

// A gate 2 m long on a hinge about y, at rest across the way.
class Gate {
public:
    Gate(btMultiBodyDynamicsWorld& world, const btVector3& hinge) : world_(world), body_(1, 0, inertia(), true, false) {
        btTransform place = btTransform::getIdentity();
        place.setOrigin(hinge);
        body_.setBaseWorldTransform(place);
        body_.setupRevolute(0, kMass, inertia(), -1, btQuaternion::getIdentity(), vector(0, 1, 0), vector(0, 0, 0),
                            vector(1, 0, 0), true);
        body_.finalizeMultiDof();
        world_.addMultiBody(&body_);
        collider_.setCollisionShape(&shape_);
        btTransform middle = place;
        middle.setOrigin(hinge + vector(1, 0, 0));
        collider_.setWorldTransform(middle);
        world_.addCollisionObject(&collider_);
        body_.getLink(0).m_collider = &collider_;
    }
    ~Gate() {
        world_.removeCollisionObject(&collider_);
        world_.removeMultiBody(&body_);
    }
    Gate(const Gate&) = delete;
    Gate& operator=(const Gate&) = delete;
    void swing(double rate) { body_.setJointVel(0, scalar(rate)); }
    double angle() const { return body_.getJointPos(0); }

private:
    static constexpr btScalar kMass = 20;
    static btVector3 inertia() { return vector(0.5, 7, 7); }  // of a bar of 20 kg and 2 m
    btMultiBodyDynamicsWorld& world_;
    btBoxShape shape_{vector(0.95, 0.1, 0.05)};
    btMultiBody body_;
    btMultiBodyLinkCollider collider_{&body_, 0};
};

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btMultiBodyConstraintSolver solver;
    btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(vector(0, -kGravity, 0));
    btStaticPlaneShape plane(vector(0, 1, 0), 0);
    btRigidBody ground(0, nullptr, &plane);
    world.addRigidBody(&ground);
    {
        const CarNumbers n;
        Car car(world, n);
        Gate beside(world, vector(3, 0.7, 5)), across(world, vector(-1.5, 0.6, 12));
        beside.swing(1);
        const auto run = [&](double seconds) {
            for (int i = 0; i < static_cast<int>(60 * seconds); ++i) world.stepSimulation(scalar(1.0 / 60), 0);
        };
        run(2);
        report.near("height_m", car.height(), 0.02 * n.rest);
        // As in z_up.cpp: what rolls and spins takes up to 8 %.
        car.push(3000);
        run(2.5);
        report.like("speed_m_s", car.speed(), 0.08);
        // Past the gates, of which one has swung on its own and one was pushed open: it weighs little beside the car.
        run(2.5);
        report.near("beside_rad", beside.angle(), 0.001);
        report.like("across_rad", across.angle(), 0.1);
        report.like("after_speed_m_s", car.speed(), 0.1);
        report.within("upright", car.upright(), 0.999, 1);
    }
    world.removeRigidBody(&ground);
    return report.status();
}
