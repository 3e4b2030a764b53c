// A raycaster of the game's own: the ground is a function of the place, and no collision object.
#include "port.h"

namespace {

using namespace port;

// Waves 0.5 m high and 63 m long, m.
double ground(double z) {
    return 0.5 * std::sin(0.1 * z);
}
double slope(double z) {
    return 0.05 * std::cos(0.1 * z);
}

class Waves : public btVehicleRaycaster {
public:
    // Down along y, as the wheels of a car that stands upright look. What is returned only says that there is
    // something.
    void* castRay(const btVector3& from, const btVector3& to, btVehicleRaycasterResult& result) override {
        ++asked;
        const auto above = [&](double at) {
            const btVector3 point = from + scalar(at) * (to - from);
            return static_cast<double>(point.y()) - ground(point.z());
        };
        if (above(0) < 0 || above(1) > 0) return nullptr;
        double low = 0, high = 1;
        for (int i = 0; i < 40; ++i) (above(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
        result.m_distFraction = scalar(high);
        result.m_hitPointInWorld = from + scalar(high) * (to - from);
        result.m_hitNormalInWorld = vector(0, 1, -slope(result.m_hitPointInWorld.z())).normalized();
        return this;
    }
    int asked = 0;
};

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    World world;
    const CarNumbers n;
    btBoxShape shape(n.half);
    btRigidBody chassis(chassisInfo(n.mass, shape, vector(0, ground(0) + n.height(), 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);
    Waves waves;
    Vehicle vehicle(n.tuning(), &chassis, &waves);
    world.dynamics.addVehicle(&vehicle);
    addWheels(vehicle, n);

    // At rest in the trough at z = -47.1 m, where the ground is level: it stands on its springs.
    const double trough = -47.124;
    chassis.setCenterOfMassTransform(
        btTransform(btQuaternion::getIdentity(), vector(0, ground(trough) + n.height(), trough)));
    for (int i = 0; i < 4; ++i) vehicle.setBrake(100, i);
    world.run(3);
    report.near("height_m", static_cast<double>(chassis.getCenterOfMassPosition().y()) - ground(trough), 0.02 * n.rest);

    // Over the waves: 3 kN for 3 s, then rolling. Way and height over ground are stock's, less what rolls and spins (as
    // in z_up.cpp).
    for (int i = 0; i < 4; ++i) {
        vehicle.setBrake(0, i);
        vehicle.applyEngineForce(scalar(750), i);
    }
    world.run(3);
    for (int i = 0; i < 4; ++i) vehicle.applyEngineForce(0, i);
    const double before = chassis.getCenterOfMassPosition().z();
    Range over_ground{10, -10};
    double off = 0;
    for (int i = 0; i < 300; ++i) {
        world.step(60);
        const btVector3 at = chassis.getCenterOfMassPosition();
        const double height = static_cast<double>(at.y()) - ground(at.z());
        over_ground = {std::min(over_ground.lowest, height), std::max(over_ground.highest, height)};
        for (int k = 0; k < 4; ++k) {
            const btVector3 contact = vehicle.getWheelInfo(k).m_raycastInfo.m_contactPointWS;
            off = std::max(off, std::abs(static_cast<double>(contact.y()) - ground(contact.z())));
        }
    }
    report.like("way_m", static_cast<double>(chassis.getCenterOfMassPosition().z()) - before, 0.1);
    // 5 m/s over a curvature of 0.005/m is 0.13 m/s2: a hundredth of the weight, 1 mm of spring.
    report.within("least_height_m", over_ground.lowest, n.height() - 0.03, n.height());
    report.within("most_height_m", over_ground.highest, n.height(), n.height() + 0.03);
    // Contacts lie on the ground that the raycaster gave, but for the step that the car has gone on by since: 0.1 m on
    // a slope of 5 %.
    report.within("contact_off_m", off, 0, 0.006);
    report.within("asked", waves.asked, 4 * 60 * 11, 1e9);

    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    return report.status();
}
