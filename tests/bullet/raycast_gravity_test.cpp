// Load and grip come from the chassis' own gravity and mass, so that a car brakes at the same share of gravity on every
// planet and in every unit of length.

#include <gtest/gtest.h>

#include <cmath>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_gravity_test {
namespace {

using namespace scene;

constexpr double kMass = 1500;  // kg

// A car in a world of its own gravity, whose lengths are so many times a car's.
struct Planet {
    double gravity = kGravity;  // lengths per s2
    double length = 1;
    double substep = 0.02;

    // How much longer everything takes than under the earth's gravity in metres.
    double time() const { return std::sqrt(kGravity * length / gravity); }
    double speed() const { return length / time(); }
};

class Rover {
public:
    explicit Rover(const Planet& planet) : planet_(planet) {
        const double l = planet.length;
        world.dynamics.setGravity(vector(0, -planet.gravity, 0));
        world.addPlane();
        btVector3 inertia;
        shape_.setLocalScaling(vector(l, l, l));
        shape_.calculateLocalInertia(scalar(kMass), inertia);
        chassis = std::make_unique<btRigidBody>(scalar(kMass), nullptr, &shape_, inertia);
        chassis->setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, (0.6 - kSag) * l, 0)));
        chassis->setActivationState(DISABLE_DEACTIVATION);
        world.dynamics.addRigidBody(chassis.get());

        btRaycastVehicle::btVehicleTuning tuning;
        const double stiffness = planet.gravity / l / (4 * kSag);
        tuning.m_suspensionStiffness = scalar(stiffness);
        tuning.m_suspensionCompression = tuning.m_suspensionDamping = scalar(0.7 * std::sqrt(stiffness));
        tuning.m_maxSuspensionForce = scalar(1e9);
        tuning.m_frictionSlip = 1;
        vehicle = std::make_unique<RaycastVehicle>(tuning, chassis.get(), nullptr);
        world.dynamics.addVehicle(vehicle.get());
        vehicle->setCoordinateSystem(0, 1, 2);
        vehicle->setSubstep(planet.substep);
        for (int i = 0; i < 4; ++i) {
            const btVector3 at = vector((i % 2 == 0 ? 0.75 : -0.75) * l, 0, (i < 2 ? 1.35 : -1.35) * l);
            vehicle->addWheel(at, vector(0, -1, 0), vector(-1, 0, 0), scalar(0.3 * l), scalar(0.3 * l), tuning, i < 2);
        }
        settle();
    }
    ~Rover() {
        world.dynamics.removeVehicle(vehicle.get());
        world.dynamics.removeRigidBody(chassis.get());
    }

    void settle() { run(world, 3 * planet_.time(), 60); }

    // Mean deceleration over gravity with locked wheels, from 20 m/s on earth or what is like it.
    double brakes(double gravity) {
        chassis->setLinearVelocity(chassis->getLinearVelocity() + vector(0, 0, 20 * planet_.speed()));
        run(world, 0.3 * planet_.time(), 60);
        for (int i = 0; i < 4; ++i) vehicle->setBrake(scalar(2 * kMass * gravity / 60), i);
        run(world, 0.5 * planet_.time(), 60);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(vehicle->telemetry(i).spin, 0, 1e-6);
        const double before = chassis->getLinearVelocity().z();
        const double steps = std::max(1.0, std::round(0.8 * planet_.time() * 60));
        run(world, steps / 60, 60);
        const double after = chassis->getLinearVelocity().z();
        for (int i = 0; i < 4; ++i) vehicle->setBrake(0, i);
        return (before - after) / (steps / 60) / gravity;
    }

private:
    static constexpr double kSag = 0.16;  // m, of the suspension at rest, of a car in metres
    Planet planet_;
    btBoxShape shape_{vector(0.8, 0.25, 2)};

public:
    World world;
    std::unique_ptr<btRigidBody> chassis;
    std::unique_ptr<RaycastVehicle> vehicle;
};

double brakes(const Planet& planet) {
    Rover rover(planet);
    return rover.brakes(planet.gravity);
}

TEST(RaycastVehicleGravity, BrakesAtTheSameShareOfAny) {
    for (double substep : {0.02, 0.001}) {
        const double here = brakes({.substep = substep});
        EXPECT_NEAR(here, 0.84, 0.05) << "a locked tyre keeps four fifths of its peak friction, or a little more";
        for (double share : {0.1, 0.16, 0.38, 2.5, 10.0, 100.0})
            EXPECT_NEAR(brakes({.gravity = share * kGravity, .substep = substep}), here, 0.03 * here)
                << share << " g at " << substep << " s";
    }
}

TEST(RaycastVehicleGravity, BrakesInDecimetresAsInMetres) {
    for (double substep : {0.02, 0.001}) {
        const double here = brakes({.substep = substep});
        for (double share : {0.1, 1.0, 10.0})
            EXPECT_NEAR(brakes({.gravity = 10 * share * kGravity, .length = 10, .substep = substep}), here, 0.03 * here)
                << share << " g at " << substep << " s";
    }
}

// A car that is put on another planet.
TEST(RaycastVehicleGravity, MayChangeAsMassMay) {
    Rover rover({});
    const double here = rover.brakes(kGravity);
    rover.chassis->setGravity(vector(0, -0.38 * kGravity, 0));
    rover.chassis->setLinearVelocity(vector(0, 0, 0));
    rover.settle();
    EXPECT_NEAR(rover.brakes(0.38 * kGravity), here, 0.03 * here);
}

// Round a planet, where it changes in every step.
TEST(RaycastVehicleGravity, ThatChangesAllTheTimeIsRepeatedBitForBit) {
    Rover rover({.substep = 0.005});
    const auto drive = [&] {
        for (int step = 0; step < 120; ++step) {
            rover.chassis->setGravity(vector(0, -kGravity * (0.7 + 0.002 * step), 0));
            for (int i = 0; i < 4; ++i) rover.vehicle->applyEngineForce(4000, i);
            run(rover.world, 1.0 / 60, 60);
        }
        return rover.chassis->getCenterOfMassPosition();
    };
    drive();
    const RaycastSnapshot start = rover.vehicle->snapshot();
    const btVector3 first = drive();
    rover.vehicle->restore(start);
    const btVector3 second = drive();
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(first[axis], second[axis]);
}

// Some games pull their cars down by forces of their own.
TEST(RaycastVehicleGravity, OfNoneIsThatOfTheEarth) {
    Rover rover({});
    rover.chassis->setGravity(vector(0, 0, 0));
    rover.chassis->setLinearVelocity(vector(0, 0, 20));
    const double before = rover.chassis->getLinearVelocity().z();
    for (int i = 0; i < 4; ++i) rover.vehicle->setBrake(scalar(2 * kMass * kGravity / 60), i);
    for (int step = 0; step < 60; ++step) {
        rover.chassis->applyCentralForce(vector(0, -kMass * kGravity, 0));
        run(rover.world, 1.0 / 60, 60);
    }
    EXPECT_NEAR(rover.vehicle->telemetry(0).spin, 0, 1e-6);
    EXPECT_NEAR(before - static_cast<double>(rover.chassis->getLinearVelocity().z()), 0.85 * kGravity, 0.05 * kGravity);
}

}  // namespace
}  // namespace tread::raycast_gravity_test
