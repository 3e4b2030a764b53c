// A game that steps its vehicle by hand: it calls updateVehicle after each step of a world that does not know the
// vehicle. And one that does so although the world steps it too: all forces act twice, on tread as on stock.
#include "port.h"

namespace {

using namespace port;

struct Figures {
    double height;  // m, at rest
    double way;     // m, driven in 3 s with 3 kN
    double rest;    // m, length of the suspension
};

Figures drive(bool by_world, bool by_hand) {
    World world;
    world.addPlane();
    const CarNumbers n;
    btBoxShape shape(n.half);
    btRigidBody chassis(chassisInfo(n.mass, shape, vector(0, n.height(), 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);
    btDefaultVehicleRaycaster raycaster(&world.dynamics);
    Vehicle vehicle(n.tuning(), &chassis, &raycaster);
    addWheels(vehicle, n);
    if (by_world) world.dynamics.addVehicle(&vehicle);
    const auto run = [&](double seconds) {
        for (int i = 0; i < static_cast<int>(60 * seconds); ++i) {
            world.step(60);
            if (by_hand) vehicle.updateVehicle(scalar(1.0 / 60));
        }
    };

    run(3);
    const double height = chassis.getCenterOfMassPosition().y(), from = chassis.getCenterOfMassPosition().z();
    for (int i = 0; i < 4; ++i) vehicle.applyEngineForce(scalar(0.25 * 3000), i);
    run(3);
    if (by_world) world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    return {height, static_cast<double>(chassis.getCenterOfMassPosition().z()) - from, n.rest};
}

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    const Figures world = drive(true, false), hand = drive(false, true), both = drive(true, true);
    report.near("world_height_m", world.height, 0.02 * world.rest);
    report.near("hand_height_m", hand.height, 0.02 * hand.rest);
    report.near("both_height_m", both.height, 0.02 * both.rest);
    // As in z_up.cpp: what rolls and spins takes up to 8 %; acting twice, of twice the way.
    report.like("world_way_m", world.way, 0.08);
    report.like("hand_way_m", hand.way, 0.08);
    report.like("both_way_m", both.way, 0.08);
    return report.status();
}
