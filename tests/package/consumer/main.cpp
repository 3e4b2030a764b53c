// A car in a Bullet world as a game would have it: loaded from its file, put on a plane, driven for a second with the
// wheel turned to the left. Checks that it went where such a car goes.
#include <btBulletDynamicsCommon.h>
#include <tread/bullet_vehicle.h>
#include <tread/car_fleet.h>  // not used: that it compiles from what is installed is the test
#include <tread/equilibrium.h>
#include <tread/load.h>
#include <tread/raycast_fleet.h>  // nor is this one
#include <tread/road_surface.h>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

struct FlatGround : tread::Road {
    tread::RoadContact contact(const tread::Vector3&, std::size_t) const override { return {}; }
};

struct World {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld dynamics{&dispatcher, &broadphase, &solver, &configuration};
};

bool within(const char* name, double value, double lowest, double highest) {
    const bool good = value >= lowest && value <= highest;
    std::printf("%-14s %10.5f, expected %g to %g%s\n", name, value, lowest, highest, good ? "" : "  <-- WRONG");
    return good;
}

bool drive(const char* vehicle_file) {
    // The car, rolling steadily at 20 m/s.
    constexpr double kSpeed = 20;                 // m/s
    constexpr double kSteer = 0.3;                // rad at the steering wheel
    constexpr btScalar kStep = btScalar(1) / 60;  // s
    const tread::VehicleParams params = tread::loadVehicle(vehicle_file);
    FlatGround ground;
    World world;
    world.dynamics.setGravity(btVector3(0, 0, btScalar(-tread::kStandardGravity)));
    btBoxShape shape(btVector3(2, btScalar(0.8), btScalar(0.3)));
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape));
    world.dynamics.addRigidBody(&body);
    tread::BulletVehicle car(params, body, ground);
    const tread::Surroundings surroundings{ground};
    const tread::Equilibrium start = tread::equilibrium(car.vehicle(), surroundings, {.speed = kSpeed});
    car.restore(start.motion, start.state, start.input);
    world.dynamics.addAction(&car);

    // One second, half of it straight.
    tread::VehicleInput input = start.input;
    for (int step = 0; step < 60; ++step) {
        if (step == 30) input.steering_wheel_angle = kSteer;
        car.setInput(input);
        world.dynamics.stepSimulation(kStep, 0);
    }
    world.dynamics.removeAction(&car);
    world.dynamics.removeRigidBody(&body);

    // It kept its speed, stands on its wheels and turns left, at most as tightly as wheels that do not slip would.
    const tread::VehicleOutput output = car.output();
    const double tightest = kSpeed * kSteer / params.steering.ratio / params.wheelbase;
    bool good = within("x [m]", output.chassis.x, 19.5, 20.1);
    good &= within("y [m]", output.chassis.y, 0.05, 0.5);
    good &= within("yaw rate [1/s]", output.chassis.yaw_rate, 0.5 * tightest, tightest);
    good &= within("height [m]", body.getCenterOfMassPosition().z(), params.centre_of_gravity_height - 0.02,
                   params.centre_of_gravity_height + 0.02);
    good &= within("load [1]",
                   (output.wheel.front_left.load + output.wheel.front_right.load + output.wheel.rear_left.load +
                    output.wheel.rear_right.load) /
                       (params.mass * tread::kStandardGravity),
                   0.9, 1.1);
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "usage: consumer VEHICLE\n"), 2;
    try {
        return drive(argv[1]) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
