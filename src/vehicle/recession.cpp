#include "vehicle/recession.h"

#include "vehicle/travel.h"

namespace tread {
namespace {

// Acceleration along x of the place where the wheel hangs on the body, less gravity.
double frameAcceleration(const BodyFrame& body, const Vehicle::Corner& corner) {
    const Vector3& w = body.motion.angular_velocity_B;
    const Vector3 acceleration =
        body.acceleration_B + body.angular_acceleration_B.cross(corner.hub_B) + w.cross(w.cross(corner.hub_B));
    return acceleration.x() - body.gravity_B.x();
}

}  // namespace

void advanceRecession(PerWheel<WheelState>& wheels, const Vehicle& vehicle, double dt) {
    if (!vehicle.recedes) return;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const SuspensionParams& suspension = suspensionOf(vehicle, i);
        if (suspension.longitudinal_compliance == 0) continue;
        advance(wheels[i].recession, suspension, vehicle.corners[i].unsprung_mass, dt);
    }
}

void recede(TyreMotion& motion, const Vehicle& vehicle, const Recession& recession, const WheelContact& contact) {
    if (!vehicle.recedes) return;
    motion.Vx += recession.rate * contact.forward_B.x();
    motion.Vsy -= recession.rate * contact.left_B.x();
}

void addRecession(Wrench& wrench, PerWheel<WheelState>& wheels, const Vehicle& vehicle,
                  const PerWheel<WheelContact>& contacts, const BodyFrame& end, double dt) {
    if (!vehicle.recedes) return;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const SuspensionParams& suspension = suspensionOf(vehicle, i);
        if (suspension.longitudinal_compliance == 0) continue;
        const Vehicle::Corner& corner = vehicle.corners[i];
        WheelState& wheel = wheels[i];
        const Vector3 road =
            wheel.fx * contacts[i].forward_B + wheel.fy * contacts[i].left_B + wheel.load * contacts[i].normal_B;
        const double push = road.x() / corner.unsprung_mass - frameAcceleration(end, corner);
        takePush(wheel.recession, suspension, corner.unsprung_mass, push, dt);
        wrench.add({-corner.unsprung_mass * wheel.recession.acceleration, 0, 0}, contacts[i].hub_B);
    }
}

}  // namespace tread
