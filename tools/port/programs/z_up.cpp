// A world with z up, in which cars look along x: gravity, setCoordinateSystem, wheel directions and axles say so.
#include "port.h"

int main(int arguments, char** argument) {
    using namespace port;
    Report report(arguments, argument);
    World world(vector(0, 0, -kGravity));
    world.addPlane(vector(0, 0, 1));

    const CarNumbers n;
    btBoxShape shape(vector(2, 0.8, 0.25));
    btRigidBody chassis(chassisInfo(n.mass, shape, vector(0, 0, n.height())));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);
    btDefaultVehicleRaycaster raycaster(&world.dynamics);
    Vehicle vehicle(n.tuning(), &chassis, &raycaster);
    vehicle.setCoordinateSystem(1, 2, 0);  // right (its direction is the axle's), up, forward
    world.dynamics.addVehicle(&vehicle);
    for (double forward : {1.35, -1.35})
        for (double left : {0.75, -0.75})
            vehicle.addWheel(vector(forward, left, 0), vector(0, 0, -1), vector(0, -1, 0), scalar(n.rest),
                             scalar(n.radius), n.tuning(), forward > 0);

    world.run(2);
    report.near("height_m", chassis.getCenterOfMassPosition().z(), 0.02 * n.rest);

    // 2 m/s2 for 3 s. Wheels weigh a twentieth of the car, which makes 3 % of inertia beside it; tyres roll at 1 % of
    // the weight, 0.1 m/s2: together up to 8 %.
    for (int i = 0; i < 4; ++i) vehicle.applyEngineForce(scalar(0.25 * 3000), i);
    world.run(3);
    report.like("speed_m_s", vehicle.getCurrentSpeedKmHour() / scalar(3.6), 0.08);
    report.like("way_m", chassis.getCenterOfMassPosition().x(), 0.08);
    report.near("aside_m", chassis.getCenterOfMassPosition().y(), 0.01);

    // To the left, over y, at 5 m/s: tyres slip by some tenths of a degree, of three.
    for (int i = 0; i < 4; ++i) vehicle.applyEngineForce(0, i);
    chassis.setLinearVelocity(vector(5, 0, 0));
    for (int i : {0, 1}) vehicle.setSteeringValue(scalar(0.05), i);
    world.run(2);
    const btVector3 velocity = chassis.getLinearVelocity();
    report.within("turn_1_m", chassis.getAngularVelocity().z() / velocity.length(), 0.8 * 0.05 / 2.7,
                  1.05 * 0.05 / 2.7);
    report.within("left_m", chassis.getCenterOfMassPosition().y(), 0.1, 10);
    report.within("wheel_axis_y", vehicle.getWheelTransformWS(3).getBasis().getColumn(1).y(), 0.9, 1);

    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    return report.status();
}
