// A class of the game's own, derived from the vehicle: it counts and limits, and calls what it overrides. The port is
// the name of the base class in its head; `btRaycastVehicle::` within it means tread's class by then.
#include "port.h"

namespace {

using namespace port;

class GameCar : public Vehicle {  // in the game: public btRaycastVehicle
public:
    GameCar(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster)
        : btRaycastVehicle(tuning, chassis, raycaster) {}

    void updateAction(btCollisionWorld* world, btScalar step) override {
        ++actions;
        btRaycastVehicle::updateAction(world, step);
    }
    void updateVehicle(btScalar step) override {
        ++steps;
        btRaycastVehicle::updateVehicle(step);
    }
    // Not virtual: it holds where the game has a GameCar.
    void setSteeringValue(btScalar angle, int wheel) {
        const btScalar most = scalar(0.3);
        btRaycastVehicle::setSteeringValue(std::clamp(angle, -most, most), wheel);
    }
    int actions = 0;
    int steps = 0;
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
    btDefaultVehicleRaycaster raycaster(&world.dynamics);
    GameCar car(n.tuning(), &chassis, &raycaster);
    world.dynamics.addVehicle(&car);
    addWheels(car, n);

    world.run(2);
    report.near("height_m", chassis.getCenterOfMassPosition().y(), 0.02 * n.rest);
    report.near("actions", car.actions, 0);
    report.near("steps", car.steps, 0);
    car.setSteeringValue(1, 0);
    report.near("steering_rad", car.getSteeringValue(0), 0);
    car.setSteeringValue(0, 0);

    // The override reaches tread: stock brakes along the wheel without limit, a tyre of friction 1 at about 1 g (rubber
    // holds a little more at the lightly loaded rear, a little less at the front).
    chassis.setLinearVelocity(vector(0, 0, 25));
    world.run(0.5);
    for (int i = 0; i < 4; ++i) car.setBrake(5000, i);
    world.run(0.2);
    const double before = chassis.getLinearVelocity().z();
    world.run(0.5);
    report.within("braking_g", (before - static_cast<double>(chassis.getLinearVelocity().z())) / 0.5 / kGravity, 0.7,
                  1.1);
#ifndef PORT_STOCK
    double load = 0;
    for (int i = 0; i < 4; ++i) load += car.telemetry(i).load;
    report.within("load_over_weight", load / (n.mass * kGravity), 0.95, 1.05);
#endif

    world.dynamics.removeVehicle(&car);
    world.dynamics.removeRigidBody(&chassis);
    return report.status();
}
