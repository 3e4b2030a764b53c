// A game's own vehicle class whose chassis is a member that is built after the vehicle: the vehicle is given the
// address of a body that does not exist yet, and must not look at it before its first use.
#include "port.h"

namespace {

using namespace port;

class Truck {
public:
    explicit Truck(World& world)
        : world_(world),
          shape_(numbers_.half),
          raycaster_(&world.dynamics),
          vehicle_(numbers_.tuning(), &chassis, &raycaster_),
          chassis(chassisInfo(numbers_.mass, shape_, vector(0, numbers_.height(), 0))) {
        chassis.setActivationState(DISABLE_DEACTIVATION);
        world_.dynamics.addRigidBody(&chassis);
        world_.dynamics.addVehicle(&vehicle_);
        addWheels(vehicle_, numbers_);
    }
    ~Truck() {
        world_.dynamics.removeVehicle(&vehicle_);
        world_.dynamics.removeRigidBody(&chassis);
    }
    Truck(const Truck&) = delete;
    Truck& operator=(const Truck&) = delete;

    void drive(double force) {
        for (int i = 0; i < 4; ++i) vehicle_.applyEngineForce(scalar(0.25 * force), i);
    }
    double rest() const { return numbers_.rest; }

private:
    World& world_;
    CarNumbers numbers_;
    btBoxShape shape_;
    btDefaultVehicleRaycaster raycaster_;
    Vehicle vehicle_;

public:
    btRigidBody chassis;  // after the vehicle
};

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    World world;
    world.addPlane();
    Truck truck(world);
    world.run(2);
    report.near("height_m", truck.chassis.getCenterOfMassPosition().y(), 0.02 * truck.rest());
    truck.drive(3000);
    world.run(3);
    // As in z_up.cpp: what rolls and spins takes up to 8 %.
    report.like("speed_m_s", truck.chassis.getLinearVelocity().z(), 0.08);
    return report.status();
}
